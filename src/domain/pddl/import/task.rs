//! Import of a competition task: a domain and a task in PDDL, as planners take them.
//!
//! A task has one goal, which becomes the true one. The other candidate goals say the same of its objects in another
//! order ([`Permutations`]): the packages go to the same places, and which goes where is the question.

use super::super::{Pddl, PddlGoal, PddlText};
use super::permutation::Permutations;
use super::{ImportError, ImportFile, ImportOptions, Imported, in_file, observers, tidy, trimmed};
use crate::domain::generate::random;
use crate::pddl::{Atom, Condition, Domain, Reachable, TaskDefinition, read_domain, read_task};
use crate::problem::MAX_GOALS;

/// The candidate goals of a task.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CandidateOptions {
    /// How many, the true one among them.
    pub candidates: usize,
    /// The seed of the permutations.
    pub seed: u64,
}

/// As many as the problems of Figure 4 have.
impl Default for CandidateOptions {
    fn default() -> Self {
        Self { candidates: 5, seed: 1 }
    }
}

/// Makes a document of a task: its goal is the true one, `G1`, and `G2`, `G3`, … are drawn.
///
/// # Arguments
///
/// - `domain` and `task`: the two files.
/// - `options`: the sensors and groups of the observers; a number of a true goal does not matter here.
/// - `candidates`: how many candidate goals, and the seed, which gives the same ones everywhere.
///
/// # Errors
///
/// [`ImportError`] with the file, and the place in it, of what cannot be read, and where the objects of the goal have
/// too few permutations that give different goals.
///
/// ```
/// use mo_copp::domain::pddl::import::{CandidateOptions, ImportFile, ImportOptions, import_task};
/// let file = |name: &str, text: &str| ImportFile { name: name.into(), text: text.into() };
/// let domain = file("domain.pddl", "(define (domain d) (:predicates (on ?x ?y))
///    (:action put :parameters (?x ?y) :effect (on ?x ?y)))");
/// let task = file("p01.pddl", "(define (problem p) (:domain d) (:objects a b c)
///    (:init) (:goal (on a b)))");
/// let candidates = CandidateOptions { candidates: 2, seed: 1 };
/// let imported = import_task(&domain, &task, &ImportOptions::default(), candidates)?;
/// let goals: Vec<_> = imported.document.goals.iter().map(|goal| &*goal.condition).collect();
/// assert_eq!(goals, ["(on a b)", "(on b a)"]);
/// # Ok::<(), mo_copp::domain::pddl::import::ImportError>(())
/// ```
pub fn import_task(
    domain: &ImportFile,
    task: &ImportFile,
    options: &ImportOptions,
    candidates: CandidateOptions,
) -> Result<Imported, ImportError> {
    let CandidateOptions { candidates: count, seed } = candidates;
    if !(2..=MAX_GOALS).contains(&count) {
        return Err(ImportError::Option {
            option: "candidates",
            found: count.to_string(),
            expected: format!("a whole number from 2 to {MAX_GOALS}"),
        });
    }
    let (domain_text, task_text) = (tidy(&domain.text), tidy(&task.text));
    let read = read_domain(&domain_text).map_err(in_file(domain))?;
    let definition = read_task(&read, &task_text).map_err(in_file(task))?;
    let wrong = |found: String, expected: String| ImportError::File {
        file: task.name.clone(),
        found,
        expected,
    };
    if definition.domain != read.name {
        let expected =
            format!("{:?}, which is the name of the domain in {}", read.name, domain.name);
        return Err(wrong(format!("(:domain {})", definition.domain), expected));
    }
    if !definition.goal.clauses.is_empty() || definition.goal.is_false {
        let expected = "a conjunction of literals, whose objects can change places";
        return Err(wrong("a goal with a disjunction".to_owned(), expected.to_owned()));
    }
    let reachable = Reachable::new(&read, &definition)
        .map_err(|limit| wrong(limit.to_string(), "a smaller task".to_owned()))?;
    let holds = |goal: &Condition| goal.holds(&|atom| is_initial(&definition, atom));
    let wanted = |goal: &Condition| goal.positive.iter().all(|atom| reachable.contains(atom));
    let permutations = Permutations::new(&read, &definition);
    let goals = permutations.goals(count, &mut random(seed), wanted, holds);
    if goals.len() < count {
        let found = format!("{} with other objects of the goal in their places", goals_of(&goals));
        let expected = format!("{count} candidate goals (--candidates)");
        return Err(wrong(found, expected));
    }
    let named = |(number, goal): (usize, &Condition)| PddlGoal {
        name: format!("G{}", number + 1),
        condition: written(&read, &definition, goal),
    };
    let named: Vec<PddlGoal> = goals.iter().enumerate().map(named).collect();
    let notes = goals.iter().zip(&named).filter(|(goal, _)| holds(goal)).map(|(_, goal)| {
        format!("{}: the candidate goal {} holds at the start", task.name, goal.name)
    });
    let notes = notes.collect();
    let document = Pddl {
        domain: PddlText::new(trimmed(&domain_text)),
        problem: PddlText::new(trimmed(&task_text)),
        goals: named,
        true_goal: "G1".to_owned(),
        observers: observers(&read, options)?,
    };
    Ok(Imported { document, observations: None, notes })
}

fn is_initial(task: &TaskDefinition, atom: &Atom) -> bool {
    task.initial.binary_search(atom).is_ok()
}

/// How many goals were found, in words.
fn goals_of(goals: &[Condition]) -> String {
    match goals.len() {
        1 => "no other goal".to_owned(),
        count => format!("{count} different goals"),
    }
}

/// A conjunction of literals in PDDL.
fn written(domain: &Domain, task: &TaskDefinition, goal: &Condition) -> String {
    let positive = goal.positive.iter().map(|atom| atom.written(domain, &task.objects));
    let negative = goal.negative.iter().map(|atom| atom.written(domain, &task.objects));
    let literals = positive.chain(negative.map(|atom| format!("(not {atom})")));
    match literals.collect::<Vec<_>>().as_slice() {
        [only] => only.clone(),
        several => format!("(and {})", several.join(" ")),
    }
}
