//! Import of goal-recognition problems and of competition tasks.
//!
//! The layout of the former is that of Ramírez and Geffner (2010, doi:10.1609/aaai.v24i1.7745): `domain.pddl`, `template.pddl` whose
//! goal is the text `<HYPOTHESIS>`, `hyps.dat` with one candidate goal a line, `real_hyp.dat`, and `obs.dat` with the
//! actions that were seen. A competition task ([`import_task`]) has one goal, and the others are made of it. Files are given as texts; where they come from is the caller's business.

mod hypotheses;
mod permutation;
mod sensors;
mod task;
mod template;

use thiserror::Error;

use super::{Pddl, PddlGoal, PddlObserver, PddlText};
use crate::domain::Observers;
use crate::pddl::{Domain, PddlError, read_condition, read_domain, read_open_task};

use hypotheses::{Hypothesis, Line, hypotheses, lines};
use template::Template;

pub use task::{CandidateOptions, import_task};

/// The names of the files, in the order in which they are read.
pub const FILES: [&str; 5] =
    ["domain.pddl", "template.pddl", "hyps.dat", "real_hyp.dat", "obs.dat"];

/// A file of a problem. Its name may have folders in front of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ImportFile {
    /// The name.
    pub name: String,
    /// What it holds.
    pub text: String,
}

/// What the files leave open.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ImportOptions {
    /// The enemy's template of symbols.
    pub adversarial_sensor: String,
    /// The friend's template of symbols.
    pub cooperative_sensor: String,
    /// Objects that look alike to the enemy, by the name under which it sees them.
    pub adversarial_groups: Vec<(String, Vec<String>)>,
    /// The same for the friend.
    pub cooperative_groups: Vec<(String, Vec<String>)>,
    /// The true goal as a number in `hyps.dat`, from 1; that of `real_hyp.dat` when left out.
    pub true_goal: Option<usize>,
}

/// The sensors of the paper: lifted names for the enemy, with the first argument for the friend.
impl Default for ImportOptions {
    fn default() -> Self {
        Self {
            adversarial_sensor: "{name}".to_owned(),
            cooperative_sensor: "{name} {1}".to_owned(),
            adversarial_groups: Vec::new(),
            cooperative_groups: Vec::new(),
            true_goal: None,
        }
    }
}

/// A problem, imported.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Imported {
    /// The document.
    pub document: Pddl,
    /// The actions of `obs.dat`, as a document's plans name them.
    pub observations: Option<Vec<String>>,
    /// What was left out of the files.
    pub notes: Vec<String>,
}

/// Why files cannot be imported.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ImportError {
    /// Something in a file.
    #[error("{file}:{line}:{column}: found {found}, expected {expected}")]
    Place {
        /// Its name.
        file: String,
        /// The line, from 1.
        line: usize,
        /// The column in characters, from 1.
        column: usize,
        /// What stands there.
        found: String,
        /// What should.
        expected: String,
    },
    /// A file that is not there, or there twice.
    #[error("{file}: found {found}, expected {expected}")]
    File {
        /// Its name.
        file: String,
        /// What was found.
        found: String,
        /// What was expected.
        expected: String,
    },
    /// An option that does not fit the files.
    #[error("{option}: found {found}, expected {expected}")]
    Option {
        /// The option.
        option: &'static str,
        /// What was given.
        found: String,
        /// What may be.
        expected: String,
    },
}

/// The file of this name, whatever folder it is in and in whatever letters its name is written.
fn find<'a>(files: &'a [ImportFile], name: &str) -> Result<Option<&'a ImportFile>, ImportError> {
    let base = |file: &ImportFile| {
        file.name.rsplit(['/', '\\']).next().unwrap_or_default().eq_ignore_ascii_case(name)
    };
    let mut found = files.iter().filter(|file| base(file));
    let first = found.next();
    match (first, found.next()) {
        (Some(one), Some(other)) => Err(ImportError::File {
            file: other.name.clone(),
            found: format!("a second {name} beside {}", one.name),
            expected: "the files of one problem".to_owned(),
        }),
        _ => Ok(first),
    }
}

fn required<'a>(files: &'a [ImportFile], name: &str) -> Result<&'a ImportFile, ImportError> {
    find(files, name)?.ok_or_else(|| ImportError::File {
        file: name.to_owned(),
        found: "no such file".to_owned(),
        expected: format!("the files of a goal-recognition problem: {}", FILES.join(", ")),
    })
}

/// An error of PDDL in a file.
fn in_file(file: &ImportFile) -> impl Fn(PddlError) -> ImportError + '_ {
    |error| ImportError::Place {
        file: file.name.clone(),
        line: error.line,
        column: error.column,
        found: error.found,
        expected: error.expected,
    }
}

