//! The symbol an observer sees for each action.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use crate::document::reader::Fields;
use crate::document::{DocumentError, Names};

/// What is expected where a symbol is missing.
const SYMBOL: &str = "the symbol the observer sees";

/// The symbol an observer sees for each action, in the order of the actions.
///
/// ```
/// use mo_copp::domain::grid::Symbols;
/// let symbols = Symbols::new([("turn-left", "turn"), ("stay", "move")]);
/// assert_eq!(symbols.get("stay"), Some("move"));
/// assert_eq!(symbols.get("jump"), None);
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Symbols(Vec<(&'static str, String)>);

impl Symbols {
    /// Actions with their symbols.
    pub fn new<const N: usize>(symbols: [(&'static str, &str); N]) -> Self {
        Self(symbols.into_iter().map(|(action, symbol)| (action, symbol.to_owned())).collect())
    }

    /// The symbol of an action.
    pub fn get(&self, action: &str) -> Option<&str> {
        self.0.iter().find(|(known, _)| *known == action).map(|(_, symbol)| symbol.as_str())
    }

    /// Gives an action another symbol, or its first.
    pub fn set(&mut self, action: &'static str, symbol: impl Into<String>) {
        match self.0.iter_mut().find(|(known, _)| *known == action) {
            Some((_, old)) => *old = symbol.into(),
            None => self.0.push((action, symbol.into())),
        }
    }

    /// Reads the `sensor` of an observer: a symbol for each of the `required` actions, and for
    /// those of the `optional` ones that are there.
    pub(super) fn read(
        observer: &Fields<'_>,
        required: &[&'static str],
        optional: &[&'static str],
    ) -> Result<Self, DocumentError> {
        let known = [required, optional].concat();
        let sensor = observer.required("sensor", "an object with a symbol for each action")?;
        let fields = sensor.fields(&known)?;
        let mut symbols = Vec::with_capacity(known.len());
        for action in known {
            if required.contains(&action) || fields.optional(action).is_some() {
                symbols.push((action, fields.required(action, SYMBOL)?.name()?.to_owned()));
            }
        }
        Ok(Self(symbols))
    }

    /// Each of these actions must have a symbol, and no two of them may only look alike. `why` tells
    /// what makes an action possible.
    pub(super) fn check(
        &self,
        path: &str,
        actions: &[&'static str],
        why: &str,
    ) -> Result<(), DocumentError> {
        match actions.iter().find(|action| self.get(action).is_none()) {
            None => {
                let mut shapes = Names::default();
                for (action, symbol) in &self.0 {
                    shapes.add_symbol(symbol, || format!("{path}.sensor.{action}"))?;
                }
                Ok(())
            }
            Some(action) => {
                let path = format!("{path}.sensor.{action}");
                Err(DocumentError::invalid(path, "nothing", format!("{SYMBOL}{why}")))
            }
        }
    }
}

impl Serialize for Symbols {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (action, symbol) in &self.0 {
            map.serialize_entry(action, symbol)?;
        }
        map.end()
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl schemars::JsonSchema for Symbols {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Symbols".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({"type": "object", "additionalProperties": {"type": "string"}})
    }
}
