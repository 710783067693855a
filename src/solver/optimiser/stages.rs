//! What the optimiser does at each stage: it asks for bounds, finds plans, follows samples, proves, and shortens.

use super::bounds::pairs::Pairs;
use super::schedule::{Question, Stage};
use super::search::{Order, Search, Step, Way};
use super::space::Actor;
use super::{Optimiser, Work, sampling};
use crate::limits::LimitReached;
use crate::solver::ground::thresholds::{
    EXPANSIONS_TO_SHORTEN, EXPANSIONS_WITH_SAMPLES, WORK_TO_SHORTEN,
};

impl Optimiser {
    /// Asks the next question where it is due; true when one was asked.
    fn ask(&mut self, work: &mut Work) -> Result<bool, LimitReached> {
        let Some(&(after, question)) = self.schedule.questions.get(self.asked) else {
            return Ok(false);
        };
        if !matches!(work.stage, Stage::Find(_) | Stage::Sample(_)) || self.expansions < after {
            return Ok(false);
        }
        self.asked += 1;
        match question {
            Question::Bound(bound) => {
                let most = bound().most(&mut work.space)?;
                self.heed(work, most);
            }
            Question::Pairs => {
                if self.make_pairs(work)? && !self.is_proved() {
                    self.prove(work, self.problem.observers().len().checked_sub(1));
                }
            }
        }
        Ok(true)
    }

    /// Makes tables over pairs of states, once; true where there are some.
    fn make_pairs(&mut self, work: &mut Work) -> Result<bool, LimitReached> {
        if !work.tried_pairs {
            work.tried_pairs = true;
            if let Some(mut pairs) = Pairs::new(&mut work.space)? {
                let most = pairs.most(&mut work.space);
                work.estimates.pairs = Some(Box::new(pairs));
                self.heed(work, most);
            }
        }
        Ok(work.estimates.pairs.is_some())
    }

    fn begin_stage(&mut self, work: &mut Work, stage: Stage) {
        self.generated += work.stage.search().len() as u64;
        work.stage = stage;
        work.begun = (self.expansions, work.space.touched);
    }

    /// Looks for a plan that is worth more than the best one, with one observer alone or with all.
    fn prove(&mut self, work: &mut Work, alone: Option<usize>) {
        let order = if self.horizon.is_some() { Order::Depth } else { Order::Length };
        let way = Way {
            actor: Actor::State,
            order,
            horizon: self.horizon.map(|horizon| horizon as u32),
            dominance: self.schedule.dominance,
            shorter_than: u32::MAX,
            alone,
        };
        let least = 1 - self.problem.goals().len() as i64;
        let aim = self.best.as_ref().map_or(least, |(counts, _)| counts.difference() + 1);
        let search = Search::new(&work.space, way, aim);
        self.begin_stage(work, Stage::Prove(search, alone));
    }

    /// One step of the search at work; true when the answer is there.
    pub(super) fn step(&mut self, work: &mut Work) -> Result<bool, LimitReached> {
        if std::mem::take(&mut self.learned) && self.is_proved() {
            return Ok(self.shorten(work));
        }
        if self.ask(work)? {
            return Ok(self.is_proved()
                && matches!(work.stage, Stage::Find(_) | Stage::Sample(_))
                && self.shorten(work));
        }
        self.check_limits(work)?;
        if matches!(work.stage, Stage::Sample(_)) || self.sample(work)? {
            return self.step_with_samples(work);
        }
        let Work { space, estimates, stage, .. } = work;
        let (Stage::Find(search)
        | Stage::Sample(search)
        | Stage::Prove(search, _)
        | Stage::Shorten(search)) = stage;
        let step = search.step(space, estimates)?;
        self.expansions += 1;
        match (step, &*stage) {
            (Step::On, Stage::Shorten(_)) => return self.go_on_shortening(work),
            (Step::On, _) => {}
            // Not ruled out: the next observer, in the end all.
            (Step::Found(..), Stage::Prove(_, Some(observer))) => {
                let next = observer.checked_sub(1);
                self.prove(work, next);
            }
            (Step::Found(counts, plan), stage) => {
                self.length_proved = !matches!(stage, Stage::Find(_));
                self.best = Some((counts, plan));
                self.witnesses.clear();
                match stage {
                    Stage::Find(_) if self.is_proved() => return Ok(self.shorten(work)),
                    Stage::Find(_) | Stage::Sample(_) => {}
                    Stage::Prove(..) if self.is_proved() => return Ok(true),
                    Stage::Prove(..) => {
                        self.prove(work, self.problem.observers().len().checked_sub(1));
                    }
                    Stage::Shorten(_) => return Ok(true),
                }
            }
            (Step::Exhausted, Stage::Shorten(_)) => {
                self.length_proved = true;
                return Ok(true);
            }
            (Step::Exhausted, _) => {
                self.bound = self.best.as_ref().map(|(counts, _)| counts.difference());
                return Ok(self.length_proved || self.shorten(work));
            }
        }
        Ok(false)
    }

