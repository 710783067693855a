//! Task definitions: objects, the initial state and the goal.

use rustc_hash::FxHashSet;

use super::atom::{Atom, Scope};
use super::condition::Condition;
use super::cost::{self, FunctionValues};
use super::domain::{Domain, define, section};
use super::error::PddlError;
use super::expression::{Expression, Expressions, Tree};
use super::feature::{check_requirements, unsupported};
use super::object::Objects;

/// What a task adds to a domain. PDDL calls it a problem; here a
/// [`Problem`](https://en.wikipedia.org/wiki/Automated_planning_and_scheduling) has observers.
#[derive(Debug, Clone)]
pub struct TaskDefinition {
    /// Its name, in small letters.
    pub name: String,
    /// The name of the domain it is for, in small letters. Nothing checks that it is the domain's
    /// own name, since tasks in circulation are careless there.
    pub domain: String,
    /// The constants of the domain and then the objects of the task.
    pub objects: Objects,
    /// What holds in the beginning, sorted.
    pub initial: Vec<Atom>,
    /// The values of the domain's functions.
    pub values: FunctionValues,
    /// Whether plans are to be cheap: there is a `:metric`. Otherwise costs do not count.
    pub has_costs: bool,
    /// What must hold in the end.
    pub goal: Condition,
}

/// Reads a task of a domain.
///
/// # Errors
///
/// [`PddlError`] with the place of what is wrong or not supported.
///
/// ```
/// use mo_copp::pddl::{read_domain, read_task};
/// let domain = read_domain("(define (domain lamp) (:predicates (lit)))")?;
/// let error = read_task(&domain, "(define (problem dark)\n  (:domain lamp) (:goal (lid)))");
/// assert_eq!(
///     error.unwrap_err().to_string(),
///     "line 2, column 26: found the undeclared predicate \"lid\", expected a predicate of the domain: lit"
/// );
/// # Ok::<(), mo_copp::pddl::PddlError>(())
/// ```
pub fn read_task(domain: &Domain, text: &str) -> Result<TaskDefinition, PddlError> {
    let (task, has_goal) = read_open_task(domain, text)?;
    if has_goal { Ok(task) } else { Err(Tree::read(text)?.ends("(:goal …) in the task")) }
}

