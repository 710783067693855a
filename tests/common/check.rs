//! Holds what the crate answers against the tables.

use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::sync::Arc;

use mo_copp::goal_difference::GoalSet;
use mo_copp::plan::Plan;
use mo_copp::problem::{Problem, Role};
use mo_copp::solver::{Horizon, Options, Outcome, Run, Solver, Status};
use mo_copp::trace::trace;

use super::oracle::{Ending, Wish, close, ending, replay};
use super::table::{Goals, Table, members};

/// More than any test problem takes; a search that goes on longer hangs.
const MOST_SLICES: usize = 20_000;

/// Runs a solver to its end, and fails where there is none.
pub fn solve(problem: &Arc<Problem>, options: &Options) -> Outcome {
    let mut run = Run::new(Arc::clone(problem), options.clone()).unwrap();
    for _ in 0..MOST_SLICES {
        if run.advance(512).unwrap() {
            return run.outcome().unwrap();
        }
    }
    panic!("{} does not come to an end", options.solver.name());
}

/// The goals of a set as bits.
pub fn bits(goals: &GoalSet) -> Goals {
    goals.iter().map(|goal| 1 << goal).sum()
}

/// A table with the problem that the crate has made of it.
pub struct Judge {
    pub table: Table,
    pub problem: Arc<Problem>,
    closure: OnceCell<BTreeMap<Ending, usize>>,
}

impl Judge {
    pub fn of(table: Table, problem: Arc<Problem>) -> Self {
        Self { table, problem, closure: OnceCell::new() }
    }

    /// Through an `explicit` document.
    pub fn new(table: Table) -> Self {
        let problem = table.problem();
        Self::of(table, problem)
    }

    /// The same through the Rust API.
    pub fn built(table: Table, padding: usize) -> Self {
        let problem = table.built_problem(padding);
        Self::of(table, problem)
    }

    /// Each ending there is, with the length of a shortest plan for it. Worked out once.
    pub fn endings(&self) -> &BTreeMap<Ending, usize> {
        self.closure.get_or_init(|| close(&self.table))
    }

    /// Options of a solver; all lengths where there is no horizon.
    pub fn options(solver: Solver, horizon: Option<usize>, wish: &Wish) -> Options {
        let mut options = Options::new(solver);
        options.horizon = horizon.map_or(Horizon::Any, Horizon::Steps);
        options.bounds = wish.bounds();
        // The searches find the same whether beliefs are lists or diagrams, so half of them get diagrams.
        let searches = !matches!(solver, Solver::Exact | Solver::Ip);
        if searches && (horizon.unwrap_or(1) + wish.k.unwrap_or(0)) % 2 == 1 {
            options.limits = options.limits.with_listed(2);
        }
        options
    }

    pub fn solve(&self, options: &Options) -> Outcome {
        solve(&self.problem, options)
    }

    /// A plan as positions of actions.
    pub fn positions(&self, plan: &Plan) -> Vec<usize> {
        let names = plan.names(self.problem.task());
        let position = |name| self.table.actions.iter().position(|known| known == name).unwrap();
        names.iter().map(position).collect()
    }

    /// What a plan achieves; fails where it is no solution.
    pub fn ending(&self, plan: &Plan) -> Ending {
        let steps = replay(&self.table, &self.positions(plan)).expect("not applicable");
        let last = steps.last().unwrap();
        assert!(self.table.is_goal(last.state), "the plan misses the true goal");
        ending(&self.table, &last.beliefs)
    }

    /// Checks all that an outcome says against a replay, and the propositions of the paper.
    /// Returns what the plan achieves. The wish is what the solver heeds.
    pub fn check(&self, options: &Options, outcome: &Outcome, wish: &Wish) -> Option<Ending> {
        let found = match options.solver {
            Solver::Exact | Solver::Ip => Status::Optimal,
            _ => Status::Solved,
        };
        let expected = if outcome.plan.is_some() { found } else { Status::Infeasible };
        assert_eq!(outcome.status, expected, "{outcome:?}");
        assert_eq!((outcome.solver, outcome.limit), (options.solver, None));
        self.check_plan(options, outcome, wish)
    }

