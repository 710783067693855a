//! Grounding: from a domain and a task to facts and operators.
//!
//! What is kept is what can be reached when deletes are ignored. Atoms that hold in every reachable
//! state are no facts of the ground task, nor are those that never hold. A negative precondition on
//! an atom that may hold is compiled away by a fact for its negation, disjunctions and conditional effects by
//! several operators of one action (`draft`, `split`), disjunctions in goals by facts of their own (`derived`).

use fixedbitset::FixedBitSet;
use rustc_hash::FxHashMap;
use thiserror::Error;

use super::atom::Atom;
use super::atom_table::AtomTable;
use super::condition::Condition;
use super::definition::TaskDefinition;
use super::derived::{Derived, derive, regress};
use super::domain::Domain;
use super::draft::{Draft, remove_relaxed};
use super::exclusive::Exclusive;
use super::invariant::candidates;
use super::object::ObjectId;
use super::operators::{Candidates, GroundOperator, Possible, cost_of, keep_possible, operators};
use super::reach::{object, reach};
use super::rule::Rule;
use super::split::split;
use crate::task::{Action, Fact, State, Task, TaskBuilder, TaskError};

/// The most ground operators.
pub const MAX_OPERATORS: usize = if cfg!(target_arch = "wasm32") { 100_000 } else { 1_000_000 };

/// The most ground atoms.
pub const MAX_ATOMS: usize = if cfg!(target_arch = "wasm32") { 200_000 } else { 2_000_000 };

/// The most literals in all ground operators together.
pub const MAX_LITERALS_IN_ALL: usize =
    if cfg!(target_arch = "wasm32") { 2_000_000 } else { 20_000_000 };

/// The most bytes of further states, one bit for each atom of each.
pub const MAX_STATE_BYTES: usize = if cfg!(target_arch = "wasm32") { 32 << 20 } else { 256 << 20 };

/// Why a task was not grounded.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum GroundError {
    /// More operators than allowed.
    #[error("grounding limit reached: {limit} operators")]
    Operators {
        /// The limit.
        limit: usize,
    },
    /// More atoms than allowed.
    #[error("grounding limit reached: {limit} ground atoms")]
    Atoms {
        /// The limit.
        limit: usize,
    },
    /// More literals in preconditions and effects than allowed.
    #[error("grounding limit reached: {limit} literals in ground operators")]
    Literals {
        /// The limit.
        limit: usize,
    },
    /// More states to begin in than allowed.
    #[error("grounding limit reached: {limit} bytes of initial states")]
    States {
        /// The limit.
        limit: usize,
    },
    /// More work than allowed.
    #[error("grounding limit reached: {limit} atoms and inequalities tried against preconditions")]
    Steps {
        /// The limit.
        limit: u64,
    },
    /// Actions of one name of which two may apply in one state.
    #[error(
        "action {action}: it is declared several times, and more than one may apply in a state"
    )]
    Ambiguous {
        /// The action.
        action: String,
    },
    /// The ground task contradicts itself. A defect of this program: please report it.
    #[error("internal error: {0}")]
    Internal(String),
}

/// What is asked of the grounding beside the task itself.
#[derive(Debug, Clone, Default)]
pub struct ExtraInputs {
    /// Further states that something may begin in, each complete like an `:init`. The operators
    /// are those that can apply after any of them.
    pub states: Vec<Vec<Atom>>,
    /// Further conditions: candidate goals, what a sensor looks at.
    pub conditions: Vec<Condition>,
}

/// A ground task and what its numbers mean.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Grounded {
    /// The task. Its goal is that of the definition; where that can never hold, a fact that never
    /// does. An action has several operators where its effects have conditions or its precondition
    /// is no conjunction: one for each case, of which one applies in a state at most.
    pub task: Task,
    /// The facts of the goal; none where the goal can never hold.
    pub goal: Option<Vec<Fact>>,
    /// The same for each of the further conditions, in their order.
    pub conditions: Vec<Option<Vec<Fact>>>,
    /// A fact that never holds; there where a condition or the goal can never hold.
    pub never: Option<Fact>,
    /// The further states, in their order.
    pub states: Vec<State>,
    instances: Vec<(u32, Box<[ObjectId]>)>,
    atoms: Vec<(Atom, bool)>,
    /// How many predicates the domain has; what stands for a disjunction has a larger number.
    predicates: usize,
}