/// Makes a document of the files of a problem. Files of other names are passed over.
///
/// # Errors
///
/// [`ImportError`] with the file, and the place in it, of what cannot be read.
///
/// ```
/// use mo_copp::domain::pddl::import::{ImportFile, ImportOptions, import};
/// let file = |name: &str, text: &str| ImportFile { name: name.into(), text: text.into() };
/// let files = [
///     file("domain.pddl", "(define (domain d) (:predicates (lit ?x))
///        (:action light :parameters (?x) :effect (lit ?x)))"),
///     file("template.pddl", "(define (problem p) (:domain d) (:objects a b)
///        (:init) (:goal (and <HYPOTHESIS>)))"),
///     file("hyps.dat", "(LIT A)\n(lit b), (lit a)\n"),
///     file("real_hyp.dat", "(lit a) (lit b)\n"),
/// ];
/// let imported = import(&files, &ImportOptions::default())?;
/// assert_eq!(imported.document.goals[1].condition, "(and (lit b) (lit a))");
/// assert_eq!(imported.document.true_goal, "G2");
/// # Ok::<(), mo_copp::domain::pddl::import::ImportError>(())
/// ```
pub fn import(files: &[ImportFile], options: &ImportOptions) -> Result<Imported, ImportError> {
    let domain_file = required(files, "domain.pddl")?;
    let template_file = required(files, "template.pddl")?;
    let hyps_file = required(files, "hyps.dat")?;
    let domain_text = tidy(&domain_file.text);
    let domain = read_domain(&domain_text).map_err(in_file(domain_file))?;
    let template = Template::read(template_file)?;
    let task = read_open_task(&domain, &template.problem).map_err(in_file(template_file))?.0;
    let (all, mut notes) = hypotheses(hyps_file)?;
    for hypothesis in all.iter().filter(|hypothesis| hypothesis.same_as.is_none()) {
        read_condition(&domain, &task, &hypothesis.line.text)
            .map_err(|error| hypothesis.line.wrong(&hyps_file.name, &error))?;
    }
    let (truth, note) = true_goal(files, &all, options)?;
    notes.extend(note);
    let goals = all.iter().filter(|hypothesis| hypothesis.same_as.is_none());
    let goals: Vec<PddlGoal> = goals
        .map(|hypothesis| PddlGoal {
            name: hypothesis.name(),
            condition: template.condition(&hypothesis.line.text),
        })
        .collect();
    if goals.len() < 2 {
        return Err(ImportError::File {
            file: hyps_file.name.clone(),
            found: format!("{} different hypotheses", goals.len()),
            expected: "2 at least".to_owned(),
        });
    }
    let document = Pddl {
        domain: PddlText::new(trimmed(&domain_text)),
        problem: PddlText::new(trimmed(&template.problem)),
        goals,
        true_goal: truth.name(),
        observers: observers(&domain, options)?,
    };
    let observations = find(files, "obs.dat")?.map(observations).transpose()?;
    Ok(Imported { document, observations, notes })
}

/// The observers, who know the initial state.
fn observers(
    domain: &Domain,
    options: &ImportOptions,
) -> Result<Observers<PddlObserver>, ImportError> {
    let observer = |option, sensor: &str, groups: &[(String, Vec<String>)]| {
        let sensor = sensors::sensor(domain, option, sensor)?;
        Ok(PddlObserver { initial_belief: None, groups: groups.to_vec(), sensor })
    };
    Ok(Observers {
        adversarial: observer(
            "adversarial-sensor",
            &options.adversarial_sensor,
            &options.adversarial_groups,
        )?,
        cooperative: observer(
            "cooperative-sensor",
            &options.cooperative_sensor,
            &options.cooperative_groups,
        )?,
    })
}

/// How many hypotheses the files have, those that stand there twice counted twice.
///
/// # Errors
///
/// [`ImportError`] where they cannot be read.
pub fn hypothesis_count(files: &[ImportFile]) -> Result<usize, ImportError> {
    Ok(hypotheses(required(files, "hyps.dat")?)?.0.len())
}

/// The true goal, and a note where it was chosen without `real_hyp.dat`.
fn true_goal<'a>(
    files: &[ImportFile],
    all: &'a [Hypothesis],
    options: &ImportOptions,
) -> Result<(&'a Hypothesis, Option<String>), ImportError> {
    let first = |hypothesis: &'a Hypothesis| hypothesis.same_as.map_or(hypothesis, |n| &all[n]);
    if let Some(number) = options.true_goal {
        let wanted = number.checked_sub(1).and_then(|index| all.get(index));
        return wanted.map(|found| (first(found), None)).ok_or_else(|| ImportError::Option {
            option: "true-goal",
            found: number.to_string(),
            expected: format!(
                "a number from 1 to {}, which is how many hypotheses there are",
                all.len()
            ),
        });
    }
    let missing = |file: &str, found: &str| ImportError::File {
        file: file.to_owned(),
        found: found.to_owned(),
        expected: "the real hypothesis, or the option true-goal with its number".to_owned(),
    };
    let file =
        find(files, "real_hyp.dat")?.ok_or_else(|| missing("real_hyp.dat", "no such file"))?;
    let mut read = lines(file)?.into_iter();
    let Some(line) = read.next() else { return Err(missing(&file.name, "nothing in it")) };
    let place = |line: &Line, found: &str, expected: String| ImportError::Place {
        file: file.name.clone(),
        line: line.number,
        column: 1,
        found: found.to_owned(),
        expected,
    };
    if let Some(second) = read.find(|other| other.literals() != line.literals()) {
        return Err(place(&second, "a second real hypothesis", "one".to_owned()));
    }
    let found = all.iter().find(|hypothesis| hypothesis.line.literals() == line.literals());
    let expected = || format!("one of the {} hypotheses of hyps.dat", all.len());
    let found = found.ok_or_else(|| place(&line, &line.text, expected()))?;
    Ok((first(found), None))
}

/// The actions of `obs.dat`.
fn observations(file: &ImportFile) -> Result<Vec<String>, ImportError> {
    let mut actions = Vec::new();
    for line in lines(file)? {
        actions.extend(line.literals);
    }
    Ok(actions)
}

/// A text with line ends of one kind.
fn tidy(text: &str) -> String {
    text.trim_start_matches('\u{feff}').replace("\r\n", "\n").replace('\r', "\n")
}

/// A text without blanks at the ends of lines and blank lines around it.
fn trimmed(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    let mut kept: Vec<&str> = Vec::with_capacity(lines.len());
    for line in lines {
        if !line.is_empty() || kept.last().is_some_and(|last| !last.is_empty()) {
            kept.push(line);
        }
    }
    kept.join("\n").trim_end().replace('\t', "    ")
}
