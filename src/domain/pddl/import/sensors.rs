//! Sensors by template for whatever actions a domain has.

use super::super::template::Template;
use super::super::{PddlRule, PddlSensor};
use super::ImportError;
use crate::pddl::Domain;

/// The template for all actions; where it names more arguments than one of them has, a rule for each action, without
/// the arguments that it does not have.
pub(super) fn sensor(
    domain: &Domain,
    option: &'static str,
    template: &str,
) -> Result<PddlSensor, ImportError> {
    let wrong = |found: String, expected: String| ImportError::Option { option, found, expected };
    let read =
        Template::read(template).map_err(|error| wrong(error.found, error.expected.to_owned()))?;
    if let Some(name) = read.variables().next() {
        return Err(wrong(
            format!("the placeholder {{{name}}}"),
            "{name}, {arguments}, {1}, {2}, …, since no pattern names arguments here".to_owned(),
        ));
    }
    let last = read.last_argument();
    if domain.schemas.iter().all(|schema| schema.parameters.len() >= last) {
        return Ok(PddlSensor::Template(template.to_owned()));
    }
    let rule = |schema: &crate::pddl::Schema| {
        let mut symbol = template.to_owned();
        for missing in schema.parameters.len() + 1..=last {
            symbol = symbol.replace(&format!("{{{missing}}}"), "");
        }
        let symbol = symbol.split_whitespace().collect::<Vec<_>>().join(" ");
        let symbol = if symbol.is_empty() { "{name}".to_owned() } else { symbol };
        PddlRule { operator: schema.name.clone(), result: None, symbol }
    };
    // An action may be declared several times.
    let schemas = domain.schemas.iter().enumerate();
    let schemas = schemas.filter(|(number, _)| domain.first_case(*number) == *number);
    Ok(PddlSensor::Rules(schemas.map(|(_, schema)| rule(schema)).collect()))
}