/// Reads a task that may do without a `:goal`, and whether it has one. The goal is empty where
/// there is none.
///
/// # Errors
///
/// [`PddlError`] with the place of what is wrong or not supported.
pub fn read_open_task(domain: &Domain, text: &str) -> Result<(TaskDefinition, bool), PddlError> {
    const KNOWN: [&str; 7] =
        [":domain", ":requirements", ":objects", ":init", ":goal", ":length", ":metric"];
    let tree = Tree::read(text)?;
    let (name, items) = define(&tree, "problem")?;
    let mut sections: [Option<Expressions<'_>>; 7] = Default::default();
    for item in items {
        const EXPECTED: &str =
            "a section: :domain, :requirements, :objects, :init, :goal or :metric";
        let (head, items) = item.headed(EXPECTED)?;
        if head.is(":metric") {
            cost::metric(&domain.functions, item, items.clone())?;
        }
        section(&mut sections, &KNOWN, (item, head, items), EXPECTED)?;
    }
    // The length is advice to planners of 1998.
    let [of, requirements, objects, initial, goal, _length, metric] = sections;
    let mut of = of.ok_or_else(|| tree.ends("(:domain …) in the task"))?;
    let of = match (of.next(), of.next()) {
        (Some(name), None) => name.name("the name of the domain")?,
        (_, Some(more)) => return Err(more.expected("one name of a domain")),
        (None, None) => return Err(tree.ends("a name in (:domain …)")),
    };
    requirements.map_or(Ok(()), check_requirements)?;
    let mut all = domain.constants.clone();
    objects.map_or(Ok(()), |items| all.read(&domain.types, items))?;
    let scope = scope(domain, &all);
    let mut values = FunctionValues::default();
    let initial = match initial {
        Some(items) => literals(&scope, items, true, Some(&mut values))?.0,
        None => Vec::new(),
    };
    let has_goal = goal.is_some();
    let goal = match goal.map(|mut goal| (goal.next(), goal.next())) {
        None => Condition::default(),
        Some((Some(goal), None)) => Condition::read(&scope, goal)?,
        Some((_, Some(more))) => return Err(more.expected("one condition in (:goal …)")),
        Some((None, None)) => return Err(tree.ends("a condition in (:goal …)")),
    };
    let has_costs = metric.is_some();
    let task = TaskDefinition { name, domain: of, objects: all, initial, values, has_costs, goal };
    Ok((task, has_goal))
}

/// Reads a ground condition over the objects of a task: a goal, a belief, what a sensor sees.
///
/// # Errors
///
/// [`PddlError`] with the place in this text.
///
/// ```
/// use mo_copp::pddl::{read_condition, read_domain, read_task};
/// let domain = read_domain("(define (domain lamps) (:predicates (lit ?lamp)))")?;
/// let task = "(define (problem two) (:domain lamps) (:objects a b) (:goal (lit a)))";
/// let task = read_task(&domain, task)?;
/// let condition = read_condition(&domain, &task, "(and (lit A) (not (lit b)))")?;
/// assert_eq!((condition.positive.len(), condition.negative.len()), (1, 1));
/// # Ok::<(), mo_copp::pddl::PddlError>(())
/// ```
pub fn read_condition(
    domain: &Domain,
    task: &TaskDefinition,
    text: &str,
) -> Result<Condition, PddlError> {
    let tree = Tree::read(text)?;
    let whole = tree.only("a condition, as in (and (on a b) (clear a))")?;
    Condition::read(&scope(domain, &task.objects), whole)
}

/// Reads a state as it stands in an `:init`: ground atoms one after the other, as in
/// `(on a b) (clear a)`. Sorted.
///
/// # Errors
///
/// [`PddlError`] with the place in this text.
pub fn read_state(
    domain: &Domain,
    task: &TaskDefinition,
    text: &str,
) -> Result<Vec<Atom>, PddlError> {
    Ok(read_literals(domain, task, text)?.0)
}

/// Reads ground literals as they stand in an `:init`, one after the other, as in
/// `(on a b) (not (clear b))`: the atoms that hold and those that do not, both sorted.
///
/// # Errors
///
/// [`PddlError`] with the place in this text.
pub fn read_literals(
    domain: &Domain,
    task: &TaskDefinition,
    text: &str,
) -> Result<(Vec<Atom>, Vec<Atom>), PddlError> {
    let tree = Tree::read(text)?;
    literals(&scope(domain, &task.objects), tree.expressions(), true, None)
}

/// Reads ground atoms, one after the other, as in `(on a b) (clear a)`. Sorted.
///
/// # Errors
///
/// [`PddlError`] with the place in this text, also for a negated atom.
pub fn read_atoms(
    domain: &Domain,
    task: &TaskDefinition,
    text: &str,
) -> Result<Vec<Atom>, PddlError> {
    let tree = Tree::read(text)?;
    Ok(literals(&scope(domain, &task.objects), tree.expressions(), false, None)?.0)
}

fn scope<'a>(domain: &'a Domain, objects: &'a Objects) -> Scope<'a> {
    Scope {
        types: &domain.types,
        predicates: &domain.predicates,
        objects,
        functions: &domain.functions,
        parameters: None,
    }
}

/// Whether a number and a list come first, as behind the `at` of a timed initial literal. No atom
/// holds a list, so that a predicate `at` can be told from it.
fn is_timed(mut items: Expressions<'_>) -> bool {
    let number = items.next().and_then(Expression::symbol);
    number.is_some_and(|time| time.parse::<f64>().is_ok())
        && items.next().is_some_and(|literal| literal.list().is_some())
}

/// The atoms that hold and those that do not. A negated one must not contradict the others; none may
/// be there where `negation` is not allowed.
fn literals(
    scope: &Scope<'_>,
    items: Expressions<'_>,
    negation: bool,
    mut values: Option<&mut FunctionValues>,
) -> Result<(Vec<Atom>, Vec<Atom>), PddlError> {
    const EXPECTED: &str = "an atom, as in (on a b)";
    let mut atoms = Vec::new();
    let mut negated: Vec<(Expression<'_>, Atom)> = Vec::new();
    for item in items {
        let (head, mut items) = item.headed(EXPECTED)?;
        if head.is("not") {
            if !negation {
                return Err(item.expected(EXPECTED));
            }
            let (Some(inner), None) = (items.next(), items.next()) else {
                return Err(item.expected("(not …) with one atom"));
            };
            let (head, items) = inner.headed(EXPECTED)?;
            negated.extend(scope.atom(inner, head, items)?.ground().map(|atom| (item, atom)));
            continue;
        }
        let declared = |name: &str| scope.predicates.named(&name.to_ascii_lowercase()).is_some();
        if head.is("=") {
            if let Some(values) = values.as_deref_mut()
                && !scope.functions.is_empty()
            {
                values.read(scope, item, items)?;
                continue;
            }
            let found = format!("{}, which needs :action-costs or :numeric-fluents", item.shown());
            return Err(item.wrong(found, EXPECTED));
        }
        let is_timed = head.is("at") && is_timed(items.clone());
        if (is_timed || !head.symbol().is_some_and(declared))
            && let Some(error) = unsupported(item, head)
        {
            return Err(error);
        }
        atoms.extend(scope.atom(item, head, items)?.ground());
    }
    atoms.sort_unstable();
    atoms.dedup();
    let positive: FxHashSet<&Atom> = atoms.iter().collect();
    if let Some((place, _)) = negated.iter().find(|(_, atom)| positive.contains(atom)) {
        let found = format!("{} beside the atom itself", place.shown());
        return Err(place.wrong(found, "one of them"));
    }
    let mut negated: Vec<Atom> = negated.into_iter().map(|(_, atom)| atom).collect();
    negated.sort_unstable();
    negated.dedup();
    Ok((atoms, negated))
}
