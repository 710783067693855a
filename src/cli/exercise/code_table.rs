//! Tables of answer codes, as spreadsheets and course systems save them: their encoding, their separator, their columns.

use std::collections::BTreeSet;

use mo_copp::exercise::code::is_whole;

use super::cell::Cell;
use super::encoding::{decode, named_separator, printable};
use super::records::{Record, Records, Wanted};

/// What may stand between two fields.
const SEPARATORS: [u8; 3] = [b',', b';', b'\t'];

/// A table whose first line names its columns, one of which holds the codes.
#[derive(Debug)]
pub struct CodeTable {
    /// The sign between two fields.
    pub separator: u8,
    /// The names of the columns.
    pub head: Vec<String>,
    /// The rows.
    pub rows: Vec<Row>,
    code: usize,
    seed: Option<usize>,
}

/// A row of the table.
#[derive(Debug)]
pub struct Row {
    /// The line at which it begins.
    pub line: u64,
    /// A field for each column.
    pub fields: Vec<String>,
    /// Why its fields cannot be told to columns.
    pub broken: Option<String>,
    /// What should be looked at in it, though it can be read.
    pub remark: Option<String>,
}

impl CodeTable {
    /// Reads a table. The codes are in the column of the name that is given; without one, in that called `code`, else in the
    /// only one that has any.
    ///
    /// # Errors
    ///
    /// The line and what is wrong with it, where there is no such column, or where two have a name that is looked for.
    pub fn read(bytes: &[u8], named_code: Option<&str>) -> Result<Self, (u64, String)> {
        let text = decode(bytes);
        let named = named_separator(&text);
        let (text, lines_before) = named.map_or((&*text, 0), |(_, after)| (after, 1));
        let separators = match named {
            Some((separator, _)) => vec![separator],
            None => SEPARATORS.to_vec(),
        };
        let wanted = named_code.unwrap_or("code");
        let records = |separator| Records::new(text, separator).after(lines_before);
        // A table without such a name has the separator that makes the most columns of its first line.
        let mut most: Option<(u8, Vec<String>)> = None;
        for separator in separators {
            let mut records = records(separator);
            let head = head_of(&mut records);
            if let Some(code) = column(&head, wanted)? {
                return Self::with_codes_in(code, head, records, separator);
            }
            if most.as_ref().is_none_or(|(_, seen)| head.len() > seen.len()) {
                most = Some((separator, head));
            }
        }
        let line = lines_before + 1;
        let (separator, head) = most.unwrap_or_default();
        if named_code.is_some() {
            return Err((line, format!("found {:?}, expected a column {wanted}", head.join(","))));
        }
        let columns = columns_with_codes(records(separator));
        if let [code] = columns[..] {
            let mut records = records(separator);
            records.next();
            return Self::with_codes_in(code, head, records, separator);
        }
        let found = match &columns[..] {
            [] => format!("{:?}", head.join(",")),
            several => {
                let names: Vec<&str> = several.iter().map(|&place| &head[place][..]).collect();
                format!("codes in {} columns, {}", several.len(), names.join(" and "))
            }
        };
        Err((line, format!("found {found}, expected a column code, or its name after --code")))
    }

    fn with_codes_in(
        code: usize,
        head: Vec<String>,
        records: Records<'_>,
        separator: u8,
    ) -> Result<Self, (u64, String)> {
        let seed = column(&head, "seed")?;
        let records = records.with_rows(Wanted { columns: head.len(), code });
        let rows = records.map(|record| row(record, &head, code, separator)).collect();
        Ok(Self { separator, head, rows, code, seed })
    }

    /// The column of a name.
    ///
    /// # Errors
    ///
    /// The first line, where no column has the name, or more than one.
    pub fn column(&self, name: &str) -> Result<usize, (u64, String)> {
        let missing = || (1, format!("found {:?}, expected a column {name}", self.head.join(",")));
        column(&self.head, name)?.ok_or_else(missing)
    }