impl Grounded {
    /// The position of an action's schema in the domain.
    pub fn schema(&self, action: Action) -> usize {
        self.instances[action.index()].0 as usize
    }

    /// The objects in the places of the schema's parameters.
    pub fn arguments(&self, action: Action) -> &[ObjectId] {
        &self.instances[action.index()].1
    }

    /// Whether an atom holds in every reachable state (true) or in none (false); none where that
    /// changes. `task` is what was grounded.
    pub fn constant(&self, task: &TaskDefinition, atom: &Atom) -> Option<bool> {
        let positive = self.atoms.partition_point(|(_, negated)| !negated);
        let known = self.atoms[..positive].binary_search_by(|(fact, _)| fact.cmp(atom));
        // What never changes is as it is at first, whichever of the initial states that is.
        known.is_err().then(|| task.initial.binary_search(atom).is_ok())
    }

    /// The atom of a fact, and whether the fact is that it does not hold. None for the fact that
    /// never holds and for those that stand for a disjunction.
    pub fn atom(&self, fact: Fact) -> Option<(&Atom, bool)> {
        let (atom, negated) = self.atoms.get(fact.index())?;
        (atom.predicate.index() < self.predicates).then_some((atom, *negated))
    }
}

/// Grounds a task.
///
/// # Errors
///
/// [`GroundError`] where a limit is met.
///
/// ```
/// use mo_copp::pddl::{ExtraInputs, ground, read_domain, read_task};
/// let domain = read_domain(
///     "(define (domain lamps) (:predicates (lit ?x) (near ?x))
///        (:action switch :parameters (?x) :precondition (near ?x) :effect (lit ?x)))",
/// )?;
/// let task = read_task(
///     &domain,
///     "(define (problem two) (:domain lamps) (:objects a b) (:init (near a)) (:goal (lit a)))",
/// )?;
/// let grounded = ground(&domain, &task, &ExtraInputs::default())?;
/// let facts: Vec<_> = grounded.task.facts().map(|f| grounded.task.fact_name(f)).collect();
/// assert_eq!(facts, ["(lit a)"]);
/// assert_eq!(grounded.task.action_count(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn ground(
    domain: &Domain,
    task: &TaskDefinition,
    extra: &ExtraInputs,
) -> Result<Grounded, GroundError> {
    let rules: Vec<Rule<'_>> = (0..domain.schemas.len())
        .filter_map(|number| Rule::new(domain, number, &task.objects))
        .collect();
    let states: Vec<&[Atom]> =
        std::iter::once(&task.initial).chain(&extra.states).map(Vec::as_slice).collect();
    let initial: Vec<&Atom> = states.iter().copied().flatten().collect();
    let reached = reach(domain, &rules, &task.objects, &initial)?;
    let Candidates { mut atoms, plain: mut operators, mut drafts } =
        operators(domain, task, &rules, reached)?;
    let conditions: Vec<&Condition> =
        std::iter::once(&task.goal).chain(&extra.conditions).collect();
    let (derived, conditions) = derive(&conditions, domain.predicates.len(), &mut atoms);
    if atoms.len() > MAX_ATOMS {
        return Err(GroundError::Atoms { limit: MAX_ATOMS });
    }
    regress(&derived, &mut operators, &mut drafts);
    if states.len().saturating_mul(atoms.len().div_ceil(8)) > MAX_STATE_BYTES {
        return Err(GroundError::States { limit: MAX_STATE_BYTES });
    }
    let initial: Vec<FixedBitSet> = states
        .iter()
        .map(|state| {
            let mut set = FixedBitSet::with_capacity(atoms.len());
            set.extend(state.iter().filter_map(|atom| atoms.find_atom(atom)).map(|n| n as usize));
            for Derived { atom, formula } in &derived {
                let holds = formula.holds(&|atom| set.contains(*atom as usize));
                set.set(*atom as usize, holds);
            }
            set
        })
        .collect();
    for draft in &drafts {
        draft.relaxed(&mut operators);
    }
    let mut possible = keep_possible(&mut operators, atoms.len(), &initial);
    remove_relaxed(&mut operators);
    let drafts: Vec<Draft> =
        drafts.into_iter().filter_map(|draft| draft.possible(&possible)).collect();
    let candidates = candidates(domain, &rules);
    let exclusive = Exclusive::new(&candidates, &atoms, &operators, &drafts, &initial);
    let known = operators.len();
    split(&drafts, &exclusive, &mut operators)?;
    operators.retain(|operator| !exclusive.contradict(&operator.positive));
    if operators.len() != known || !drafts.is_empty() {
        possible = keep_possible(&mut operators, atoms.len(), &initial);
    }
    let key =
        |operator: &GroundOperator| (operator.instance.rule, operator.instance.values.clone());
    operators.sort_by_cached_key(key);
    let conditions: Vec<&Condition> = conditions.iter().collect();
    let facts = Facts::new(&atoms, &possible, &exclusive, &operators, &conditions);
    facts.task(domain, task, &rules, &operators, &initial, &conditions)
}

