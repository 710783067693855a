//! Sensors as tables: a symbol for each ground operator, as goal-recognition design has them.

use rustc_hash::FxHashMap;

use super::build::{Texts, at};
use crate::document::DocumentError;
use crate::document::json::quoted;
use crate::pddl::{ObjectId, Pattern};

/// The most rows.
const MAX_ROWS: usize = if cfg!(target_arch = "wasm32") { 100_000 } else { 1_000_000 };

/// The symbols of operators, by schema and arguments.
#[derive(Debug, Default)]
pub(super) struct Table(FxHashMap<(usize, Vec<ObjectId>), String>);

impl Table {
    /// Reads the rows. Operators that the task never comes to are passed over.
    pub(super) fn read(
        rows: &[(String, String)],
        texts: &Texts,
        path: &str,
    ) -> Result<Self, DocumentError> {
        if rows.len() > MAX_ROWS {
            let found = format!("{} rows", rows.len());
            return Err(DocumentError::invalid(
                format!("{path}.table"),
                found,
                format!("at most {MAX_ROWS}"),
            ));
        }
        let mut table = FxHashMap::default();
        for (index, (operator, symbol)) in rows.iter().enumerate() {
            let path = format!("{path}.table[{index}]");
            let pattern = Pattern::read(&texts.domain, &texts.task, &[], operator)
                .map_err(|error| at(format!("{path}[0]"), error))?;
            let Some(key) = pattern.operator() else {
                let expected = "an operator with its objects, as in (stack a b)";
                return Err(DocumentError::invalid(
                    format!("{path}[0]"),
                    quoted(operator),
                    expected,
                ));
            };
            match table.insert(key, symbol.clone()) {
                Some(other) if other != *symbol => {
                    let found =
                        format!("another symbol for {operator}, which had {}", quoted(&other));
                    return Err(DocumentError::invalid(
                        path,
                        found,
                        "one symbol for each operator",
                    ));
                }
                _ => {}
            }
        }
        Ok(Self(table))
    }

    /// The symbol of an operator.
    pub(super) fn symbol(&self, schema: usize, arguments: &[ObjectId]) -> Option<&str> {
        if self.0.is_empty() {
            return None;
        }
        self.0.get(&(schema, arguments.to_vec())).map(String::as_str)
    }

    /// Whether it has no row.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}
