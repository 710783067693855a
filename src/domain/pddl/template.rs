//! Templates of symbols: `"{name} {1}"`.
//!
//! | placeholder | stands for |
//! |---|---|
//! | `{name}` | the lifted name of the operator |
//! | `{arguments}` | all its arguments, with spaces between them |
//! | `{1}`, `{2}`, … | one argument |
//! | `{?x}` | the argument that the rule's pattern calls `?x` |
//!
//! Arguments stand as the observer sees them: by the name of their group where they have one.
//! `{{` and `}}` stand for braces.

/// A part of a template.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Part {
    Text(String),
    Name,
    Arguments,
    /// An argument, from 0.
    Argument(usize),
    Variable(String),
}

/// A template, read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Template {
    parts: Vec<Part>,
}

/// What is wrong with a template: what was found and what was expected.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct BadTemplate {
    pub found: String,
    pub expected: &'static str,
}

const PLACEHOLDERS: &str = "{name}, {arguments}, {1}, {2}, … or {?variable}";

impl Template {
    /// Reads a template.
    pub(super) fn read(text: &str) -> Result<Self, BadTemplate> {
        let mut parts = Vec::new();
        let mut plain = String::new();
        let mut rest = text;
        while let Some(place) = rest.find(['{', '}']) {
            plain.push_str(&rest[..place]);
            rest = &rest[place..];
            if let Some(doubled) = ["{{", "}}"].iter().find(|two| rest.starts_with(**two)) {
                plain.push_str(&doubled[1..]);
                rest = &rest[2..];
                continue;
            }
            let end = rest.find('}').filter(|&end| end > 0).ok_or_else(|| BadTemplate {
                found: format!("a lone {}", &rest[..1]),
                expected: "braces in pairs; {{ and }} stand for braces themselves",
            })?;
            if !plain.is_empty() {
                parts.push(Part::Text(std::mem::take(&mut plain)));
            }
            parts.push(Part::read(&rest[1..end]).ok_or_else(|| BadTemplate {
                found: format!("the placeholder {}", &rest[..=end]),
                expected: PLACEHOLDERS,
            })?);
            rest = &rest[end + 1..];
        }
        plain.push_str(rest);
        if !plain.is_empty() {
            parts.push(Part::Text(plain));
        }
        Ok(Self { parts })
    }

    /// The variables of its placeholders.
    pub(super) fn variables(&self) -> impl Iterator<Item = &str> {
        self.parts.iter().filter_map(|part| match part {
            Part::Variable(name) => Some(name.as_str()),
            _ => None,
        })
    }

    /// The largest number of an argument in a placeholder, from 1; 0 where there is none.
    pub(super) fn last_argument(&self) -> usize {
        let number = |part: &Part| match part {
            Part::Argument(index) => index + 1,
            _ => 0,
        };
        self.parts.iter().map(number).max().unwrap_or(0)
    }

    /// The symbol, from the operator's name, its arguments as they are seen, and the argument
    /// that each variable stands for.
    pub(super) fn fill(
        &self,
        name: &str,
        seen: &[&str],
        variable: impl Fn(&str) -> Option<usize>,
    ) -> String {
        let mut symbol = String::new();
        for part in &self.parts {
            match part {
                Part::Text(text) => symbol.push_str(text),
                Part::Name => symbol.push_str(name),
                Part::Arguments => symbol.push_str(&seen.join(" ")),
                Part::Argument(index) => symbol.push_str(seen.get(*index).unwrap_or(&"")),
                Part::Variable(name) => {
                    let argument = variable(name).and_then(|index| seen.get(index));
                    symbol.push_str(argument.unwrap_or(&""));
                }
            }
        }
        symbol
    }
}

impl Part {
    /// What stands between braces.
    fn read(text: &str) -> Option<Self> {
        match text {
            "name" => Some(Self::Name),
            "arguments" => Some(Self::Arguments),
            _ if text.starts_with('?') => Some(Self::Variable(text.to_lowercase())),
            _ => {
                let number: usize = text.parse().ok().filter(|number| *number > 0)?;
                Some(Self::Argument(number - 1))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fill(template: &str) -> String {
        let template = Template::read(template).unwrap();
        template.fill("stack", &["a-b", "c"], |name| (name == "?x").then_some(0))
    }

    #[test]
    fn placeholders_are_filled() {
        assert_eq!(fill("{name}"), "stack");
        assert_eq!(fill("{name} {1}"), "stack a-b");
        assert_eq!(fill("{2}/{1}: {arguments}"), "c/a-b: a-b c");
        assert_eq!(fill("the {?X} moves"), "the a-b moves");
        assert_eq!(fill("{{{name}}} }}{{"), "{stack} }{");
        assert_eq!(fill("a noise"), "a noise");
    }

    #[test]
    fn bad_templates() {
        for (template, found) in [
            ("{", "a lone {"),
            ("x } y", "a lone }"),
            ("{name", "a lone {"),
            ("{}", "the placeholder {}"),
            ("{0}", "the placeholder {0}"),
            ("{nam}", "the placeholder {nam}"),
            ("{-1}", "the placeholder {-1}"),
        ] {
            assert_eq!(Template::read(template).unwrap_err().found, found, "{template}");
        }
    }

    #[test]
    fn numbers_of_arguments() {
        let last = |template| Template::read(template).unwrap().last_argument();
        assert_eq!((last("{name}"), last("{3} {1}")), (0, 3));
    }
}
