//! Goal-recognition problems for other programs: files in, a document out.

use serde::Serialize;

use crate::document::DocumentError;
use crate::document::json::Json;
use crate::document::reader::{Fields, Reader};
use crate::domain::Document;
use crate::domain::pddl::import::{ImportError, ImportFile, ImportOptions, import};

/// What the import of files gives.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ImportReport {
    /// The document, as JSON text.
    pub document: String,
    /// The actions of `obs.dat`, which may be a whole plan or some of one; null where there is no such file.
    pub observations: Option<Vec<String>>,
    /// What was left out of the files.
    pub notes: Vec<String>,
}

impl ImportReport {
    /// Imports files.
    ///
    /// # Errors
    ///
    /// [`ImportError`] with the place of what cannot be read.
    pub fn new(files: &[ImportFile], options: &ImportOptions) -> Result<Self, ImportError> {
        let imported = import(files, options)?;
        Ok(Self {
            document: Document::from(imported.document).to_json(),
            observations: imported.observations,
            notes: imported.notes,
        })
    }
}

/// Files written as a JSON list of `{"name", "text"}`, as the JavaScript API takes them.
///
/// # Errors
///
/// [`DocumentError`] with the place.
///
/// ```
/// let files = mo_copp::report::read_import_files(r#"[{"name": "hyps.dat", "text": ""}]"#)?;
/// assert_eq!(files[0].name, "hyps.dat");
/// # Ok::<(), mo_copp::document::DocumentError>(())
/// ```
pub fn read_import_files(text: &str) -> Result<Vec<ImportFile>, DocumentError> {
    let json = Json::parse(text)?;
    Reader::of("files", &json).list(|file| {
        let fields = file.fields(&["name", "text"])?;
        let text = |key, expected| {
            let reader = fields.required(key, expected)?;
            match reader.value() {
                Json::Text(text) => Ok(text.to_string()),
                _ => Err(reader.expected("a text")),
            }
        };
        Ok(ImportFile { name: text("name", "the file's name")?, text: text("text", "its text")? })
    })
}

/// Options written as a JSON object, as the JavaScript API takes them; what is left out is as in
/// [`ImportOptions::default`].
///
/// # Errors
///
/// [`DocumentError`] with the option, what was given and what would do.
pub fn read_import_options(text: &str) -> Result<ImportOptions, DocumentError> {
    const KEYS: [&str; 5] = [
        "adversarial_sensor",
        "cooperative_sensor",
        "adversarial_groups",
        "cooperative_groups",
        "true_goal",
    ];
    let json = Json::parse(text)?;
    let fields = Reader::of("options", &json).fields(&KEYS)?;
    let mut options = ImportOptions::default();
    if let Some(sensor) = fields.optional("adversarial_sensor") {
        sensor.text()?.clone_into(&mut options.adversarial_sensor);
    }
    if let Some(sensor) = fields.optional("cooperative_sensor") {
        sensor.text()?.clone_into(&mut options.cooperative_sensor);
    }
    options.adversarial_groups = groups(&fields, "adversarial_groups")?;
    options.cooperative_groups = groups(&fields, "cooperative_groups")?;
    if let Some(number) = fields.optional("true_goal") {
        options.true_goal = Some(number.integer(1..=u32::MAX)? as usize);
    }
    Ok(options)
}

fn groups(fields: &Fields<'_>, key: &str) -> Result<Vec<(String, Vec<String>)>, DocumentError> {
    let Some(groups) = fields.optional(key) else { return Ok(Vec::new()) };
    let text = |reader: &Reader<'_>| reader.text().map(str::to_owned);
    let group = |(name, objects): (&str, Reader<'_>)| Ok((name.to_owned(), objects.list(text)?));
    groups.entries()?.all().map(group).collect()
}
