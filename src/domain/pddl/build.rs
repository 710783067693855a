//! Makes a problem of a PDDL document.

use std::sync::Arc;

use super::Pddl;
use super::belief::{Believed, Fixed};
use super::sensor::{Eye, Readings};
use crate::document::DocumentError;
use crate::domain::observers::{true_goal, unexpected};
use crate::pddl::{
    Condition, Domain, ExtraInputs, GroundError, Grounded, PddlError, TaskDefinition, ground,
    read_condition, read_domain, read_open_task,
};
use crate::problem::{Goal, Observer, Problem, StateNaming};
use crate::task::Fact;

/// The texts of a document, read.
pub(super) struct Texts {
    pub domain: Domain,
    pub task: TaskDefinition,
    /// The condition of each candidate goal.
    pub goals: Vec<Condition>,
}

impl Pddl {
    /// Checks that everything fits together, grounds the task and makes the problem.
    ///
    /// # Errors
    ///
    /// [`DocumentError`] with the place of what does not fit, inside of PDDL with line and column.
    pub fn problem(&self) -> Result<Problem, DocumentError> {
        let names: Vec<&str> = self.goals.iter().map(|goal| goal.name.as_str()).collect();
        let true_goal = true_goal(&names, &self.true_goal)?;
        let texts = self.texts(true_goal)?;
        let mut extra = ExtraInputs { states: Vec::new(), conditions: texts.goals.clone() };
        let fixed = Fixed::new(self, &texts)?;
        let mut eyes = Vec::new();
        let mut beliefs = Vec::new();
        for (role, observer) in self.observers.iter() {
            let path = format!("observers.{}", role.name());
            eyes.push(Eye::new(observer, &texts, &path)?);
            beliefs.push(Believed::read(observer, &texts, &fixed, &path, &mut extra)?);
        }
        let (grounded, readings) = grounded(&texts, &mut extra, &eyes)?;
        let goals = self.goals.iter().zip(&grounded.conditions).enumerate();
        let condition = |(index, condition): (usize, &Option<Vec<Fact>>)| match condition {
            _ if index == true_goal => grounded.task.goal().to_vec(),
            Some(facts) => facts.clone(),
            None => grounded.never.into_iter().collect(),
        };
        let goals = goals
            .map(|(index, (goal, facts))| Goal {
                name: goal.name.clone(),
                condition: condition((index, facts)),
            })
            .collect();
        let mut observers = Vec::new();
        let seen = eyes.iter().zip(&readings);
        for (((role, _), (eye, readings)), believed) in
            self.observers.iter().zip(seen).zip(&beliefs)
        {
            let path = format!("observers.{}", role.name());
            observers.push(Observer {
                name: role.name().to_owned(),
                role,
                sensor: Arc::new(eye.sensor(&grounded, readings)?),
                initial_belief: believed.states(&grounded, &path)?,
            });
        }
        let positive = |fact: &Fact| matches!(grounded.atom(*fact), Some((_, false)));
        let count = grounded.task.facts().take_while(positive).count();
        let naming = StateNaming::FirstFacts { count };
        Problem::new(grounded.task, goals, true_goal, observers, naming)
            .map_err(|error| unexpected(&error))
    }

    /// Whether the text of the problem itself says what the true goal is.
    pub(crate) fn tells_goal(&self) -> bool {
        let Ok(domain) = read_domain(self.domain.as_str()) else { return false };
        read_open_task(&domain, self.problem.as_str()).is_ok_and(|(_, has_goal)| has_goal)
    }

    /// Reads the PDDL. The goal of the task is the true goal.
    pub(super) fn texts(&self, true_goal: usize) -> Result<Texts, DocumentError> {
        let domain = read_domain(self.domain.as_str()).map_err(|e| at("domain", e))?;
        let (mut task, has_goal) =
            read_open_task(&domain, self.problem.as_str()).map_err(|e| at("problem", e))?;
        if task.domain != domain.name {
            let expected = format!("{:?}, which is the domain's name", domain.name);
            return Err(DocumentError::invalid(
                "problem",
                format!("(:domain {})", task.domain),
                expected,
            ));
        }
        let mut goals = Vec::with_capacity(self.goals.len());
        for (index, goal) in self.goals.iter().enumerate() {
            let condition = read_condition(&domain, &task, &goal.condition);
            goals.push(condition.map_err(|e| at(format!("goals[{index}].condition"), e))?);
        }
        let truth = &goals[true_goal];
        if has_goal && task.goal != *truth {
            let expected =
                format!("that of the true goal {}, or no :goal at all", self.goals[true_goal].name);
            return Err(DocumentError::invalid("problem", "another :goal", expected));
        }
        task.goal = truth.clone();
        Ok(Texts { domain, task, goals })
    }
}

/// An error inside of a PDDL text.
pub(super) fn at(path: impl Into<String>, error: PddlError) -> DocumentError {
    let PddlError { line, column, found, expected } = error;
    DocumentError::Pddl { path: path.into(), line, column, found, expected }
}

pub(super) fn limit(error: &GroundError) -> DocumentError {
    match error {
        GroundError::Ambiguous { .. } => {
            let expected = "actions of one name that exclude each other";
            DocumentError::invalid("domain", error.to_string(), expected)
        }
        error => DocumentError::invalid("problem", error.to_string(), "a smaller task"),
    }
}

/// The ground task, and what each observer reads. Conditions of sensors name operators, which are
/// known only once the task is grounded; where there are such conditions, it is grounded again with
/// them, so that a fact stands for each negation. That changes no operator.
fn grounded(
    texts: &Texts,
    extra: &mut ExtraInputs,
    eyes: &[Eye<'_>],
) -> Result<(Grounded, Vec<Readings>), DocumentError> {
    let ground =
        |extra: &ExtraInputs| ground(&texts.domain, &texts.task, extra).map_err(|e| limit(&e));
    let grounded = ground(extra)?;
    let before = extra.conditions.len();
    let mut readings = Vec::new();
    for eye in eyes {
        readings.push(eye.readings(texts, &grounded, &mut extra.conditions)?);
    }
    if extra.conditions.len() == before {
        return Ok((grounded, readings));
    }
    Ok((ground(extra)?, readings))
}
