//! Reads a `pddl` document.

use super::{Pddl, PddlBelief, PddlGoal, PddlObserver, PddlRule, PddlSensor, PddlState, PddlText};
use crate::document::DocumentError;
use crate::document::json::Json;
use crate::document::reader::Reader;
use crate::domain::Observers;

impl Pddl {
    /// Reads keys and types; what the texts say and whether the parts fit together is asked by
    /// [`problem`](Self::problem).
    ///
    /// # Errors
    ///
    /// [`DocumentError`] with the place.
    pub(in crate::domain) fn read(document: &Reader<'_>) -> Result<Self, DocumentError> {
        let fields =
            document.fields(&["format", "domain", "problem", "goals", "true_goal", "observers"])?;
        let pddl = |key, expected| PddlText::read(&fields.required(key, expected)?);
        Ok(Self {
            domain: pddl("domain", "the domain in PDDL")?,
            problem: pddl("problem", "the problem in PDDL")?,
            goals: fields.required("goals", "a list of goals")?.list(goal)?,
            true_goal: text(&fields.required("true_goal", "the name of a goal")?)?,
            observers: Observers::read(&fields, observer)?,
        })
    }
}

fn text(reader: &Reader<'_>) -> Result<String, DocumentError> {
    reader.text().map(str::to_owned)
}

fn name(reader: &Reader<'_>) -> Result<String, DocumentError> {
    reader.name().map(str::to_owned)
}

fn texts(reader: &Reader<'_>) -> Result<Vec<String>, DocumentError> {
    reader.list(text)
}

fn goal(reader: &Reader<'_>) -> Result<PddlGoal, DocumentError> {
    let fields = reader.fields(&["name", "condition"])?;
    Ok(PddlGoal {
        name: name(&fields.required("name", "the goal's name")?)?,
        condition: text(&fields.required("condition", "a condition, as in (and (on a b))")?)?,
    })
}

fn observer(reader: &Reader<'_>) -> Result<PddlObserver, DocumentError> {
    let fields = reader.fields(&["initial_belief", "groups", "sensor"])?;
    let groups = |reader: Reader<'_>| -> Result<_, DocumentError> {
        let group = |(name, objects): (&str, Reader<'_>)| Ok((name.to_owned(), texts(&objects)?));
        reader.entries()?.named()?.map(group).collect()
    };
    Ok(PddlObserver {
        initial_belief: fields.optional("initial_belief").map(|r| belief(&r)).transpose()?,
        groups: fields.optional("groups").map(groups).transpose()?.unwrap_or_default(),
        sensor: sensor(&fields.required("sensor", "a template of symbols, or a list of rules")?)?,
    })
}

fn belief(reader: &Reader<'_>) -> Result<PddlBelief, DocumentError> {
    match reader.value() {
        Json::Array(_) => reader.list(state).map(PddlBelief::States),
        Json::Object(_) => {
            let fields = reader.fields(&["reachable"])?;
            let condition = fields.required("reachable", "a condition, as in (handempty)")?;
            text(&condition).map(PddlBelief::Reachable)
        }
        _ => Err(reader.expected("a list of states, or an object with reachable")),
    }
}

fn state(reader: &Reader<'_>) -> Result<PddlState, DocumentError> {
    match reader.value() {
        Json::Array(_) => texts(reader).map(PddlState::Atoms),
        Json::Object(_) => {
            let fields = reader.fields(&["add", "delete"])?;
            let atoms = |key| fields.optional(key).map(|r| texts(&r)).transpose();
            Ok(PddlState::Change {
                add: atoms("add")?.unwrap_or_default(),
                delete: atoms("delete")?.unwrap_or_default(),
            })
        }
        _ => Err(reader.expected("a list of atoms, or an object with add and delete")),
    }
}

fn sensor(reader: &Reader<'_>) -> Result<PddlSensor, DocumentError> {
    let Json::Object(_) = reader.value() else { return by_rule(reader) };
    let fields = reader.fields(&["table", "otherwise"])?;
    let row = |row: &Reader<'_>| match row.list(name)?.as_slice() {
        [operator, symbol] => Ok((operator.clone(), symbol.clone())),
        _ => Err(row.expected("an operator and its symbol, as in [\"(stack a b)\", \"a noise\"]")),
    };
    let table = fields.required("table", "a list of operators with their symbols")?.list(row)?;
    let otherwise = fields.optional("otherwise").map(|r| by_rule(&r)).transpose()?.map(Box::new);
    Ok(PddlSensor::Table { table, otherwise })
}

fn by_rule(reader: &Reader<'_>) -> Result<PddlSensor, DocumentError> {
    match reader.value() {
        Json::Text(_) => name(reader).map(PddlSensor::Template),
        Json::Array(_) => reader.list(rule).map(PddlSensor::Rules),
        _ => Err(reader.expected("a template of symbols, or a list of rules")),
    }
}

fn rule(reader: &Reader<'_>) -> Result<PddlRule, DocumentError> {
    let fields = reader.fields(&["operator", "result", "symbol"])?;
    Ok(PddlRule {
        operator: text(&fields.required("operator", "a pattern, as in (stack ?x ?y)")?)?,
        result: fields.optional("result").map(|r| text(&r)).transpose()?,
        symbol: name(&fields.required("symbol", "a template of the symbol")?)?,
    })
}