    /// The code of a row.
    pub fn code<'a>(&self, row: &'a Row) -> &'a str {
        &row.fields[self.code]
    }

    /// The seed in a row, where it has one.
    ///
    /// # Errors
    ///
    /// What was found in place of a number.
    pub fn seed(&self, row: &Row) -> Result<Option<u64>, String> {
        let text = self.seed.map_or("", |column| row.fields[column].trim());
        if text.is_empty() {
            return Ok(None);
        }
        let wrong = |_| format!("found the seed {text:?}, expected a whole number or nothing");
        text.parse().map(Some).map_err(wrong)
    }
}

/// The names of the columns.
fn head_of(records: &mut Records<'_>) -> Vec<String> {
    records.next().map_or_else(Vec::new, |record| shown(&record.fields))
}

/// The columns in which a code stands.
fn columns_with_codes(mut records: Records<'_>) -> Vec<usize> {
    let mut columns = BTreeSet::new();
    let width = head_of(&mut records).len();
    for record in records {
        let fields = record.fields.iter().enumerate().take(width);
        let has_code =
            |field: &String| matches!(Cell::read(field), Cell::Code(code) if is_whole(&code));
        columns.extend(fields.filter(|(_, field)| has_code(field)).map(|(place, _)| place));
    }
    columns.into_iter().collect()
}

/// Fields as they are printed.
fn shown(fields: &[String]) -> Vec<String> {
    fields.iter().map(|field| printable(field)).collect()
}

/// Whether two names are of one column, whatever their capitals and blanks.
pub fn is_same(name: &str, other: &str) -> bool {
    name.trim().to_lowercase() == other.trim().to_lowercase()
}

/// The column of a name. Which of several is meant, nothing says.
fn column(head: &[String], wanted: &str) -> Result<Option<usize>, (u64, String)> {
    let mut places = (0..head.len()).filter(|&place| is_same(&head[place], wanted));
    let found = (places.next(), places.count());
    match found {
        (place, 0) => Ok(place),
        (_, more) => Err((1, format!("found {} columns {wanted}, expected one", more + 1))),
    }
}

