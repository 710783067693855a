//! Makes a task, and checks once what the rest of the program relies on.

use std::sync::{Arc, OnceLock};

use rustc_hash::FxHashMap;
use thiserror::Error;

use super::Task;
use super::fact::{Fact, Layout};
use super::operator::{Action, Operator};
use super::successors::SuccessorGenerator;

/// Why a task cannot be made.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum TaskError {
    /// Two operators of one action may both be applicable in one state.
    #[error(
        "action {action}: its operators do not exclude each other, so one state could have two successors"
    )]
    AmbiguousAction {
        /// The name of the action.
        action: String,
    },
    /// Facts declared exclusive can hold together.
    #[error(
        "facts {first} and {second} were declared to exclude each other, but {place} can make both hold"
    )]
    NotExclusive {
        /// One of the facts.
        first: String,
        /// The other one.
        second: String,
        /// The operator's action, or the initial state.
        place: String,
    },
}

/// Collects facts and operators, then checks them.
///
/// ```
/// use mo_copp::task::TaskBuilder;
/// let mut task = TaskBuilder::default();
/// let home = task.fact("at home");
/// let work = task.fact("at work");
/// task.exclusive(vec![home, work]);
/// task.operator("go", &[home], &[work], &[home]);
/// let task = task.build(&[home], &[work])?;
/// assert_eq!(task.action_count(), 1);
/// assert!(!task.satisfies(task.initial_state().words(), task.goal()));
/// # Ok::<(), mo_copp::task::TaskError>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct TaskBuilder {
    fact_names: Vec<String>,
    action_names: Vec<String>,
    actions: FxHashMap<String, Action>,
    operators: Vec<Operator>,
    groups: Vec<Vec<Fact>>,
    costs: Option<Vec<u64>>,
}

impl TaskBuilder {
    /// Adds a fact.
    pub fn fact(&mut self, name: impl Into<String>) -> Fact {
        self.fact_names.push(name.into());
        Fact::new(self.fact_names.len() - 1)
    }

    /// The action of this name, added when it is new.
    pub fn action(&mut self, name: &str) -> Action {
        if let Some(&action) = self.actions.get(name) {
            return action;
        }
        let action = Action::new(self.action_names.len());
        self.action_names.push(name.to_owned());
        self.actions.insert(name.to_owned(), action);
        action
    }

    /// Adds an operator of the action of this name.
    pub fn operator(
        &mut self,
        action: &str,
        preconditions: &[Fact],
        add: &[Fact],
        delete: &[Fact],
    ) {
        let action = self.action(action);
        let sorted = |facts: &[Fact]| {
            let mut facts = facts.to_vec();
            facts.sort_unstable();
            facts.dedup();
            facts.into_boxed_slice()
        };
        self.operators.push(Operator {
            action,
            preconditions: sorted(preconditions),
            add: sorted(add),
            delete: sorted(delete),
        });
    }

    /// Says what an action costs. Once one cost is known, all others are 0 until they are said.
    pub fn cost(&mut self, action: Action, cost: u64) {
        let costs = self.costs.get_or_insert_default();
        costs.resize(costs.len().max(action.index() + 1), 0);
        costs[action.index()] = cost;
    }

    /// Declares that at most one of these facts holds in any state; [`build`](Self::build) proves
    /// it. A fact that is in several such groups is packed with those of the first.
    pub fn exclusive(&mut self, group: Vec<Fact>) {
        self.groups.push(group);
    }

