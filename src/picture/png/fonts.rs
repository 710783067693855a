//! Fonts of pictures as PNG: the one that this program brings, and those of the machine for what it does not have.

use std::sync::Arc;

use resvg::usvg::fontdb::{Database, FaceInfo, ID, Source, Stretch, Style as FaceStyle};
use resvg::usvg::{Font, FontFamily, FontResolver, FontStyle};
use skrifa::instance::{LocationRef, Size};
use skrifa::outline::{DrawSettings, OutlinePen};
use skrifa::{FontRef, MetadataProvider};

/// Fonts that have a form for every character, which tells nothing.
const FORMLESS: [&str; 3] = ["LastResort", "Adobe NotDef", "Adobe Blank"];

/// How a text is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Style {
    Regular,
    Bold,
    Oblique,
}

/// From this weight on letters are bold.
const BOLD: u16 = 600;

impl Style {
    pub fn new(weight: u16, slanted: bool) -> Self {
        match (weight >= BOLD, slanted) {
            (true, _) => Self::Bold,
            (false, true) => Self::Oblique,
            (false, false) => Self::Regular,
        }
    }

    fn weight(self) -> u16 {
        if self == Self::Bold { 700 } else { 400 }
    }
}

/// A font of the machine, or another style of our own, in which a part of a text is set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Substitute(usize);

/// What the names of families begin with that stand for a substitute.
const SUBSTITUTE: &str = "mo-copp-substitute-";

impl Substitute {
    /// The family by which an SVG names it.
    pub fn family(self) -> String {
        format!("{SUBSTITUTE}{}", self.0)
    }
}

/// The fonts there are.
pub(super) struct Fonts {
    database: Database,
    /// By [`Style`].
    own: [ID; 3],
    /// The fonts of the machine, once a text asked for them.
    machine: Option<Vec<ID>>,
    substitutes: Vec<ID>,
}

impl Fonts {
    pub fn new() -> Self {
        let mut database = Database::new();
        let own = [dejavu::sans::regular(), dejavu::sans::bold(), dejavu::sans::oblique()];
        let own = own.map(|data| {
            let ids = database.load_font_source(Source::Binary(Arc::new(data)));
            ids.first().copied().unwrap_or_else(ID::dummy)
        });
        Self { database, own, machine: None, substitutes: Vec::new() }
    }

    /// Whether the program's own font has all of these characters.
    pub fn own_has(&self, style: Style, characters: &[char]) -> bool {
        self.has(self.own[style as usize], characters)
    }

    /// Another font that has all of these characters.
    pub fn substitute(&mut self, style: Style, characters: &[char]) -> Option<Substitute> {
        let regular = self.own[Style::Regular as usize];
        let id = if self.has(regular, characters) {
            regular
        } else {
            let faces = self.machine(style);
            faces.into_iter().find(|&id| self.has(id, characters))?
        };
        let known = self.substitutes.iter().position(|&substitute| substitute == id);
        Some(Substitute(known.unwrap_or_else(|| {
            self.substitutes.push(id);
            self.substitutes.len() - 1
        })))
    }

    /// The faces of the machine's fonts, those first that suit a picture: upright, not condensed, of the text's weight.
    fn machine(&mut self, style: Style) -> Vec<ID> {
        if self.machine.is_none() {
            self.database.load_system_fonts();
        }
        let own = self.own;
        let faces = self.machine.get_or_insert_with(|| {
            let faces = self.database.faces().filter(|face| !own.contains(&face.id));
            faces.filter(|face| !FORMLESS.contains(&family(face))).map(|face| face.id).collect()
        });
        let mut faces: Vec<ID> = faces.clone();
        // By name at last, for folders list their files in any order.
        faces.sort_by_cached_key(|&id| {
            self.database.face(id).map(|face| {
                (
                    face.style != FaceStyle::Normal,
                    face.stretch != Stretch::Normal,
                    face.monospaced,
                    family(face).to_owned(),
                    face.weight.0.abs_diff(style.weight()),
                    face.post_script_name.clone(),
                )
            })
        });
        faces
    }

    fn has(&self, id: ID, characters: &[char]) -> bool {
        let has = |data: &[u8], index| {
            let Ok(font) = FontRef::from_index(data, index) else { return false };
            characters.iter().all(|&character| has_form(&font, character))
        };
        self.database.with_face_data(id, has).unwrap_or(false)
    }

    /// The fonts as the renderer takes them: which one a text is set in is settled here.
    pub fn into_resolver(self) -> (Arc<Database>, FontResolver<'static>) {
        let Self { database, own, substitutes, .. } = self;
        let select = move |font: &Font, _: &mut Arc<Database>| {
            let style = Style::new(font.weight(), font.style() != FontStyle::Normal);
            let named = font.families().iter().find_map(|family| match family {
                FontFamily::Named(name) => name.strip_prefix(SUBSTITUTE)?.parse::<usize>().ok(),
                _ => None,
            });
            named.and_then(|at| substitutes.get(at).copied()).or(Some(own[style as usize]))
        };
        let resolver = FontResolver {
            select_font: Box::new(select),
            select_fallback: Box::new(|_, _, _| None),
        };
        (Arc::new(database), resolver)
    }
}

fn family(face: &FaceInfo) -> &str {
    face.families.first().map_or("", |(name, _)| name)
}

/// Whether a font draws something for a character, or knows it as a space.
fn has_form(font: &FontRef<'_>, character: char) -> bool {
    let Some(glyph) = font.charmap().map(character) else { return false };
    if character.is_whitespace() || font.color_glyphs().get(glyph).is_some() {
        return true;
    }
    let mut seen = Seen(false);
    if let Some(outline) = font.outline_glyphs().get(glyph) {
        let settings = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
        // A broken outline has no form.
        let _ = outline.draw(settings, &mut seen);
    }
    seen.0 || font.bitmap_strikes().iter().any(|strike| strike.get(glyph).is_some())
}

/// Whether an outline has lines.
struct Seen(bool);

impl OutlinePen for Seen {
    fn move_to(&mut self, _: f32, _: f32) {}
    fn line_to(&mut self, _: f32, _: f32) {
        self.0 = true;
    }
    fn quad_to(&mut self, _: f32, _: f32, _: f32, _: f32) {
        self.0 = true;
    }
    fn curve_to(&mut self, _: f32, _: f32, _: f32, _: f32, _: f32, _: f32) {
        self.0 = true;
    }
    fn close(&mut self) {}
}
