//! Search by what can still become of each believed state, one hope after the other.
//!
//! The beliefs of an observer can differ in millions of ways that make no difference any more. So
//! say beforehand which goals should survive for the enemy and which should die for the friend (a
//! `hope`), keep of each belief only what matters to that (`tables`), and of two nodes only the
//! better one where one is at least as good in everything (`pass`). In the paper's box pushing
//! hundreds of nodes are left of many millions.
//!
//! Before both observers are looked at together, each is looked at alone: mostly it is the friend of
//! whom nothing can be hoped.
//!
//! For one enemy and one friend, few goals, and state spaces that are small enough for tables over
//! pairs of states. Others are left to the other engines.

mod hope;
mod pass;
mod tables;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::limits::LimitReached;
use crate::plan::Plan;
use crate::problem::{JointSpace, Problem, Role};
use crate::solver::live::Live;
use crate::solver::outcome::Stats;
use crate::solver::{Bounds, Options};
use crate::task::StateId;
use hope::Hope;
use pass::{Pass, Went};
use tables::Tables;

/// State spaces with more states have too many pairs.
const MOST_STATES: usize = 2_900;
/// The most pairs of transitions gone through for a table.
const MOST_PAIRS_OF_TRANSITIONS: u64 = 150_000_000;
/// With more goals there are too many hopes.
const MOST_GOALS: usize = 4;
/// Where so many believed states had to be compared for one hope, the order between nodes does not
/// help, and going through all of them is the better way.
const MOST_COMPARED: u64 = 400_000_000;
/// How many nodes are expanded between two looks at the memory.
const EXPANSIONS_BETWEEN_CHECKS: u64 = 64;

/// Where the work stands.
#[derive(Debug)]
pub(in crate::solver) enum Verdict {
    Working,
    /// A plan; a best one and a shortest of these, where the best was asked for.
    Plan(Plan),
    /// There is none that keeps the bounds.
    Infeasible,
    /// Nothing can be said in reasonable time.
    Unknown,
}

/// The hopes at work.
#[derive(Debug)]
pub(in crate::solver) struct Prospects {
    joint: JointSpace,
    live: Live,
    tables: Tables,
    /// Whether the best plan is asked for, or any that keeps the bounds.
    best: bool,
    /// What is left to look at, the best last.
    groups: Vec<Vec<Hope>>,
    /// Hopes for one observer alone, and whether they can be fulfilled.
    alone: BTreeMap<Hope, bool>,
    pass: Option<Pass>,
    /// The shortest plan of the group at work.
    shortest: Option<Plan>,
    expansions: u64,
    generated: u64,
}

/// The enemy and the friend, where there is one of each and only what can be hoped for is named.
fn pair(problem: &Problem, bounds: &Bounds) -> Option<(usize, usize)> {
    let of = |role| problem.observers().iter().position(|observer| observer.role == role);
    let (enemy, friend) = (of(Role::Adversarial)?, of(Role::Cooperative)?);
    let true_goal = problem.true_goal();
    let required = bounds.required.iter().all(|w| w.observer == enemy || w.goal == true_goal);
    let forbidden = bounds.forbidden.iter().all(|w| w.observer == friend && w.goal != true_goal);
    (problem.observers().len() == 2 && required && forbidden).then_some((enemy, friend))
}

impl Prospects {
    /// Goes through the state space; none where this is not for them.
    ///
    /// # Errors
    ///
    /// The memory limit.
    pub(in crate::solver) fn new(
        problem: &Arc<Problem>,
        options: &Options,
        best: bool,
    ) -> Result<Option<Self>, LimitReached> {
        let bounds = options.heeded_bounds();
        let Some((enemy, friend)) = pair(problem, &bounds) else { return Ok(None) };
        if problem.goals().len() > MOST_GOALS {
            return Ok(None);
        }
        let mut joint = JointSpace::new(Arc::clone(problem), options.limits);
        joint.initial();
        let mut expanded = 0;
        while expanded < joint.states().len() {
            if joint.states().len() > MOST_STATES {
                return Ok(None);
            }
            joint.states_mut().expand(StateId(expanded as u32));
            expanded += 1;
        }
        let tables = Tables::new(&mut joint, enemy, friend);
        if tables.work() > MOST_PAIRS_OF_TRANSITIONS {
            return Ok(None);
        }
        let live = Live::new(&mut joint)?;
        let goals = 0..problem.goals().len();
        let others: Vec<usize> = goals.filter(|&goal| goal != problem.true_goal()).collect();
        let mut groups = hope::hopes(&others, &bounds, best);
        for group in &mut groups {
            group.reverse();
        }
        groups.reverse();
        Ok(Some(Self {
            joint,
            live,
            tables,
            best,
            groups,
            alone: BTreeMap::new(),
            pass: None,
            shortest: None,
            expansions: 0,
            generated: 0,
        }))
    }

