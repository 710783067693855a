//! What other programs ask of a solver.

use crate::document::DocumentError;
use crate::document::json::Json;
use crate::document::reader::{Fields, Reader};
use crate::problem::Problem;
use crate::solver::{Encoding, Horizon, MAX_HORIZON, Options, OptionsError, Solver, Watched};

const KEYS: [&str; 13] = [
    "solver",
    "encoding",
    "horizon",
    "horizon_step",
    "horizon_limit",
    "k",
    "j",
    "require",
    "forbid",
    "pairs",
    "pareto",
    "lengths",
    "cost_limit",
];

/// What is asked of a solver.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Request {
    /// The options.
    pub options: Options,
    /// Whether the pairs were asked for by their old name, `pareto`: the answer has it too, see
    /// [`with_old_names`](super::SolveReport::with_old_names).
    pub old_names: bool,
}

/// The request written as a JSON object, as the JavaScript API takes it.
///
/// # Errors
///
/// [`DocumentError`] with the option, what was given and what would do.
///
/// ```
/// use mo_copp::{domain::Delivery, report::read_request};
/// let problem = Delivery::figure_1().problem()?;
/// let request = read_request(r#"{"solver": "search", "k": 2, "j": 2}"#, &problem)?;
/// assert_eq!(request.options.bounds.at_least, Some(2));
/// let error = read_request(r#"{"solver": "search", "k": 7}"#, &problem).unwrap_err();
/// assert!(error.to_string().starts_with("k: found 7, expected a whole number from 1 to 6"));
/// let error = read_request(r#"{"solver": "search", "width": 7}"#, &problem).unwrap_err();
/// assert!(error.to_string().starts_with("options: found the unknown key \"width\", expected only"));
/// # Ok::<(), mo_copp::document::DocumentError>(())
/// ```
pub fn read_request(text: &str, problem: &Problem) -> Result<Request, DocumentError> {
    let json = Json::parse(text)?;
    let fields = Reader::of("options", &json).fields(&KEYS)?;
    let solver = fields.required("solver", &Solver::ALL.map(Solver::name).join(", "))?;
    let mut options = Options::new(solver.one_of(&Solver::ALL, Solver::name)?);
    if let Some(encoding) = fields.optional("encoding") {
        options.encoding = encoding.one_of(&Encoding::ALL, Encoding::name)?;
    }
    if let Some(horizon) = fields.optional("horizon") {
        options.horizon = match horizon.value() {
            Json::Text(text) if **text == *"any" => Horizon::Any,
            Json::Integer(_) | Json::Large(_) => Horizon::Steps(steps(&horizon)?),
            _ => return Err(horizon.expected("a number of steps, or any")),
        };
    }
    if let Some(step) = fields.optional("horizon_step") {
        options.horizon_step = steps(&step)?;
    }
    if let Some(limit) = fields.optional("horizon_limit") {
        options.horizon_limit = steps(&limit)?;
    }
    let goals = problem.goals().len() as u32;
    let bound = |key| -> Result<Option<usize>, DocumentError> {
        let Some(reader) = fields.optional(key) else { return Ok(None) };
        Ok(Some(reader.integer(1..=goals)? as usize))
    };
    options.bounds.at_least = bound("k")?;
    options.bounds.at_most = bound("j")?;
    options.bounds.required = watched(&fields, "require", problem)?;
    options.bounds.forbidden = watched(&fields, "forbid", problem)?;
    let asked = |key| -> Result<bool, DocumentError> {
        fields.optional(key).map_or(Ok(false), |reader| reader.boolean())
    };
    let (pairs, pareto) = (asked("pairs")?, asked("pareto")?);
    options.pairs = pairs || pareto;
    let old_names = pareto && !pairs;
    if let Some(lengths) = fields.optional("lengths") {
        options.lengths = Some(steps(&lengths)?);
    }
    if let Some(limit) = fields.optional("cost_limit") {
        options.cost_limit = Some(u64::from(limit.integer(0..=u32::MAX)?));
    }
    options.check(problem).map_err(|OptionsError { option, found, expected }| {
        // By the name that was given.
        let option = if option == "pairs" && old_names { "pareto" } else { option };
        DocumentError::invalid(option, found, expected)
    })?;
    Ok(Request { options, old_names })
}

fn steps(reader: &Reader<'_>) -> Result<usize, DocumentError> {
    Ok(reader.integer(0..=MAX_HORIZON as u32)? as usize)
}

fn watched(
    fields: &Fields<'_>,
    key: &str,
    problem: &Problem,
) -> Result<Vec<Watched>, DocumentError> {
    let Some(reader) = fields.optional(key) else { return Ok(Vec::new()) };
    reader.list(|item| {
        let fields = item.fields(&["observer", "goal"])?;
        let observer = fields.required("observer", "the name of an observer")?;
        let goal = fields.required("goal", "the name of a goal")?;
        Ok(Watched {
            observer: problem
                .observer_named(observer.text()?)
                .ok_or_else(|| observer.expected("the name of an observer"))?,
            goal: problem
                .goal_named(goal.text()?)
                .ok_or_else(|| goal.expected("the name of a goal"))?,
        })
    })
}
