//! The sensor of an observer of a PDDL task: rules over operators, the first match wins.

use rustc_hash::{FxHashMap, FxHashSet};

use super::build::{Texts, at};
use super::cover::covers;
use super::table::Table;
use super::template::Template;
use super::{PddlObserver, PddlSensor};
use crate::document::DocumentError;
use crate::document::json::quoted;
use crate::domain::observers::listed;
use crate::pddl::{Condition, Formula, Grounded, Group, Pattern, PddlError};
use crate::sensor::{Sensor, SensorBuilder};
use crate::task::{Action, OperatorId};

/// The most rules of a sensor.
const MAX_RULES: usize = 1000;

/// The most readings that depend on the resulting state, over all operators.
const MAX_CASES: usize = if cfg!(target_arch = "wasm32") { 200_000 } else { 2_000_000 };

/// The most conjunctions that a result stands for.
const MAX_ALTERNATIVES: usize = 256;

/// The most bytes of symbols.
const MAX_SYMBOL_BYTES: usize = if cfg!(target_arch = "wasm32") { 8 << 20 } else { 64 << 20 };

/// A rule whose texts are read.
struct Rule {
    pattern: Pattern,
    result: Option<Formula>,
    symbol: Template,
}

/// How an observer sees operators, once the texts are read.
pub(super) struct Eye<'a> {
    table: Table,
    rules: Vec<Rule>,
    /// The name under which each object is seen, by its number.
    seen: Vec<&'a str>,
    path: String,
}

/// What an observer reads on one operator.
#[derive(Default)]
struct Reading {
    /// Condition, by its position among all conditions, and symbol.
    cases: Vec<(u32, u32)>,
    otherwise: u32,
}

/// What an observer reads on each operator, conditions still as such.
#[derive(Default)]
pub(super) struct Readings {
    symbols: Vec<String>,
    of_operators: Vec<Reading>,
}

impl<'a> Eye<'a> {
    /// Reads groups and rules.
    pub(super) fn new(
        observer: &'a PddlObserver,
        texts: &'a Texts,
        path: &str,
    ) -> Result<Self, DocumentError> {
        let groups = groups(observer, texts, &format!("{path}.groups"))?;
        let objects = &texts.task.objects;
        let mut seen: Vec<&str> = objects.ids().map(|id| objects.name(id)).collect();
        for ((name, _), (_, members)) in observer.groups.iter().zip(&groups) {
            for object in members {
                seen[object.index()] = name;
            }
        }
        let path = format!("{path}.sensor");
        let mut eye = Self { table: Table::default(), rules: Vec::new(), seen, path };
        let by_rule = match &observer.sensor {
            PddlSensor::Table { table, otherwise } => {
                eye.table = Table::read(table, texts, &eye.path)?;
                otherwise.as_deref().map(|sensor| (sensor, ".otherwise"))
            }
            other => Some((other, "")),
        };
        match by_rule {
            // The reader takes no table for what is seen otherwise.
            None | Some((PddlSensor::Table { .. }, _)) => {}
            Some((PddlSensor::Template(template), key)) => {
                eye.add(texts, &groups, ("*", None, template), |_| key.to_owned())?;
            }
            Some((PddlSensor::Rules(rules), key)) if rules.len() > MAX_RULES => {
                let found = format!("{} rules", rules.len());
                let expected = format!("at most {MAX_RULES}");
                let path = format!("{}{key}", eye.path);
                return Err(DocumentError::invalid(path, found, expected));
            }
            Some((PddlSensor::Rules(rules), key)) => {
                for (index, rule) in rules.iter().enumerate() {
                    let texts_of_rule =
                        (rule.operator.as_str(), rule.result.as_deref(), rule.symbol.as_str());
                    let place = |part: &str| format!("{key}[{index}].{part}");
                    eye.add(texts, &groups, texts_of_rule, place)?;
                }
            }
        }
        Ok(eye)
    }

