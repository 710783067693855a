//! `mo-copp sensor`: sensors as tables in CSV.

use mo_copp::domain::Document;
use mo_copp::domain::pddl::PddlSensor;
use mo_copp::problem::Role;
use mo_copp::solver::OptionsError;
use serde::Serialize;

use super::args::SensorArgs;
use super::error::CliError;
use super::{input, print};

/// The first line of a table.
const HEAD: [&str; 2] = ["operator", "symbol"];

/// Prints a table, or the document with another one; the exit code.
pub fn run(args: &SensorArgs) -> Result<u8, CliError> {
    let (mut document, problem, exercise) = input::document_and_exercise(&args.problem)?;
    let wrong = |option, found: String, expected: &str| {
        CliError::Options(OptionsError::new(option, found, expected))
    };
    let Document::Pddl(pddl) = &mut document else {
        let reason = "found a document of another format, expected pddl".to_owned();
        return Err(CliError::Read { file: args.problem.display().to_string(), reason });
    };
    let role =
        [Role::Adversarial, Role::Cooperative].into_iter().find(|r| r.name() == args.observer);
    let Some(role) = role else {
        let found = format!("{:?}", args.observer);
        return Err(wrong("observer", found, "adversarial or cooperative"));
    };
    let Some(table) = &args.table else {
        let task = problem.task();
        let observers = problem.observers().iter();
        let sensors = observers.filter(|observer| observer.role == role).map(|o| &o.sensor);
        let mut writer = csv::Writer::from_writer(Vec::new());
        let failed = |error: csv::Error| CliError::Output(std::io::Error::other(error));
        writer.write_record(HEAD).map_err(failed)?;
        let mut seen = rustc_hash::FxHashMap::default();
        for sensor in sensors {
            for (id, operator) in task.operator_ids() {
                let name = task.action_name(operator.action);
                // Operators of one action are one row, where all of them are seen alike.
                let symbol = sensor.fixed(id);
                let before = seen.insert(name, symbol);
                if symbol.is_none() || before.is_some_and(|before| before != symbol) {
                    let reason = format!(
                        "found a sensor that looks at what {name} results in, expected one that a table can say"
                    );
                    return Err(CliError::Read {
                        file: args.problem.display().to_string(),
                        reason,
                    });
                }
                if let (Some(symbol), None) = (symbol, before) {
                    writer.write_record([name, sensor.name(symbol)]).map_err(failed)?;
                }
            }
        }
        let bytes = writer.into_inner().map_err(|error| CliError::Output(error.into_error()))?;
        print(&String::from_utf8_lossy(&bytes))?;
        return Ok(0);
    };
    let text = input::text(table)?;
    let mut rows = Vec::new();
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(text.as_bytes());
    let place = |line: u64, reason: String| CliError::Read {
        file: format!("{}:{line}:1", table.display()),
        reason,
    };
    let broken = |error: csv::Error| {
        let line = error.position().map_or(1, csv::Position::line);
        place(line, error.to_string())
    };
    let head = reader.headers().map_err(broken)?;
    if !head.iter().map(str::trim).eq(HEAD) {
        let found = head.iter().collect::<Vec<_>>().join(",");
        return Err(place(1, format!("found {found:?}, expected the line operator,symbol")));
    }
    for record in reader.records() {
        let record = record.map_err(broken)?;
        let line = record.position().map_or(1, csv::Position::line);
        match record.iter().collect::<Vec<_>>()[..] {
            [operator, symbol] if !symbol.is_empty() => {
                rows.push((operator.trim().to_owned(), symbol.to_owned()));
            }
            ref fields => {
                let found = format!("found {} fields or no symbol", fields.len());
                return Err(place(line, format!("{found}, expected an operator and its symbol")));
            }
        }
    }
    let otherwise = args.otherwise.clone().map(|template| Box::new(PddlSensor::Template(template)));
    let sensor = PddlSensor::Table { table: rows, otherwise };
    match role {
        Role::Adversarial => pddl.observers.adversarial.sensor = sensor,
        Role::Cooperative => pddl.observers.cooperative.sensor = sensor,
    }
    // What the table says must fit the problem.
    let file = table.display().to_string();
    document.problem().map_err(|error| CliError::Document { file, error })?;
    let whole = Whole { document: &document, exercise: exercise.as_ref() };
    let text = serde_json::to_string_pretty(&whole)
        .map_err(|error| CliError::Output(std::io::Error::other(error)))?;
    print(&(text + "\n"))?;
    Ok(0)
}

/// A document with the exercise that it had.
#[derive(Serialize)]
struct Whole<'a> {
    #[serde(flatten)]
    document: &'a Document,
    #[serde(skip_serializing_if = "Option::is_none")]
    exercise: Option<&'a serde_json::Value>,
}