    /// The same whatever the status.
    pub fn check_plan(&self, options: &Options, outcome: &Outcome, wish: &Wish) -> Option<Ending> {
        let Some(plan) = &outcome.plan else {
            assert_eq!((&outcome.survivors, outcome.goal_difference), (&None, None));
            return None;
        };
        let ending = self.ending(plan);
        let claimed: Ending = outcome.survivors.as_ref().unwrap().iter().map(bits).collect();
        assert_eq!(claimed, ending);
        assert_eq!(outcome.horizon, Some(plan.len()));
        if let Horizon::Steps(steps) = options.horizon
            && options.horizon_step == 0
        {
            assert_eq!(plan.len(), steps);
        }
        let (adversarial, cooperative) = self.table.counts(&ending);
        let most = self.table.goals.len() as f64 - 1.0;
        let difference = (adversarial as f64 - cooperative as f64) / most;
        assert!((outcome.goal_difference.unwrap() - difference).abs() < 1e-12);
        assert!(wish.allows(&self.table, &ending), "{wish:?} {ending:?}");
        self.propositions(&ending, difference, wish);
        self.check_trace(plan);
        Some(ending)
    }

    fn propositions(&self, ending: &Ending, difference: f64, wish: &Wish) {
        let truth = 1 << self.table.true_goal;
        for (watcher, &goals) in self.table.watchers.iter().zip(ending) {
            assert!(goals & truth != 0, "the true goal does not survive");
            assert!(goals.count_ones() > 1 || goals == truth);
            let guess = 1.0 / f64::from(goals.count_ones());
            match (watcher.role, wish.k, wish.j) {
                (Role::Adversarial, Some(k), _) => assert!(guess <= 1.0 / k as f64),
                (Role::Cooperative, _, Some(j)) => assert!(guess >= 1.0 / j as f64),
                _ => {}
            }
        }
        if let (Some(k), Some(j)) = (wish.k, wish.j) {
            let most = self.table.goals.len() as f64 - 1.0;
            assert!(difference >= (k as f64 - j as f64) / most - 1e-12);
        }
    }

    /// The crate's trace of a plan must say what a replay on the tables says, step by step.
    pub fn check_trace(&self, plan: &Plan) {
        let table = &self.table;
        let actions = self.positions(plan);
        let expected = replay(table, &actions).unwrap();
        let trace = trace(&self.problem, plan).unwrap();
        assert_eq!(trace.steps.len(), expected.len());
        let label =
            |state: &mo_copp::task::State| format!("{:#}", self.problem.label(state.words()));
        for (number, (step, expected)) in trace.steps.iter().zip(&expected).enumerate() {
            let action = number.checked_sub(1).map(|index| table.actions[actions[index]].as_str());
            assert_eq!(step.action.map(|a| self.problem.task().action_name(a)), action);
            assert_eq!(label(&step.state), table.states[expected.state]);
            for (index, watcher) in table.watchers.iter().enumerate() {
                let symbol = expected.symbols.get(index).map(|&symbol| &watcher.symbols[symbol]);
                assert_eq!(step.symbols[index].as_ref(), symbol);
                let mut believed: Vec<String> = step.beliefs[index].iter().map(label).collect();
                let mut states: Vec<String> =
                    members(expected.beliefs[index]).map(|s| table.states[s].clone()).collect();
                believed.sort();
                states.sort();
                assert_eq!(believed, states, "step {number}, watcher {index}");
                let survivors = table.survivors(expected.beliefs[index]);
                assert_eq!(bits(&step.survivors[index]), survivors);
            }
        }
        let last = expected.last().unwrap();
        assert_eq!(trace.reaches_goal, table.is_goal(last.state));
        let (adversarial, cooperative) = table.counts(&ending(table, &last.beliefs));
        let most = table.goals.len() as f64 - 1.0;
        let difference = (adversarial as f64 - cooperative as f64) / most;
        assert!((trace.goal_difference(&self.problem) - difference).abs() < 1e-12);
    }
}
