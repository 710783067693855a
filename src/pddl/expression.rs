//! S-expressions with positions.
//!
//! A text becomes a flat list of nodes in the order in which they stand, so that neither reading nor
//! dropping it recurses and a node takes 8 bytes. Comments run from `;` to the end of the line. A dash
//! before a letter, as in `?x -block`, is a symbol of its own: no name begins with one. A question mark begins a symbol
//! also without a blank before it, as in `(at aircraft?a)`, which other planners read so.

use super::error::{PddlError, place, quoted};
use crate::limits::excess_of_text;

/// How deep parentheses may be nested. Classic domains need six; readers of conditions recurse.
pub const MAX_DEPTH: usize = 64;

/// Marks a list in [`Node::end`].
const LIST: u32 = 1 << 31;

/// A symbol: its bytes from `start` to `end`. A list: the byte of its parenthesis, and `LIST` with
/// the number of the first node after it.
#[derive(Debug, Clone, Copy)]
struct Node {
    start: u32,
    end: u32,
}

/// A text, read.
#[derive(Debug)]
pub(super) struct Tree<'a> {
    text: &'a str,
    nodes: Vec<Node>,
}

/// One expression of a text.
#[derive(Debug, Clone, Copy)]
pub(super) struct Expression<'t> {
    tree: &'t Tree<'t>,
    node: usize,
}

/// The expressions in a list, one after the other.
#[derive(Debug, Clone)]
pub(super) struct Expressions<'t> {
    tree: &'t Tree<'t>,
    next: usize,
    end: usize,
}

impl<'a> Tree<'a> {
    /// Reads a text of any number of expressions. Linear in its length.
    pub(super) fn read(text: &'a str) -> Result<Self, PddlError> {
        if let Some((found, expected)) = excess_of_text(text) {
            return Err(PddlError::at(text, 0, found, expected));
        }
        let mut nodes = Vec::new();
        let mut open: Vec<usize> = Vec::new();
        let bytes = text.as_bytes();
        // Some editors begin a text with a mark of its encoding.
        let mut at = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        while let Some(&byte) = bytes.get(at) {
            let start = at;
            at += 1;
            match byte {
                b'(' if open.len() == MAX_DEPTH => {
                    let found = format!("parentheses nested more than {MAX_DEPTH} deep");
                    return Err(PddlError::at(text, start, found, "at most that"));
                }
                b'(' => {
                    open.push(nodes.len());
                    nodes.push(Node { start: start as u32, end: LIST });
                }
                b')' => match open.pop() {
                    Some(list) => nodes[list].end = LIST | nodes.len() as u32,
                    None => {
                        let expected = "a parenthesis only where one is open";
                        return Err(PddlError::at(text, start, "\")\"", expected));
                    }
                },
                b';' => at += bytes[at..].iter().take_while(|&&byte| byte != b'\n').count(),
                _ if byte.is_ascii_whitespace() => {}
                b'-' if bytes.get(at).is_some_and(u8::is_ascii_alphabetic) => {
                    nodes.push(Node { start: start as u32, end: at as u32 });
                }
                _ => {
                    let more = |byte: &&u8| {
                        !matches!(**byte, b'(' | b')' | b';' | b'?') && !byte.is_ascii_whitespace()
                    };
                    at += bytes[at..].iter().take_while(more).count();
                    nodes.push(Node { start: start as u32, end: at as u32 });
                }
            }
        }
        if let Some(&list) = open.last() {
            let (line, column) = place(text, nodes[list].start as usize);
            let expected = format!("\")\" for the \"(\" of line {line}, column {column}");
            return Err(PddlError::at(text, text.len(), "the end of the text", expected));
        }
        Ok(Self { text, nodes })
    }

    /// The expressions that stand in no other.
    pub(super) fn expressions(&self) -> Expressions<'_> {
        Expressions { tree: self, next: 0, end: self.nodes.len() }
    }

    /// The one expression of the text.
    pub(super) fn only(&self, expected: &str) -> Result<Expression<'_>, PddlError> {
        let mut all = self.expressions();
        let Some(first) = all.next() else {
            return Err(self.ends(expected));
        };
        match all.next() {
            None => Ok(first),
            Some(second) => Err(second.expected("the end of the text")),
        }
    }

    /// The error that the text ends where something was expected.
    pub(super) fn ends(&self, expected: &str) -> PddlError {
        PddlError::at(self.text, self.text.len(), "the end of the text", expected)
    }
}