    /// Begins to search with samples where beliefs have outgrown their lists, once; true when it does.
    fn sample(&mut self, work: &mut Work) -> Result<bool, LimitReached> {
        let due = !work.tried_samples && self.horizon.is_none() && work.space.joint.has_unlisted();
        if !due || !matches!(work.stage, Stage::Find(_)) {
            return Ok(false);
        }
        work.tried_samples = true;
        let bounds = work.space.bounds.clone();
        let limits = self.options.limits;
        let (most, size) = (work.estimates.most, self.schedule.sample);
        let made = sampling::sampled(&self.problem, &bounds, limits, most, size)?;
        let Some((space, estimates)) = made else { return Ok(false) };
        let least = 1 - self.problem.goals().len() as i64;
        let aim = self.best.as_ref().map_or(least, |(counts, _)| counts.difference() + 1);
        let search = Search::new(&space, self.finding_way(Actor::Word), aim);
        let before = std::mem::replace(&mut work.stage, Stage::Sample(search));
        work.begun = (self.expansions, work.space.touched);
        if let Stage::Find(waiting) = before {
            work.sampled = Some(Box::new((space, estimates, waiting)));
        }
        Ok(true)
    }

    /// One step of the search with samples; true when the answer is there.
    fn step_with_samples(&mut self, work: &mut Work) -> Result<bool, LimitReached> {
        let Work { stage: Stage::Sample(search), sampled: Some(sampled), .. } = work else {
            return Ok(false);
        };
        let (space, estimates, _) = &mut **sampled;
        estimates.most = work.estimates.most;
        let step = search.step(space, estimates)?;
        self.expansions += 1;
        let over = match step {
            Step::Found(counts, plan) => {
                self.witnesses = sampling::witnesses(space, &plan);
                self.best = Some((counts, plan));
                if self.is_proved() {
                    return Ok(self.shorten(work));
                }
                false
            }
            Step::On => self.expansions - work.begun.0 >= EXPANSIONS_WITH_SAMPLES,
            Step::Exhausted => true,
        };
        if over && let Some(sampled) = work.sampled.take() {
            let (_, _, mut waiting) = *sampled;
            if let Some((counts, _)) = &self.best {
                waiting.aim = waiting.aim.max(counts.difference() + 1);
            }
            self.begin_stage(work, Stage::Find(waiting));
        }
        Ok(false)
    }

    /// Begins to look for a shortest plan; true where there is nothing to look for, or too much.
    fn shorten(&mut self, work: &mut Work) -> bool {
        let Some((counts, plan)) = &self.best else { return true };
        if work.space.joint.has_unlisted() && self.horizon.is_none() {
            self.length_proved = plan.is_empty();
            return true;
        }
        if self.horizon.is_some() || plan.is_empty() {
            self.length_proved = true;
            return true;
        }
        let actor = if work.estimates.pairs.is_some() { Actor::State } else { Actor::Word };
        let way = Way {
            actor,
            order: Order::Length,
            horizon: None,
            dominance: self.schedule.dominance,
            shorter_than: plan.len() as u32,
            alone: None,
        };
        let search = Search::new(&work.space, way, counts.difference());
        self.begin_stage(work, Stage::Shorten(search));
        false
    }

    /// Changes the means of a long search for a shortest plan, or ends it.
    fn go_on_shortening(&mut self, work: &mut Work) -> Result<bool, LimitReached> {
        let expansions = self.expansions - work.begun.0;
        if !work.tried_pairs && expansions >= self.schedule.pairs_to_shorten {
            // The estimates are better from now on, so it begins again.
            let better = self.make_pairs(work)? || work.estimates.list(&mut work.space)?;
            return Ok(better && self.shorten(work));
        }
        Ok(expansions > EXPANSIONS_TO_SHORTEN
            || work.space.touched - work.begun.1 > WORK_TO_SHORTEN)
    }
}