/// Which atoms are facts, and which have a fact for their negation.
struct Facts<'a> {
    atoms: &'a AtomTable,
    possible: &'a Possible,
    exclusive: &'a Exclusive,
    /// Atom and whether it is negated, in the order of the facts.
    literals: Vec<(u32, bool)>,
    numbers: FxHashMap<(u32, bool), usize>,
}

impl<'a> Facts<'a> {
    fn new(
        atoms: &'a AtomTable,
        possible: &'a Possible,
        exclusive: &'a Exclusive,
        operators: &[GroundOperator],
        conditions: &[&Condition],
    ) -> Self {
        let changes = |atom: &u32| {
            possible.hold.contains(*atom as usize) && possible.fail.contains(*atom as usize)
        };
        let mut facts: Vec<(u32, bool)> =
            (0..atoms.len() as u32).filter(changes).map(|atom| (atom, false)).collect();
        let wanted = operators.iter().flat_map(|operator| operator.negative.iter().copied());
        let in_conditions = conditions.iter().flat_map(|condition| &condition.negative);
        let in_conditions = in_conditions.filter_map(|atom| atoms.find_atom(atom));
        let mut negated: Vec<u32> = wanted.chain(in_conditions).filter(changes).collect();
        let order = |atom: &u32| {
            let (predicate, objects) = atoms.get(*atom);
            (predicate, objects.to_vec())
        };
        facts.sort_by_cached_key(|(atom, _)| order(atom));
        negated.sort_unstable();
        negated.dedup();
        negated.sort_by_cached_key(order);
        facts.extend(negated.into_iter().map(|atom| (atom, true)));
        let numbers = (0..).zip(&facts).map(|(number, &fact)| (fact, number)).collect();
        Self { atoms, possible, exclusive, literals: facts, numbers }
    }

    /// The facts of literals, those left out that always hold; none where one never does.
    fn meaning(
        &self,
        facts: &[Fact],
        literals: impl Iterator<Item = (Option<u32>, bool)>,
    ) -> Option<Vec<Fact>> {
        let mut found = Vec::new();
        for (atom, negated) in literals {
            // An atom that is not there never holds.
            let Some(atom) = atom else {
                if negated {
                    continue;
                }
                return None;
            };
            let holds = self.possible.hold.contains(atom as usize);
            let fails = self.possible.fail.contains(atom as usize);
            match (holds, fails) {
                (true, true) => found.push(facts[*self.numbers.get(&(atom, negated))?]),
                (true, false) if negated => return None,
                (false, _) if !negated => return None,
                _ => {}
            }
        }
        Some(found)
    }

    fn meaning_of(&self, facts: &[Fact], condition: &Condition) -> Option<Vec<Fact>> {
        if condition.is_false
            || condition.positive.iter().any(|atom| condition.negative.binary_search(atom).is_ok())
        {
            return None;
        }
        let held: Vec<u32> =
            condition.positive.iter().filter_map(|atom| self.atoms.find_atom(atom)).collect();
        if self.exclusive.contradict(&held) {
            return None;
        }
        let positive = condition.positive.iter().map(|atom| (self.atoms.find_atom(atom), false));
        let negative = condition.negative.iter().map(|atom| (self.atoms.find_atom(atom), true));
        self.meaning(facts, positive.chain(negative))
    }

    /// The cases of an action exclude each other by what must hold in one and fail in another.
    fn exclude_negations(&self, facts: &[Fact], builder: &mut TaskBuilder) {
        for (&(atom, negated), &fact) in self.literals.iter().zip(facts) {
            if let (true, Some(&number)) = (negated, self.numbers.get(&(atom, false))) {
                builder.exclusive(vec![facts[number], fact]);
            }
        }
    }