impl<'t> Expression<'t> {
    /// The text of a symbol.
    pub(super) fn symbol(self) -> Option<&'t str> {
        let Node { start, end } = self.tree.nodes[self.node];
        (end & LIST == 0).then(|| &self.tree.text[start as usize..end as usize])
    }

    /// Whether this is a keyword or another known symbol, which stands here in small letters.
    pub(super) fn is(self, symbol: &str) -> bool {
        self.symbol().is_some_and(|found| found.eq_ignore_ascii_case(symbol))
    }

    /// What a list holds.
    pub(super) fn list(self) -> Option<Expressions<'t>> {
        let end = self.tree.nodes[self.node].end;
        let items =
            || Expressions { tree: self.tree, next: self.node + 1, end: (end & !LIST) as usize };
        (end & LIST != 0).then(items)
    }

    /// What a list holds.
    pub(super) fn items(self, expected: &str) -> Result<Expressions<'t>, PddlError> {
        self.list().ok_or_else(|| self.expected(expected))
    }

    /// The symbol at the head of a list, and what follows it.
    pub(super) fn headed(
        self,
        expected: &str,
    ) -> Result<(Expression<'t>, Expressions<'t>), PddlError> {
        let mut items = self.items(expected)?;
        match items.next() {
            Some(head) if head.symbol().is_some() => Ok((head, items)),
            _ => Err(self.expected(expected)),
        }
    }

    /// A name in small letters; no variable, no keyword.
    pub(super) fn name(self, expected: &str) -> Result<String, PddlError> {
        let name = self.symbol().ok_or_else(|| self.expected(expected))?;
        if name.starts_with(['?', ':']) || !is_name(name) {
            let expected = format!("{expected} of letters, digits, - and _");
            return Err(self.expected(&expected));
        }
        Ok(name.to_ascii_lowercase())
    }

    /// A variable in small letters, its question mark included.
    pub(super) fn variable(self) -> Result<String, PddlError> {
        const EXPECTED: &str = "a variable, as in ?x";
        let name = self.symbol().ok_or_else(|| self.expected(EXPECTED))?;
        match name.strip_prefix('?') {
            Some(rest) if is_name(rest) => Ok(name.to_ascii_lowercase()),
            _ => Err(self.expected(EXPECTED)),
        }
    }

    /// Whether both are the same place of a text.
    pub(super) fn is_same(self, other: Self) -> bool {
        self.node == other.node
    }

    /// The error that something else was expected here.
    pub(super) fn expected(self, expected: &str) -> PddlError {
        self.wrong(self.shown(), expected)
    }

    /// The error that `found` stands here.
    pub(super) fn wrong(self, found: impl Into<String>, expected: impl Into<String>) -> PddlError {
        let start = self.tree.nodes[self.node].start as usize;
        PddlError::at(self.tree.text, start, found, expected)
    }

    /// How it is shown in an error.
    pub(super) fn shown(self) -> String {
        if let Some(symbol) = self.symbol() {
            return quoted(symbol);
        }
        let mut items = self.list().into_iter().flatten();
        match (items.next().map(|head| head.symbol().unwrap_or("(…)")), items.next()) {
            (None, _) => "\"()\"".to_owned(),
            (Some(head), None) => quoted(&format!("({head})")),
            (Some(head), Some(_)) => quoted(&format!("({head} …)")),
        }
    }
}

/// What a name may consist of: more than the letters, digits, `-` and `_` of the PDDL standard,
/// since tasks in circulation have more, but nothing that could be taken for something else.
fn is_name(name: &str) -> bool {
    let allowed = |c: char| c.is_alphanumeric() || "-_@#$%&!.+*/<>=~^".contains(c);
    !name.is_empty() && name != "-" && name.chars().all(allowed)
}

impl<'t> Iterator for Expressions<'t> {
    type Item = Expression<'t>;

    fn next(&mut self) -> Option<Expression<'t>> {
        if self.next == self.end {
            return None;
        }
        let node = self.next;
        let end = self.tree.nodes[node].end;
        self.next = if end & LIST == 0 { node + 1 } else { (end & !LIST) as usize };
        Some(Expression { tree: self.tree, node })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape(text: &str) -> String {
        fn write(expression: Expression<'_>, out: &mut String) {
            match expression.symbol() {
                Some(symbol) => out.push_str(symbol),
                None => {
                    out.push('[');
                    for item in expression.list().unwrap() {
                        write(item, out);
                        out.push('.');
                    }
                    out.push(']');
                }
            }
        }
        let tree = Tree::read(text).unwrap();
        let mut out = String::new();
        tree.expressions().for_each(|expression| write(expression, &mut out));
        out
    }

    #[test]
    fn lists_symbols_and_comments() {
        assert_eq!(shape("(a(b c)() ; d)\n e)"), "[a.[b.c.].[].e.]");
        assert_eq!(shape("x;y"), "x");
        assert_eq!(shape("(?x -b - a-b --c -(d) -1)"), "[?x.-.b.-.a-b.--c.-.[d.].-1.]");
        assert_eq!(shape("\u{feff}(x)"), "[x.]");
        assert_eq!(shape("(at aircraft?a ?x?y)?"), "[at.aircraft.?a.?x.?y.]?");
    }

    #[test]
    fn parentheses_that_do_not_match() {
        let error = |text| Tree::read(text).unwrap_err().to_string();
        assert_eq!(
            error("(a\n  (b"),
            "line 2, column 5: found the end of the text, expected \")\" for the \"(\" of line 2, column 3"
        );
        assert_eq!(
            error("(a))"),
            "line 1, column 4: found \")\", expected a parenthesis only where one is open"
        );
        let deep = error(&"(".repeat(100_000));
        assert_eq!(
            deep,
            "line 1, column 65: found parentheses nested more than 64 deep, expected at most that"
        );
    }

    #[test]
    fn columns_count_characters() {
        let tree = Tree::read("é (ü)").unwrap();
        let second = tree.expressions().nth(1).unwrap();
        assert_eq!(second.expected("x").column, 3);
    }
}