    /// Whether a hope for one observer alone, or for none, is known to be vain; none where a pass
    /// has to tell.
    fn vain_alone(&self, hope: &Hope) -> Result<bool, Hope> {
        if hope.alive.is_empty() || hope.dead.is_empty() {
            return Ok(false);
        }
        let parts = [
            Hope { alive: Vec::new(), dead: hope.dead.clone() },
            Hope { alive: hope.alive.clone(), dead: Vec::new() },
        ];
        for part in parts {
            match self.alone.get(&part) {
                Some(false) => return Ok(true),
                Some(true) => {}
                None => return Err(part),
            }
        }
        Ok(false)
    }

    /// The next pass; the verdict where there is none.
    fn next_pass(&mut self) -> Result<Result<Pass, Verdict>, LimitReached> {
        loop {
            let Some(group) = self.groups.last_mut() else { return Ok(Err(Verdict::Infeasible)) };
            let Some(hope) = group.last().cloned() else {
                self.groups.pop();
                if let Some(plan) = self.shortest.take() {
                    return Ok(Err(Verdict::Plan(plan)));
                }
                continue;
            };
            let next = match self.vain_alone(&hope) {
                Ok(true) => {
                    if let Some(group) = self.groups.last_mut() {
                        group.pop();
                    }
                    continue;
                }
                Ok(false) => hope,
                Err(part) => part,
            };
            self.tables.prepare(&self.joint, &self.live, &next)?;
            return Ok(Ok(Pass::new(next)));
        }
    }

    fn check_limits(&self, pass: &Pass) -> Result<(), LimitReached> {
        let limits = self.joint.limits();
        if self.expansions >= limits.expansions {
            return Err(LimitReached::Expansions { limit: limits.expansions });
        }
        if self.expansions.is_multiple_of(EXPANSIONS_BETWEEN_CHECKS) {
            limits.check_bytes(self.bytes() + pass.bytes())?;
        }
        Ok(())
    }

    fn bytes(&self) -> u64 {
        self.joint.bytes() + self.tables.bytes()
    }

    /// Whether the pass at work is about the whole of the hope at the head.
    fn is_whole(&self, pass: &Pass) -> bool {
        self.groups.last().and_then(|group| group.last()) == Some(&pass.hope)
    }

    /// Takes note of how a pass ended.
    fn end(&mut self, pass: &Pass, plan: Option<Plan>) -> Option<Verdict> {
        self.generated += pass.generated() as u64;
        if !self.is_whole(pass) {
            self.alone.insert(pass.hope.clone(), plan.is_some());
            return None;
        }
        if let Some(group) = self.groups.last_mut() {
            group.pop();
        }
        match plan {
            Some(plan) if !self.best => Some(Verdict::Plan(plan)),
            Some(plan) => {
                self.shortest = Some(plan);
                None
            }
            None => None,
        }
    }

    /// Works for about `budget` expansions.
    ///
    /// # Errors
    ///
    /// A limit.
    pub(in crate::solver) fn advance(&mut self, budget: u64) -> Result<Verdict, LimitReached> {
        for _ in 0..budget {
            let mut pass = match self.pass.take() {
                Some(pass) => pass,
                None => match self.next_pass()? {
                    Ok(pass) => pass,
                    Err(verdict) => return Ok(verdict),
                },
            };
            self.check_limits(&pass)?;
            self.expansions += 1;
            let known = self.shortest.as_ref().map(|plan| plan.actions.len() as u32);
            let shorter_than = known.filter(|_| self.is_whole(&pass)).unwrap_or(u32::MAX);
            match pass.step(&mut self.joint, &mut self.tables, &self.live, shorter_than)? {
                Went::On if pass.compared > MOST_COMPARED => return Ok(Verdict::Unknown),
                Went::On => self.pass = Some(pass),
                Went::Found(plan) => {
                    if let Some(verdict) = self.end(&pass, Some(plan)) {
                        return Ok(verdict);
                    }
                }
                Went::Nowhere => {
                    self.end(&pass, None);
                }
            }
        }
        Ok(Verdict::Working)
    }

    /// What the work took so far.
    pub(in crate::solver) fn stats(&self) -> Stats {
        let at_work = self.pass.as_ref().map_or(0, Pass::generated) as u64;
        let mut stats = Stats {
            expansions: self.expansions,
            generated: self.generated + at_work,
            ..Stats::default()
        };
        stats.count_spaces(&self.joint);
        stats
    }
}
