//! Records of a text whose fields have separators between them: fields in quotation marks, and marks that stand there by mistake.

use std::ops::Range;

use mo_copp::exercise::code::is_like_code;

/// A record of a text, before its fields are told to columns.
#[derive(Debug)]
pub struct Record {
    /// The line at which it begins.
    pub line: u64,
    /// Its fields, without the marks around them.
    pub fields: Vec<String>,
    /// Whether a quotation mark begins a field that no other ends.
    pub is_open: bool,
    /// The first and the last line of a field in which there are lines with as many fields as a row has.
    pub like_rows: Option<(u64, u64)>,
}

/// What the rows of a table look like.
#[derive(Debug, Clone, Copy)]
pub struct Wanted {
    /// How many columns there are.
    pub columns: usize,
    /// Which of them has the codes.
    pub code: usize,
}

/// The records of a text, one after another. A field in quotation marks may run over line ends; where its closing mark is
/// missing, stands inside of a later field or in another row, the record is its first line, and the marks in it are signs
/// like others.
#[derive(Debug)]
pub struct Records<'t> {
    rest: &'t str,
    line: u64,
    separator: u8,
    wanted: Option<Wanted>,
}

impl<'t> Records<'t> {
    /// The records of a text.
    pub fn new(text: &'t str, separator: u8) -> Self {
        Self { rest: text, line: 1, separator, wanted: None }
    }

    /// The same, where lines before the text belong to it.
    pub fn after(self, lines: u64) -> Self {
        Self { line: self.line + lines, ..self }
    }

    /// The same; those that follow are rows like this.
    pub fn with_rows(self, wanted: Wanted) -> Self {
        Self { wanted: Some(wanted), ..self }
    }

    /// What is in the lines over which fields of a record run.
    fn lines_across(&self, text: &str, record: &Extent) -> Across {
        let Some(wanted) = self.wanted else { return Across::Text };
        let mut across = Across::Text;
        for (place, field) in &record.across {
            let inside = text.get(field.clone()).unwrap_or_default();
            if *place == wanted.code && (is_like_code(inside) || inside.trim().is_empty()) {
                continue;
            }
            let mut begin = 0;
            while begin < field.end {
                let end = line_end(text, begin);
                match self.lines_like_row(&text[begin..end], begin, wanted, field) {
                    Across::Rows => return Across::Rows,
                    Across::Doubtful => across = Across::Doubtful,
                    Across::Text => {}
                }
                begin = end;
            }
        }
        across
    }

    /// Whether a line, which begins at a place of the record, would be a row whose code stands in the field.
    fn lines_like_row(
        &self,
        line: &str,
        begin: usize,
        wanted: Wanted,
        field: &Range<usize>,
    ) -> Across {
        let separator = char::from(self.separator);
        let content = line.trim_end_matches(['\r', '\n']);
        let parts: Vec<&str> = content.split(separator).collect();
        let Some(code) = parts.get(wanted.code) else { return Across::Text };
        let before: usize = parts[..wanted.code].iter().map(|part| part.len() + 1).sum();
        let at = begin + before;
        if at + code.len() < field.start || at >= field.end {
            return Across::Text;
        }
        if is_like_code(code.trim_matches('"')) {
            return Across::Rows;
        }
        let is_row = wanted.columns > 1 && parts.len() == wanted.columns;
        if is_row { Across::Doubtful } else { Across::Text }
    }
}

/// What is in the lines over which a field runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Across {
    /// Nothing that looks like a row.
    Text,
    /// A line with as many fields as a row has.
    Doubtful,
    /// A line with a code where rows have it.
    Rows,
}

impl Iterator for Records<'_> {
    type Item = Record;

    fn next(&mut self) -> Option<Record> {
        loop {
            if self.rest.is_empty() {
                return None;
            }
            let read = extent(self.rest, self.separator).map(|read| {
                let across = self.lines_across(&self.rest[..read.end], &read);
                (read, across)
            });
            let closed = read.filter(|(_, across)| *across != Across::Rows);
            let length =
                closed.as_ref().map_or_else(|| line_end(self.rest, 0), |(read, _)| read.end);
            let (text, rest) = self.rest.split_at(length);
            let line = self.line;
            self.rest = rest;
            self.line += line_ends(text);
            let mut reader = csv::ReaderBuilder::new()
                .delimiter(self.separator)
                .quoting(closed.is_some())
                .has_headers(false)
                .flexible(true)
                .from_reader(text.as_bytes());
            let is_open = closed.is_none();
            let doubtful = closed.filter(|(_, across)| *across == Across::Doubtful);
            let like_rows = doubtful.and_then(|(read, _)| {
                let (_, first) = read.across.first()?;
                let (_, last) = read.across.last()?;
                Some((line + line_ends(&text[..first.start]), line + line_ends(&text[..last.end])))
            });
            // Lines without anything are no records; a text that was decoded has no other errors.
            if let Some(Ok(record)) = reader.records().next() {
                let fields = record.iter().map(str::to_owned).collect();
                return Some(Record { line, fields, is_open, like_rows });
            }
        }
    }
}

/// How many lines end in a text: in a line feed, or, on old machines, in a carriage return.
fn line_ends(text: &str) -> u64 {
    text.matches('\n').count().max(text.matches('\r').count()) as u64
}

/// Where the line ends that a place is in, with its line end.
fn line_end(text: &str, place: usize) -> usize {
    let is_end = |byte: &u8| matches!(byte, b'\r' | b'\n');
    let bytes = text.as_bytes();
    let end = bytes[place..].iter().position(is_end).map_or(bytes.len(), |end| place + end);
    let both = bytes[end..].starts_with(b"\r\n");
    (end + if both { 2 } else { 1 }).min(bytes.len())
}

/// How far the first record of a text goes.
#[derive(Debug)]
struct Extent {
    /// Where it ends, with its line end.
    end: usize,
    /// Its fields that run over line ends: which, and from where to where, without their marks.
    across: Vec<(usize, Range<usize>)>,
}

/// The extent of the first record of a text; none where a quotation mark is not closed.
fn extent(text: &str, separator: u8) -> Option<Extent> {
    let bytes = text.as_bytes();
    let (mut place, mut field, mut across) = (0, 0, Vec::new());
    loop {
        if bytes.get(place) == Some(&b'"') {
            let begin = place;
            place += 1;
            // Two marks are one that belongs to the field.
            while bytes[place..].starts_with(b"\"\"") || *bytes.get(place)? != b'"' {
                place += if bytes[place] == b'"' { 2 } else { 1 };
            }
            let inside = begin + 1..place;
            place += 1;
            if line_end(text, begin) < place {
                let ends = |byte: &u8| *byte == separator || matches!(byte, b'\r' | b'\n');
                if bytes.get(place).is_some_and(|byte| !ends(byte)) {
                    return None;
                }
                across.push((field, inside));
            }
        }
        let end = line_end(text, place);
        match bytes[place..end].iter().position(|&byte| byte == separator) {
            Some(next) => place += next + 1,
            None => return Some(Extent { end, across }),
        }
        field += 1;
    }
}