    /// Checks everything and makes the task.
    ///
    /// # Errors
    ///
    /// [`TaskError`] where an action could have two successors in a state, or facts that were
    /// declared exclusive are not.
    pub fn build(mut self, initial: &[Fact], goal: &[Fact]) -> Result<Task, TaskError> {
        self.drop_superfluous();
        let groups_of = self.groups_of();
        let mut held = vec![None; self.groups.len()];
        for &fact in initial {
            for &group in &groups_of[fact.index()] {
                match held[group as usize].replace(fact) {
                    Some(other) if other != fact => {
                        return Err(self.not_exclusive(other, fact, "the initial state"));
                    }
                    _ => {}
                }
            }
        }
        for operator in &self.operators {
            self.check_groups(&groups_of, operator)?;
        }
        let layout = Layout::new(self.fact_names.len(), &self.fields());
        let initial_state = layout
            .pack(initial)
            .map_err(|(first, second)| self.not_exclusive(first, second, "the initial state"))?;
        self.check_actions(&groups_of)?;
        let actions = self.action_names.len();
        let alike = self.has_operators_alike();
        let successors = SuccessorGenerator::new(&layout, &self.operators);
        Ok(Task {
            fact_names: self.fact_names.into_iter().map(Arc::from).collect(),
            layout,
            action_names: self.action_names,
            operators: self.operators,
            alike,
            initial_state,
            goal: goal.to_vec(),
            costs: self.costs.map(|mut costs| {
                costs.resize(actions, 0);
                costs.into_boxed_slice()
            }),
            successors,
            group_order: OnceLock::new(),
        })
    }

    fn not_exclusive(&self, first: Fact, second: Fact, place: &str) -> TaskError {
        TaskError::NotExclusive {
            first: self.fact_names[first.index()].clone(),
            second: self.fact_names[second.index()].clone(),
            place: place.to_owned(),
        }
    }

    /// The groups of each fact.
    fn groups_of(&self) -> Vec<Vec<u32>> {
        let mut groups_of = vec![Vec::new(); self.fact_names.len()];
        for (number, group) in (0..).zip(&self.groups) {
            for fact in group {
                groups_of[fact.index()].push(number);
            }
        }
        groups_of
    }

    /// The groups without the facts that are in an earlier one.
    fn fields(&self) -> Vec<Vec<Fact>> {
        let mut taken = vec![false; self.fact_names.len()];
        let mut fields = self.groups.clone();
        for field in &mut fields {
            field.retain(|fact| !std::mem::replace(&mut taken[fact.index()], true));
        }
        fields.retain(|field| !field.is_empty());
        fields
    }

    /// An operator that adds a fact of a group must add no other of it and take the one that held
    /// before away: it requires one of the group, and either adds that same one or deletes it.
    /// Where it requires two of the group it is never applicable.
    fn check_groups(&self, groups_of: &[Vec<u32>], operator: &Operator) -> Result<(), TaskError> {
        for (position, &fact) in operator.add.iter().enumerate() {
            for &group in &groups_of[fact.index()] {
                let of_group = |other: &&Fact| groups_of[other.index()].contains(&group);
                let mut held = operator.preconditions.iter().filter(of_group);
                let second = match (held.next(), held.next()) {
                    (Some(_), Some(_)) => continue,
                    (Some(held), None) if *held == fact || operator.delete.contains(held) => {
                        operator.add[position + 1..].iter().find(of_group)
                    }
                    // Without any of the group required, all others must go.
                    _ => self.groups[group as usize].iter().find(|other| {
                        let goes = operator.delete.contains(other) && !operator.add.contains(other);
                        **other != fact && !goes
                    }),
                };
                if let Some(&second) = second {
                    let name = &self.action_names[operator.action.index()];
                    return Err(self.not_exclusive(fact, second, name));
                }
            }
        }
        Ok(())
    }

    /// Leaves out an operator where another one of its action does the same and asks for no more.
    fn drop_superfluous(&mut self) {
        let mut by_action: Vec<Vec<usize>> = vec![Vec::new(); self.action_names.len()];
        for (place, operator) in self.operators.iter().enumerate() {
            by_action[operator.action.index()].push(place);
        }
        let mut kept = vec![true; self.operators.len()];
        for places in by_action.iter().filter(|places| places.len() > 1) {
            let effects =
                |place: usize| (&self.operators[place].add, &self.operators[place].delete);
            let mut places = places.clone();
            places
                .sort_by_key(|&place| (effects(place), self.operators[place].preconditions.len()));
            for alike in places.chunk_by(|&a, &b| effects(a) == effects(b)) {
                for (count, &place) in alike.iter().enumerate() {
                    let asked = &self.operators[place].preconditions;
                    kept[place] = !alike[..count].iter().any(|&other| {
                        let less = &self.operators[other].preconditions;
                        kept[other] && less.iter().all(|fact| asked.contains(fact))
                    });
                }
            }
        }
        let mut place = 0;
        self.operators.retain(|_| {
            place += 1;
            kept[place - 1]
        });
    }

