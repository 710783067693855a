//! A camera, a wall or a start, placed so that a goal is possible for an observer after a walk, or not.

use std::sync::Arc;

use serde::Serialize;

use super::{Question, Solved, Watching};
use crate::document::DocumentError;
use crate::document::reader::Fields;
use crate::exercise::answer::{Answer, Arity, Form, MAX_CHOICES};
use crate::exercise::belief_layers::{POSSIBLE, called};
use crate::exercise::edit::{BOX, Draft};
use crate::exercise::subject::Subject;
use crate::exercise::verdict::{Finding, Verdict};
use crate::exercise::{Difficulty, Unfit};
use crate::plan::PlanError;
use crate::problem::{Problem, StateLabel};

/// What is placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(in crate::exercise) enum Place {
    /// A camera of the observer.
    Camera,
    /// A wall.
    Wall,
    /// Where the agent or the robot starts.
    Start,
}

impl Place {
    const ALL: [Self; 3] = [Self::Camera, Self::Wall, Self::Start];

    /// The name in documents.
    pub(in crate::exercise) fn name(self) -> &'static str {
        match self {
            Self::Camera => "camera",
            Self::Wall => "wall",
            Self::Start => "start",
        }
    }
}

/// The question.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(in crate::exercise) struct Placement {
    /// The walk and the observer.
    #[serde(flatten)]
    pub(super) watching: Watching,
    /// What is placed.
    pub(super) place: Place,
    /// The name of the goal.
    pub(super) goal: String,
    /// Whether the goal must be possible at the end of the walk.
    pub(super) possible: bool,
}

impl Placement {
    pub(super) fn read(fields: &Fields<'_>) -> Result<Self, DocumentError> {
        let place = fields.required("place", "camera, wall or start")?;
        Ok(Self {
            watching: Watching::read(fields)?,
            place: place.one_of(&Place::ALL, Place::name)?,
            goal: fields.required("goal", "the name of a goal")?.text()?.to_owned(),
            possible: fields.required("possible", "true or false")?.boolean()?,
        })
    }

    /// The goal must be one of the problem.
    pub(super) fn refer(&self, problem: &Problem) -> Result<(), DocumentError> {
        if problem.goal_named(&self.goal).is_some() {
            return Ok(());
        }
        let names: Vec<&str> = problem.goals().iter().map(|goal| goal.name.as_str()).collect();
        let expected = format!("the name of a candidate goal: {}", names.join(", "));
        Err(DocumentError::invalid("exercise.goal", format!("{:?}", self.goal), expected))
    }

    /// The problem with something placed in a cell; the words say why there is none.
    fn placed(&self, subject: &Subject, cell: [u32; 2]) -> Result<Subject, String> {
        let mut draft = Draft::new(&subject.document);
        if draft.walls().contains(&cell) {
            return Err("a wall is there".to_owned());
        }
        match self.place {
            Place::Camera if draft.cameras(&self.watching.observer).contains(&cell) => {
                return Err("a camera is there".to_owned());
            }
            Place::Camera => draft.add_camera(&self.watching.observer, cell),
            Place::Start => draft.set_start(cell),
            Place::Wall => {
                let mut walls = draft.walls();
                walls.push(cell);
                draft.set_walls(&walls);
            }
        }
        let made = draft.finish().and_then(|document| {
            let problem = Arc::new(document.problem()?);
            Ok(Subject { document, problem })
        });
        made.map_err(|error| self.refusal(subject, cell, &error))
    }

    /// Why nothing can be placed in a cell, in the terms of the board.
    fn refusal(&self, subject: &Subject, cell: [u32; 2], error: &DocumentError) -> String {
        let draft = Draft::new(&subject.document);
        if self.place == Place::Wall && draft.start() == Some(cell) {
            return "the start is there".to_owned();
        }
        // A robot may begin where a can or a charger is.
        let blocks = |thing: &&str| self.place == Place::Wall || *thing == BOX;
        if let Some(thing) = draft.lying_at(cell).filter(blocks) {
            return format!("the {thing}");
        }
        let mut goals = subject.goal_names().zip(draft.goals());
        if let Some((name, _)) = goals.find(|&(_, goal)| self.place == Place::Wall && goal == cell)
        {
            return format!("the goal {name} is there");
        }
        let watched = subject.problem.observers().iter().find(|observer| {
            error.to_string().starts_with(&format!("observers.{}.initial_belief", observer.name))
        });
        match (watched, self.place) {
            (Some(observer), Place::Start) => {
                format!("{} does not hold it possible at first", called(observer.role))
            }
            (Some(observer), _) => {
                format!("{} holds it possible at first", called(observer.role))
            }
            // A document's paths are no terms of the board.
            (None, _) => "it does not fit the rest of the problem".to_owned(),
        }
    }