    fn add(
        &mut self,
        texts: &Texts,
        groups: &[Group],
        (operator, result, symbol): (&str, Option<&str>, &str),
        place: impl Fn(&str) -> String,
    ) -> Result<(), DocumentError> {
        let path = |key: &str| self.path.clone() + &place(key);
        let wrong = |key: &'static str| {
            let path = path(key);
            move |error: PddlError| at(path, error)
        };
        let (domain, task) = (&texts.domain, &texts.task);
        let pattern = Pattern::read(domain, task, groups, operator).map_err(wrong("operator"))?;
        let hides = |earlier: &Rule| {
            earlier.result.is_none()
                && earlier.pattern.takes_all_arguments()
                && earlier.pattern.schema().is_none_or(|schema| pattern.schema() == Some(schema))
        };
        if let Some(earlier) = self.rules.iter().position(hides) {
            let found = format!("{}, all of which rule {} takes", quoted(operator), earlier + 1);
            let expected = "a rule that some operator is left for";
            return Err(DocumentError::invalid(path("operator"), found, expected));
        }
        if !pattern.fits_some(domain, task) {
            let found = format!("{}, which fits no operator", quoted(operator));
            return Err(DocumentError::invalid(
                path("operator"),
                found,
                "a rule that some operator fits",
            ));
        }
        let result = match result {
            None => None,
            Some(text) => {
                let formula = pattern.read_condition(domain, task, text);
                Some(formula.map_err(wrong("result"))?)
            }
        };
        let bad = |found: String, expected: String| {
            DocumentError::invalid(path("symbol"), found, expected)
        };
        let symbol =
            Template::read(symbol).map_err(|error| bad(error.found, error.expected.to_owned()))?;
        if let Some(name) = symbol.variables().find(|name| pattern.place(name).is_none()) {
            let expected = format!("a variable of the pattern: {}", pattern.written_variables());
            return Err(bad(format!("the placeholder {{{name}}}"), expected));
        }
        let last = symbol.last_argument();
        let schemas = domain.schemas.iter().enumerate();
        let mut matching =
            schemas.filter(|(number, _)| pattern.schema().is_none_or(|schema| schema == *number));
        if let Some((_, schema)) = matching.find(|(_, schema)| schema.parameters.len() < last) {
            let expected = format!(
                "a placeholder from 1 to the number of arguments of {}, which is {}",
                schema.name,
                schema.parameters.len()
            );
            return Err(bad(format!("the placeholder {{{last}}}"), expected));
        }
        self.rules.push(Rule { pattern, result, symbol });
        Ok(())
    }

    /// What the observer reads on each operator. Conditions are added to those at hand.
    pub(super) fn readings(
        &self,
        texts: &Texts,
        grounded: &Grounded,
        conditions: &mut Vec<Condition>,
    ) -> Result<Readings, DocumentError> {
        let mut readings = Readings::default();
        let mut numbers = Numbers::default();
        let mut cases = 0;
        for (_, operator) in grounded.task.operator_ids() {
            let mut tried: Vec<u32> = Vec::new();
            let action = operator.action;
            let (schema, objects) = (grounded.schema(action), grounded.arguments(action));
            let mut reading = Reading::default();
            let mut complete = false;
            if let Some(symbol) = self.table.symbol(schema, objects) {
                reading.otherwise = numbers.symbol(symbol.to_owned(), &mut readings.symbols);
                readings.of_operators.push(reading);
                continue;
            }
            let fits = |rule: &&Rule| rule.pattern.matches(&texts.task, schema, objects);
            for rule in self.rules.iter().filter(fits) {
                let symbol = self.symbol(texts, grounded, action, rule);
                let symbol = numbers.symbol(symbol, &mut readings.symbols);
                if numbers.bytes > MAX_SYMBOL_BYTES {
                    let found = format!("more than {} MiB of symbols", MAX_SYMBOL_BYTES >> 20);
                    return Err(DocumentError::invalid(&self.path, found, "at most that"));
                }
                let Some(formula) = &rule.result else {
                    reading.otherwise = symbol;
                    complete = true;
                    break;
                };
                let condition = rule.pattern.condition(&texts.task, formula, objects);
                let Some(all) =
                    condition.and_then(|condition| condition.alternatives(MAX_ALTERNATIVES))
                else {
                    let found = format!("a result with more than {MAX_ALTERNATIVES} alternatives");
                    return Err(DocumentError::invalid(&self.path, found, "at most that"));
                };
                cases += all.len().max(1);
                if cases > MAX_CASES {
                    let found = format!("more than {MAX_CASES} rules with a result that apply");
                    return Err(DocumentError::invalid(&self.path, found, "at most that"));
                }
                for condition in all {
                    let number = numbers.condition(condition, conditions);
                    tried.push(number);
                    reading.cases.push((number, symbol));
                }
            }
            if !complete {
                let cases: Vec<&Condition> =
                    tried.iter().map(|&number| &conditions[number as usize]).collect();
                if covers(&texts.task, grounded, operator, &cases)
                    && let Some((_, symbol)) = reading.cases.pop()
                {
                    // Where no case before the last one fits, the last one does.
                    reading.otherwise = symbol;
                    complete = true;
                }
            }
            if !complete {
                let name = grounded.task.action_name(action);
                let (found, expected) = if reading.cases.is_empty() {
                    (format!("no symbol for {name}"), self.expected_symbol())
                } else {
                    let found = format!("no symbol for {name} in every resulting state");
                    let expected =
                        "rules whose results leave none out, or a last one without a result";
                    (found, expected)
                };
                return Err(DocumentError::invalid(&self.path, found, expected));
            }
            readings.of_operators.push(reading);
        }
        Ok(readings)
    }

    /// What would give an operator a symbol.
    fn expected_symbol(&self) -> &'static str {
        if self.table.is_empty() {
            "a rule that matches it"
        } else {
            "it in the table, or a rule that matches it"
        }
    }

    fn symbol(&self, texts: &Texts, grounded: &Grounded, action: Action, rule: &Rule) -> String {
        let objects = grounded.arguments(action);
        let seen: Vec<&str> = objects.iter().map(|object| self.seen[object.index()]).collect();
        let name = &texts.domain.schemas[grounded.schema(action)].name;
        rule.symbol.fill(name, &seen, |variable| rule.pattern.place(variable))
    }

    /// The finished sensor.
    pub(super) fn sensor(
        &self,
        grounded: &Grounded,
        readings: &Readings,
    ) -> Result<Sensor, DocumentError> {
        let task = &grounded.task;
        let mut builder = SensorBuilder::new(task);
        for ((id, _), reading) in task.operator_ids().zip(&readings.of_operators) {
            let id: OperatorId = id;
            for &(condition, symbol) in &reading.cases {
                if let Some(facts) = &grounded.conditions[condition as usize] {
                    builder.when(id, facts, &readings.symbols[symbol as usize]);
                }
            }
            builder.always(id, &readings.symbols[reading.otherwise as usize]);
        }
        builder.build(task).map_err(|error| {
            DocumentError::invalid(&self.path, error.to_string(), "a symbol for every operator")
        })
    }
}