    /// Whether two operators of one action do the same.
    fn has_operators_alike(&self) -> bool {
        let mut known = rustc_hash::FxHashSet::default();
        let all = &self.operators;
        all.iter().any(|one| !known.insert((one.action, &one.add, &one.delete)))
    }

    /// No two operators of an action that do different things may be applicable in one state.
    fn check_actions(&self, groups_of: &[Vec<u32>]) -> Result<(), TaskError> {
        let mut by_action: Vec<Vec<&Operator>> = vec![Vec::new(); self.action_names.len()];
        for operator in &self.operators {
            by_action[operator.action.index()].push(operator);
        }
        match by_action.iter_mut().position(|operators| !exclude_each_other(groups_of, operators)) {
            None => Ok(()),
            Some(index) => {
                Err(TaskError::AmbiguousAction { action: self.action_names[index].clone() })
            }
        }
    }
}

/// Whether at most one of these operators is applicable in any state, as far as the groups tell:
/// split by the groups that all of them ask for, then each part by the groups that all of the part
/// ask for, and so on, until operators stand alone.
fn exclude_each_other(groups_of: &[Vec<u32>], operators: &mut [&Operator]) -> bool {
    let [first, rest @ ..] = &*operators else { return true };
    // Which of several that do the same is meant makes no difference.
    if rest.iter().all(|operator| operator.has_effects_of(first)) {
        return true;
    }
    let value = |operator: &Operator, group: u32| {
        let is_of = |fact: &&Fact| groups_of[fact.index()].contains(&group);
        operator.preconditions.iter().find(is_of).copied()
    };
    let mut groups: Vec<u32> =
        first.preconditions.iter().flat_map(|fact| &groups_of[fact.index()]).copied().collect();
    groups.retain(|&group| rest.iter().all(|operator| value(operator, group).is_some()));
    let asked = |operator: &Operator| -> Vec<Option<Fact>> {
        groups.iter().map(|&group| value(operator, group)).collect()
    };
    let count = operators.len();
    operators.sort_by_cached_key(|operator| asked(operator));
    operators
        .chunk_by_mut(|a, b| asked(a) == asked(b))
        .all(|part| part.len() < count && exclude_each_other(groups_of, part))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_operators_of_an_action_must_exclude_each_other() {
        let mut task = TaskBuilder::default();
        let (a, b) = (task.fact("a"), task.fact("b"));
        task.operator("go", &[a], &[b], &[]);
        task.operator("go", &[b], &[a], &[]);
        let error = task.clone().build(&[a], &[b]).map(|_| ()).unwrap_err();
        assert_eq!(error, TaskError::AmbiguousAction { action: "go".into() });
        let mut task = TaskBuilder::default();
        let (a, b) = (task.fact("a"), task.fact("b"));
        task.exclusive(vec![a, b]);
        task.operator("go", &[a], &[b], &[a]);
        task.operator("go", &[b], &[a], &[b]);
        assert!(task.build(&[a], &[b]).is_ok());
    }

    #[test]
    fn an_operator_that_another_makes_superfluous_is_left_out() {
        let mut task = TaskBuilder::default();
        let (cup, milk, tea) = (task.fact("cup"), task.fact("milk"), task.fact("tea"));
        task.operator("make tea", &[cup, milk], &[tea], &[]);
        task.operator("make tea", &[cup], &[tea], &[]);
        task.operator("make tea", &[cup], &[tea], &[]);
        let built = task.clone().build(&[cup], &[tea]).unwrap();
        assert_eq!(built.operators().len(), 1);
        assert_eq!(built.operators()[0].preconditions, [cup].into());
        // Where neither asks for less, both stay, and one of them is taken.
        task.operator("make coffee", &[cup], &[tea], &[]);
        task.operator("make coffee", &[milk], &[tea], &[]);
        let built = task.clone().build(&[cup, milk], &[tea]).unwrap();
        assert_eq!(built.operators().len(), 3);
        let mut found = Vec::new();
        built.applicable(built.initial_state().words(), &mut found);
        let actions: Vec<_> = found.iter().map(|id| built.operator(*id).action).collect();
        assert_eq!(
            actions.iter().map(|a| built.action_name(*a)).collect::<Vec<_>>(),
            ["make tea", "make coffee"]
        );
        // With another effect it is another operator.
        task.operator("make tea", &[cup, milk], &[tea], &[milk]);
        let error = task.build(&[cup], &[tea]).map(|_| ()).unwrap_err();
        assert_eq!(error, TaskError::AmbiguousAction { action: "make tea".into() });
    }

    /// Walking and pushing ask for the same cell of the robot, then for different things in front.
    #[test]
    fn operators_may_differ_in_what_a_part_of_them_asks_for() {
        let mut task = TaskBuilder::default();
        let robot: Vec<Fact> = (0..2).map(|cell| task.fact(format!("robot {cell}"))).collect();
        let clear: Vec<Fact> = (0..2).map(|cell| task.fact(format!("clear {cell}"))).collect();
        let boxed: Vec<Fact> = (0..2).map(|cell| task.fact(format!("box {cell}"))).collect();
        task.exclusive(robot.clone());
        task.exclusive(vec![clear[0], boxed[0]]);
        task.exclusive(vec![clear[1], boxed[1]]);
        for (from, to) in [(0, 1), (1, 0)] {
            task.operator("go", &[robot[from], clear[to]], &[robot[to]], &[robot[from]]);
            task.operator("go", &[robot[from], boxed[to]], &[], &[]);
        }
        assert!(task.clone().build(&[robot[0], clear[0], clear[1]], &[]).is_ok());
        task.operator("go", &[robot[0]], &[], &[]);
        let error = task.build(&[robot[0]], &[]).map(|_| ()).unwrap_err();
        assert_eq!(error, TaskError::AmbiguousAction { action: "go".into() });
    }

    #[test]
    fn a_fact_of_two_groups_is_packed_with_the_first() {
        // A block lies on the table or is held; the hand is empty or holds it.
        let mut task = TaskBuilder::default();
        let [table, held, empty] = ["on the table", "held", "empty hand"].map(|f| task.fact(f));
        task.exclusive(vec![table, held]);
        task.exclusive(vec![held, empty]);
        task.operator("take", &[table, empty], &[held], &[table, empty]);
        task.operator("drop", &[held], &[table, empty], &[held]);
        let built = task.clone().build(&[table, empty], &[held]).unwrap();
        assert_eq!(built.layout().group_count(), 2);
        assert_eq!(built.layout().group(table), built.layout().group(held));
        // The second group is proved all the same.
        task.operator("grab", &[table], &[held], &[table]);
        let error = task.clone().build(&[table, empty], &[held]).map(|_| ()).unwrap_err();
        assert!(matches!(error, TaskError::NotExclusive { ref place, .. } if place == "grab"));
        let error = task.build(&[held, empty], &[held]).map(|_| ()).unwrap_err();
        assert!(error.to_string().contains("the initial state"), "{error}");
    }

    #[test]
    fn exclusive_facts_are_proved_exclusive() {
        let mut task = TaskBuilder::default();
        let (a, b) = (task.fact("a"), task.fact("b"));
        task.exclusive(vec![a, b]);
        task.operator("copy", &[a], &[b], &[]);
        let error = task.clone().build(&[a], &[b]).map(|_| ()).unwrap_err();
        assert!(
            matches!(error, TaskError::NotExclusive { ref place, .. } if place == "copy"),
            "{error}"
        );
        let both = TaskBuilder { operators: Vec::new(), ..task };
        let error = both.build(&[a, b], &[b]).map(|_| ()).unwrap_err();
        assert!(error.to_string().contains("the initial state"), "{error}");
    }
}