    /// Whether the goal is possible at the end of the walk.
    fn goal_is_possible(&self, subject: &Subject) -> Result<bool, Unfit> {
        let goal = subject.problem.goal_named(&self.goal).unwrap_or_default();
        let layers = self.watching.layers(subject)?;
        Ok(layers.possible(|words| subject.in_goal(goal, words)))
    }

    /// All cells, row by row.
    fn cells(subject: &Subject) -> Result<Vec<[u32; 2]>, Unfit> {
        let draft = Draft::new(&subject.document);
        let [width, height] = draft.size().ok_or_else(|| {
            Unfit::new(format!("a {} document has no cells to place anything in", draft.format()))
        })?;
        if width as usize * height as usize > MAX_CHOICES {
            return Err(Unfit::too_large());
        }
        Ok((0..height).flat_map(|row| (0..width).map(move |column| [column, row])).collect())
    }
}

/// Why a walk cannot be walked to its end.
fn ends_early(error: &PlanError) -> String {
    match error {
        PlanError::NotApplicable { step, action, state, reason } => {
            format!("the walk could not go on at step {step}, {action}, from {state}: {reason}")
        }
        other => other.to_string(),
    }
}

impl Question for Placement {
    fn text(&self, subject: &Subject) -> String {
        let who = self.watching.who(&subject.problem);
        let what = match self.place {
            Place::Camera => format!("Place one more camera of {who}"),
            Place::Wall => "Place one more wall".to_owned(),
            Place::Start => "Place the start".to_owned(),
        };
        let not = if self.possible { "" } else { "not " };
        let walk = match &self.watching.plan[..] {
            [] => "before the first step".to_owned(),
            plan => format!("after the walk {}", plan.join(", ")),
        };
        format!("{what} so that {walk} {} is {not}possible for {who}.", self.goal)
    }

    fn form(&self, subject: &Subject) -> Result<Form, Unfit> {
        let cells = Self::cells(subject)?;
        let choices = cells.iter().map(|&[column, row]| StateLabel::Cell(column, row)).collect();
        Ok(Form { arity: Arity::One, choice: "cell", choices })
    }

    fn solve(&self, subject: &Subject, form: &Form) -> Result<Solved, Unfit> {
        let mut right = Vec::new();
        let cells = Self::cells(subject)?;
        for (place, &cell) in cells.iter().enumerate() {
            let Ok(placed) = self.placed(subject, cell) else { continue };
            if self.goal_is_possible(&placed).is_ok_and(|possible| possible == self.possible) {
                right.push(place as u32);
            }
        }
        let first = right.first().copied();
        let first = first.ok_or_else(|| Unfit::new("no cell answers the question".to_owned()))?;
        let mut remarks = Vec::new();
        if self.goal_is_possible(subject).is_ok_and(|possible| possible == self.possible) {
            remarks.push("it is so before anything is placed".to_owned());
        } else if right.len() * 2 > cells.len() {
            remarks.push("more than half of the cells answer it".to_owned());
        }
        let difficulty = Difficulty { size: right.len(), steps: self.watching.plan.len() };
        let answer = form.answer([first]).ok_or_else(Unfit::too_large)?;
        Ok(Solved { answer, difficulty, remarks })
    }

    fn check(&self, subject: &Subject, answer: &Answer) -> Verdict {
        let cells = Self::cells(subject).unwrap_or_default();
        let cell = answer.choices().first().and_then(|&choice| cells.get(choice as usize));
        let Some(&[column, row]) = cell else {
            return Verdict::wrong([Finding::plain("No cell was chosen.")]);
        };
        let (name, cell) = (self.place.name(), StateLabel::Cell(column, row));
        let fails = |why: &str| {
            let text = format!("The {name} can't be placed in {cell}: {why}.");
            Verdict::wrong([Finding::plain(text)])
        };
        let placed = match self.placed(subject, [column, row]) {
            Ok(placed) => placed,
            Err(why) => return fails(&why),
        };
        if let Err(error) = self.watching.execute(&placed.problem) {
            return fails(&ends_early(&error));
        }
        let mut layers = match self.watching.layers(&placed) {
            Ok(layers) => layers,
            Err(unfit) => return fails(&unfit.to_string()),
        };
        let goal = placed.problem.goal_named(&self.goal).unwrap_or_default();
        let holds = |words: &[u64]| placed.in_goal(goal, words);
        if layers.possible(holds) == self.possible {
            return Verdict::right();
        }
        let finding = layers.finding(&self.goal, POSSIBLE, holds);
        let text = format!("With the {name} in {cell}, {}", finding.text);
        Verdict::wrong([Finding { text, ..finding }])
    }

    fn passes(&self, subject: &Subject) -> u64 {
        let cells = Self::cells(subject).map_or(1, |cells| cells.len() as u64);
        cells * self.watching.passes()
    }
}
