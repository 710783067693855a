//! The questions that a search for remedies asks one after another, and what it takes from their answers.

use std::sync::Arc;

use super::super::next_horizons::NextHorizons;
use super::super::{Change, Reason};
use super::{Question, RemedyRun, Stage};
use crate::plan::Plan;
use crate::solver::optimiser::Optimiser;

impl RemedyRun {
    /// Everything is known.
    pub(super) fn take_all(&mut self) {
        let Stage::Explore(all) = &self.stage else { return };
        let bounds = &self.options.bounds;
        let keeps_k = |adversarial| bounds.at_least.is_none_or(|k| adversarial >= k);
        let keeps_j = |cooperative| bounds.at_most.is_none_or(|j| cooperative <= j);
        let counts = all.counts();
        if counts.iter().any(|it| keeps_k(it.adversarial) && keeps_j(it.cooperative)) {
            self.reason = None;
            self.finish(true);
            return;
        }
        self.reason = self.reason.or(Some(Reason::Bounds));
        let fewer = counts.iter().filter(|it| keeps_j(it.cooperative)).map(|it| it.adversarial);
        let k = bounds.at_least.and_then(|_| fewer.max());
        let more = counts.iter().filter(|it| keeps_k(it.adversarial)).map(|it| it.cooperative);
        let j = bounds.at_most.and_then(|_| more.min());
        let mut found = Vec::new();
        if let Some(k) = k {
            let plan = all.plan(|it| it.adversarial >= k && keeps_j(it.cooperative));
            found.extend(plan.map(|plan| (Change::AtLeast, k, plan)));
        }
        if let Some(j) = j {
            let plan = all.plan(|it| keeps_k(it.adversarial) && it.cooperative <= j);
            found.extend(plan.map(|plan| (Change::AtMost, j, plan)));
        }
        self.found.append(&mut found);
        self.take_horizons();
        self.finish(true);
    }

    /// Adds the nearest horizons of an exploration that is done, where they are not known.
    pub(super) fn take_horizons(&mut self) {
        let (Stage::Explore(all) | Stage::ExploreOn(all)) = &self.stage else { return };
        let Some(asked) = self.asked else { return };
        for plan in all.nearest().into_iter().flatten() {
            let longer = plan.len() > asked;
            let same = |found: &&(Change, usize, Plan)| {
                found.0 == Change::Horizon && (found.1 > asked) == longer
            };
            if !self.found.iter().any(|found| same(&found)) {
                self.found.push((Change::Horizon, plan.len(), plan));
            }
        }
    }

    /// The space is too large to be explored first.
    pub(super) fn ask_one_by_one(&mut self) {
        if let Stage::Explore(exploration) = std::mem::replace(&mut self.stage, Stage::Done) {
            self.parked = Some(exploration);
        }
        match self.reason {
            Some(Reason::Length) => {
                let next = self.next_horizons();
                self.go_on(next);
            }
            Some(_) => self.answer(None, None),
            None => self.stage = self.ask(None),
        }
    }

    /// The horizons that come after the bounds; the end where none was asked for or none helps.
    fn next_horizons(&self) -> Stage {
        match (self.asked, self.shortest) {
            (Some(asked), Some(shortest)) if !self.contradicts(&self.options.bounds) => {
                let problem = Arc::clone(&self.problem);
                let horizons = NextHorizons::new(problem, self.rest(), asked, shortest);
                Stage::NextHorizons(Box::new(horizons))
            }
            _ => Stage::Done,
        }
    }

    /// Keeps what the next horizons have, and explores the others where a side has no plan yet.
    pub(super) fn leave_next_horizons(&mut self) {
        let asked = self.asked.unwrap_or_default();
        let sides = [self.shortest.is_some_and(|shortest| shortest < asked), true];
        let Stage::NextHorizons(horizons) = &self.stage else { return };
        let open = horizons.found.iter().zip(sides).any(|(plan, open)| open && plan.is_none());
        self.collect_next_horizons();
        match self.parked.take() {
            Some(exploration) if open => self.stage = Stage::ExploreOn(exploration),
            _ => self.finish(true),
        }
    }

    pub(super) fn collect_next_horizons(&mut self) {
        if let Stage::NextHorizons(horizons) = std::mem::replace(&mut self.stage, Stage::Done) {
            self.expansions += horizons.expansions();
            let plans = horizons.found.into_iter().flatten();
            self.found.extend(plans.map(|plan| (Change::Horizon, plan.len(), plan)));
        }
    }

    fn ask(&self, question: Question) -> Stage {
        let mut options = self.rest();
        match question {
            Some((Change::AtLeast, value)) => options.bounds.at_least = Some(value),
            Some((Change::AtMost, value)) => options.bounds.at_most = Some(value),
            _ => {}
        }
        let engine = Optimiser::new(Arc::clone(&self.problem), &options, self.asked);
        Stage::Question(question, Box::new(engine))
    }

    /// Goes on after the answer to a question: with a smaller k until there is a plan, then with a
    /// greater j until there is one, then with other horizons.
    pub(super) fn answer(&mut self, question: Question, plan: Option<Plan>) {
        let found = plan.is_some();
        match (question, plan) {
            (None, Some(_)) => {
                self.finish(true);
                return;
            }
            (None, None) => self.reason = Some(Reason::Bounds),
            (Some((change, value)), Some(plan)) => self.found.push((change, value, plan)),
            (Some(_), None) => {}
        }
        let bounds = &self.options.bounds;
        let at_least = match question {
            None => bounds.at_least,
            Some((Change::AtLeast, value)) if !found => Some(value),
            Some(_) => None,
        };
        let at_most = match question {
            Some((Change::AtMost, _)) if found => None,
            Some((Change::AtMost, value)) => Some(value),
            _ => bounds.at_most,
        };
        let most = self.problem.goals().len();
        let next = if let Some(k) = at_least.filter(|k| *k > 1) {
            self.ask(Some((Change::AtLeast, k - 1)))
        } else if let Some(j) = at_most.filter(|j| *j < most) {
            self.ask(Some((Change::AtMost, j + 1)))
        } else {
            self.next_horizons()
        };
        self.go_on(next);
    }

    fn go_on(&mut self, next: Stage) {
        if matches!(next, Stage::Done) {
            self.finish(true);
        } else {
            self.stage = next;
        }
    }
}