    fn task(
        &self,
        domain: &Domain,
        definition: &TaskDefinition,
        rules: &[Rule<'_>],
        operators: &[GroundOperator],
        initial: &[FixedBitSet],
        conditions: &[&Condition],
    ) -> Result<Grounded, GroundError> {
        let mut builder = TaskBuilder::default();
        let mut atoms = Vec::with_capacity(self.literals.len());
        let mut facts = Vec::with_capacity(self.literals.len());
        for &(atom, negated) in &self.literals {
            let (predicate, objects) = self.atoms.get(atom);
            let mut name = match predicate.index().checked_sub(domain.predicates.len()) {
                None => written(domain.predicates.name(predicate), objects, definition),
                Some(number) => format!("(disjunction {})", number + 1),
            };
            if negated {
                name = format!("(not {name})");
            }
            facts.push(builder.fact(name));
            atoms.push((Atom { predicate, objects: objects.into() }, negated));
        }
        let numbers = |atoms: &[u32], negated: bool, into: &mut Vec<Fact>| {
            let known = atoms.iter().filter_map(|&atom| self.numbers.get(&(atom, negated)));
            into.extend(known.map(|&number| facts[number]));
        };
        let mut instances = Vec::with_capacity(operators.len());
        let [mut pre, mut add, mut delete] = [const { Vec::new() }; 3];
        let mut several = false;
        for operator in operators {
            pre.clear();
            add.clear();
            delete.clear();
            numbers(&operator.positive, false, &mut pre);
            numbers(&operator.negative, true, &mut pre);
            numbers(&operator.add, false, &mut add);
            numbers(&operator.delete, true, &mut add);
            numbers(&operator.delete, false, &mut delete);
            numbers(&operator.add, true, &mut delete);
            let rule = &rules[operator.instance.rule as usize];
            let arguments: Box<[ObjectId]> = rule
                .arguments
                .iter()
                .map(|&term| object(term, &operator.instance.values))
                .collect();
            let name = written(&domain.schemas[rule.schema].name, &arguments, definition);
            let action = builder.action(&name);
            builder.operator(&name, &pre, &add, &delete);
            if action.index() < instances.len() {
                several = true;
                continue;
            }
            if definition.has_costs {
                let cost = cost_of(domain, definition, rule, &operator.instance);
                builder.cost(action, cost.unwrap_or(0));
            }
            instances.push((domain.first_case(rule.schema) as u32, arguments));
        }
        for set in self.exclusive.chosen(|atom| self.numbers.contains_key(&(atom, false))) {
            let mut group = Vec::with_capacity(set.len());
            numbers(&set, false, &mut group);
            builder.exclusive(group);
        }
        if several {
            self.exclude_negations(&facts, &mut builder);
        }
        let mut meanings = conditions
            .iter()
            .map(|condition| self.meaning_of(&facts, condition))
            .collect::<Vec<_>>();
        let meanings_left = meanings.split_off(1);
        let goal = meanings.pop().flatten();
        let can_fail = goal.is_none() || meanings_left.iter().any(Option::is_none);
        let never = can_fail.then(|| builder.fact("a condition that can never hold"));
        let goal_facts = goal.clone().unwrap_or_else(|| never.into_iter().collect());
        let mut states = Vec::with_capacity(initial.len());
        for state in initial {
            let mut holding = Vec::new();
            for (&(atom, negated), &fact) in self.literals.iter().zip(&facts) {
                if state.contains(atom as usize) != negated {
                    holding.push(fact);
                }
            }
            states.push(holding);
        }
        let task = builder.build(&states[0], &goal_facts).map_err(|error| match error {
            TaskError::AmbiguousAction { action } => GroundError::Ambiguous { action },
            error @ TaskError::NotExclusive { .. } => GroundError::Internal(error.to_string()),
        })?;
        let pack = |state: &Vec<Fact>| {
            task.state(state).map_err(|_| {
                GroundError::Internal("a state holds facts that exclude each other".to_owned())
            })
        };
        let states = states[1..].iter().map(pack).collect::<Result<_, _>>()?;
        let predicates = domain.predicates.len();
        Ok(Grounded {
            goal,
            conditions: meanings_left,
            never,
            states,
            instances,
            atoms,
            predicates,
            task,
        })
    }
}

/// A name with objects behind it, as PDDL writes atoms and operators.
fn written(name: &str, objects: &[ObjectId], definition: &TaskDefinition) -> String {
    let mut text = "(".to_owned() + name;
    for &object in objects {
        text.push(' ');
        text.push_str(definition.objects.name(object));
    }
    text.push(')');
    text
}