/// The groups of an observer, resolved.
fn groups(observer: &PddlObserver, texts: &Texts, path: &str) -> Result<Vec<Group>, DocumentError> {
    let objects = &texts.task.objects;
    let mut taken = FxHashSet::default();
    let mut groups: Vec<Group> = Vec::with_capacity(observer.groups.len());
    for (name, members) in &observer.groups {
        let path = format!("{path}.{name}");
        let lower = name.to_lowercase();
        let known = if objects.named(&lower).is_some() {
            Some("an object")
        } else if texts.domain.types.named(&lower).is_some() {
            Some("a type")
        } else if groups.iter().any(|(other, _)| *other == lower) {
            Some("another group")
        } else {
            None
        };
        if let Some(what) = known {
            let found = format!("{}, which is the name of {what}", quoted(name));
            return Err(DocumentError::invalid(path, found, "a name of its own"));
        }
        if members.is_empty() {
            return Err(DocumentError::invalid(path, "no objects", "objects that look alike"));
        }
        let mut ids = Vec::with_capacity(members.len());
        for (index, member) in members.iter().enumerate() {
            let path = || format!("{path}[{index}]");
            let Some(id) = objects.named(&member.to_lowercase()) else {
                let names: Vec<&str> = objects.ids().map(|id| objects.name(id)).collect();
                let expected = format!("an object of the problem: {}", listed(&names));
                return Err(DocumentError::invalid(path(), quoted(member), expected));
            };
            if !taken.insert(id) {
                let found = format!("{} for the second time", quoted(member));
                let expected = "each object in one group at most";
                return Err(DocumentError::invalid(path(), found, expected));
            }
            ids.push(id);
        }
        ids.sort_unstable();
        groups.push((lower, ids));
    }
    Ok(groups)
}

/// Symbols and conditions met, each once.
#[derive(Default)]
struct Numbers {
    symbols: FxHashMap<String, u32>,
    conditions: FxHashMap<Condition, u32>,
    bytes: usize,
}

impl Numbers {
    fn symbol(&mut self, name: String, all: &mut Vec<String>) -> u32 {
        if let Some(&number) = self.symbols.get(&name) {
            return number;
        }
        let number = all.len() as u32;
        self.bytes += name.len();
        all.push(name.clone());
        self.symbols.insert(name, number);
        number
    }

    fn condition(&mut self, condition: Condition, all: &mut Vec<Condition>) -> u32 {
        if let Some(&number) = self.conditions.get(&condition) {
            return number;
        }
        let number = all.len() as u32;
        all.push(condition.clone());
        self.conditions.insert(condition, number);
        number
    }
}