/// A row with a field for each column. Fields that are empty may be missing or too many.
fn row(record: Record, head: &[String], code: usize, separator: u8) -> Row {
    let Record { line, fields, is_open, like_rows } = record;
    let mut fields = shown(&fields);
    while fields.len() > head.len() && fields.last().is_some_and(|field| field.trim().is_empty()) {
        fields.pop();
    }
    let found = fields.len();
    let fits = found <= head.len() && found > code;
    if found > head.len() {
        let rest = fields.split_off(head.len() - 1);
        fields.push(rest.join(&char::from(separator).to_string()));
    }
    fields.resize(head.len(), String::new());
    let broken = if is_open {
        Some(format!("a quotation mark in line {line} is not closed"))
    } else if fits {
        None
    } else {
        let word = if found == 1 { "field" } else { "fields" };
        Some(format!("the row has {found} {word}, expected {}", head.len()))
    };
    let remark = like_rows.map(|(begin, last)| {
        format!(
            "a quotation mark in line {begin} is closed in line {last}; if these lines are rows, it is a stray one"
        )
    });
    Row { line, fields, broken, remark }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fields(bytes: &[u8]) -> Vec<Vec<String>> {
        CodeTable::read(bytes, None).unwrap().rows.into_iter().map(|row| row.fields).collect()
    }

    #[test]
    fn encodings_and_separators_of_spreadsheets_are_read() {
        let expected = vec![vec!["Zoë".to_owned(), "X-1".to_owned()]];
        for text in ["name,code\nZoë,X-1\n", "name;code\r\nZoë;X-1\r\n", "name\tcode\nZoë\tX-1"]
        {
            assert_eq!(fields(text.as_bytes()), expected);
            assert_eq!(fields(&[b"\xef\xbb\xbf", text.as_bytes()].concat()), expected);
            let wide = |order: fn(u16) -> [u8; 2]| -> Vec<u8> {
                "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(order).collect()
            };
            assert_eq!(fields(&wide(u16::to_le_bytes)), expected);
            assert_eq!(fields(&wide(u16::to_be_bytes)), expected);
        }
        assert_eq!(fields(b"name,code\nZo\xeb,X-1\n"), expected);
    }

    #[test]
    fn rows_of_other_lengths_are_kept_and_told() {
        let table = CodeTable::read(
            b"name,code,note\nAda,X\nAlan,Y,,\nLovelace, Ada,Z,\nBob\nCleo, A,X,hm\n",
            None,
        )
        .unwrap();
        let broken: Vec<Option<&str>> =
            table.rows.iter().map(|row| row.broken.as_deref()).collect();
        assert_eq!(
            broken,
            [
                None,
                None,
                None,
                Some("the row has 1 field, expected 3"),
                Some("the row has 4 fields, expected 3")
            ]
        );
        assert_eq!(table.rows[0].fields, ["Ada", "X", ""]);
        assert_eq!(table.rows[4].fields, ["Cleo", " A", "X,hm"]);
        assert_eq!(table.rows[4].line, 6);
    }

    #[test]
    fn a_quotation_mark_that_is_not_closed_breaks_one_row() {
        let broken = |text: &str| -> Vec<(u64, Vec<String>, bool)> {
            let rows = CodeTable::read(text.as_bytes(), None).unwrap().rows;
            rows.into_iter().map(|row| (row.line, row.fields, row.broken.is_some())).collect()
        };
        let row =
            |line, name: &str, is_broken| (line, vec![name.to_owned(), "X".to_owned()], is_broken);
        let (bob, cleo) = (row(3, "Bob", false), row(4, "Cleo", false));
        for end in ["\n", "\r\n", "\r"] {
            let of = |lines: [&str; 4]| broken(&lines.join(end));
            let ada = row(2, "\"Ada", true);
            let read = of(["name,code", "\"Ada,X", "Bob,X", "Cleo,X"]);
            assert_eq!(read, [ada.clone(), bob.clone(), cleo.clone()]);
            // A mark that begins another field does not close it, nor one inside of a field.
            let read = of(["name,code", "\"Ada,X", "Bob,X", "\"Cleo\",X"]);
            assert_eq!(read, [ada.clone(), bob.clone(), cleo.clone()]);
            let read = of(["name,code", "\"Ada,X", "Bo\"b,X", "Cleo,X"]);
            assert_eq!(read, [ada.clone(), row(3, "Bo\"b", false), cleo.clone()]);
            let read = of(["name,code", "\"Ada,X", "\"Bob,X", "Cleo,X"]);
            assert_eq!(read, [ada, row(3, "\"Bob", true), cleo.clone()]);
            let read = of(["name,code", "Ada \"A\",X", "\"Bob\",\"X\"", "Cleo,X"]);
            assert_eq!(read, [row(2, "Ada \"A\"", false), bob.clone(), cleo.clone()]);
            // Fields may run over line ends, and have marks of their own.
            let read = of(["name,code", "\"A \"\"d\"\"", "a\",X", "Cleo,X"]);
            assert_eq!(read, [row(2, &format!("A \"d\"{end}a"), false), cleo.clone()]);
        }
        assert_eq!(broken("name,code\n\"Ada,X"), [row(2, "\"Ada", true)]);
        assert_eq!(broken("name,code\n\n\nCleo,X\n\n"), [cleo]);
    }

    #[test]
    fn a_table_without_codes_is_told_by_its_head() {
        assert_eq!(
            CodeTable::read(b"name;answer\n", None).unwrap_err(),
            (
                1,
                "found \"name,answer\", expected a column code, or its name after --code"
                    .to_owned()
            )
        );
        assert_eq!(CodeTable::read(b"", None).unwrap_err().0, 1);
    }
}
