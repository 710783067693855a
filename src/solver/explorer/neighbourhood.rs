//! The horizons around one that has no plan: what all plans of it end in, and the nearest shorter and
//! the nearest longer horizon at which a plan keeps the bounds.
//!
//! Layers of a finite space repeat themselves, since each is made of the one before alone. The first
//! repetition tells all layers that follow. Beyond the horizon it is enough to go on until a layer
//! has no node that was not in one since: whatever it leads to has been seen.

use std::sync::Arc;

use fixedbitset::FixedBitSet;
use rustc_hash::FxHashMap;

use super::ends::{Ends, best};
use super::layers::{Layers, Membership};
use crate::limits::{LimitReached, Limits};
use crate::plan::Plan;
use crate::problem::{JointSpace, Problem, SurvivorCounts};
use crate::solver::ground::dead_ends::TrueGoalDistances;
use crate::solver::ground::thresholds::VISITS_OF_LAYERS;
use crate::solver::{Bounds, MAX_HORIZON, Options};

/// An exhaustive exploration around a horizon, or over all lengths where there is none.
#[derive(Debug)]
pub(in crate::solver) struct Neighbourhood {
    joint: JointSpace,
    bounds: Bounds,
    asked: Option<usize>,
    distances: Option<TrueGoalDistances>,
    layers: Layers,
    /// The nodes that end a plan with the goals named in the bounds, whatever the counts.
    ends: Ends,
    /// For each finished layer whether a plan of its length keeps the bounds.
    wanted: Vec<bool>,
    /// The layers up to the horizon by their hashes.
    hashes: FxHashMap<u64, usize>,
    /// Where the layers begin to repeat themselves, and after how many steps.
    cycle: Option<(usize, usize)>,
    /// The nodes of layers beyond the horizon.
    since: FixedBitSet,
    /// Whether such a layer had none that was new.
    closed: bool,
}

impl Neighbourhood {
    /// With the bounds of the options, all of which are heeded.
    pub(in crate::solver) fn new(
        problem: Arc<Problem>,
        options: &Options,
        asked: Option<usize>,
    ) -> Self {
        let mut joint = JointSpace::listing(problem, options.limits);
        let membership = asked.map_or(Membership::First, |_| Membership::Every);
        let bounds = options.bounds.clone();
        let named = Bounds { at_least: None, at_most: None, ..bounds.clone() };
        Self {
            layers: Layers::new(&mut joint, membership),
            joint,
            bounds,
            asked,
            distances: None,
            ends: Ends::new(named),
            wanted: Vec::new(),
            hashes: FxHashMap::default(),
            cycle: None,
            since: FixedBitSet::new(),
            closed: false,
        }
    }

    /// The nodes expanded so far, each once.
    pub(in crate::solver) fn expansions(&self) -> u64 {
        self.layers.expansions()
    }

    /// The length whose layer is being made.
    pub(in crate::solver) fn length(&self) -> Option<usize> {
        self.asked.map(|_| self.layers.length() + 1)
    }

    /// Works for about `budget` visits; true when everything is known. May be called again with
    /// greater limits after one was met.
    ///
    /// # Errors
    ///
    /// A limit.
    pub(in crate::solver) fn advance(
        &mut self,
        mut budget: u64,
        limits: &Limits,
    ) -> Result<bool, LimitReached> {
        let distances = match self.distances.take() {
            Some(distances) => distances,
            None => {
                let distances = TrueGoalDistances::new(&mut self.joint)?;
                self.note();
                distances
            }
        };
        let worked = self.work(&distances, &mut budget, limits);
        self.distances = Some(distances);
        worked
    }

    fn work(
        &mut self,
        distances: &TrueGoalDistances,
        budget: &mut u64,
        limits: &Limits,
    ) -> Result<bool, LimitReached> {
        while !self.is_done() {
            if self.layers.visits() > VISITS_OF_LAYERS {
                return Err(LimitReached::Expansions { limit: limits.expansions });
            }
            let alive = |state| distances.reach_from(state);
            let (joint, layers) = (&mut self.joint, &mut self.layers);
            if !layers.advance(joint, budget, limits, alive, |_| true)? {
                return Ok(false);
            }
            self.note();
        }
        Ok(true)
    }

    fn keeps_bounds(&self, counts: SurvivorCounts) -> bool {
        self.bounds.at_least.is_none_or(|k| counts.adversarial >= k)
            && self.bounds.at_most.is_none_or(|j| counts.cooperative <= j)
    }

    /// Takes note of the layer that is finished.
    fn note(&mut self) {
        self.ends.note(&mut self.joint, &self.layers);
        let Some(asked) = self.asked else { return };
        let length = self.layers.length();
        let layer = self.layers.set(length);
        let wanted = self.ends.of(layer).any(|(_, counts)| self.keeps_bounds(counts));
        self.wanted.push(wanted);
        if length <= asked {
            let hash = layer.ones().fold(0_u64, |hash, node| {
                (hash.rotate_left(5) ^ node as u64).wrapping_mul(0x517c_c1b7_2722_0a95)
            });
            match self.hashes.get(&hash) {
                Some(&first) if self.layers.set(first).ones().eq(layer.ones()) => {
                    self.cycle = Some((first, length - first));
                }
                _ => {
                    self.hashes.insert(hash, length);
                }
            }
        } else {
            let known = self.since.count_ones(..);
            self.since.grow(layer.len());
            self.since.union_with(layer);
            self.closed = self.since.count_ones(..) == known;
        }
    }

    fn is_done(&self) -> bool {
        let Some(asked) = self.asked else {
            let mut ends = self.ends.all().iter();
            return self.layers.ended() || ends.any(|&(_, counts)| self.keeps_bounds(counts));
        };
        let length = self.layers.length();
        self.cycle.is_some()
            || self.layers.ended()
            || self.closed
            || length >= asked && self.wanted[length]
            || length == MAX_HORIZON
    }

    /// The finished layer that has the nodes of a length; none where no node has.
    fn place(&self, length: usize) -> Option<usize> {
        match self.cycle {
            Some((first, period)) if length >= first => Some(first + (length - first) % period),
            _ => (length <= self.layers.length()).then_some(length),
        }
    }

    /// The pairs of survivor counts of plans as asked for, with the goals named in the bounds and
    /// whatever the counts.
    pub(in crate::solver) fn counts(&self) -> Vec<SurvivorCounts> {
        self.ends_as_asked().map(|(_, counts)| counts).collect()
    }

    fn ends_as_asked(&self) -> Box<dyn Iterator<Item = (usize, SurvivorCounts)> + '_> {
        match self.asked {
            None => Box::new(self.ends.all().iter().copied()),
            Some(asked) => match self.place(asked) {
                Some(place) => Box::new(self.ends.of(self.layers.set(place))),
                None => Box::new(std::iter::empty()),
            },
        }
    }

    /// The best plan as asked for whose counts are `wanted`.
    pub(in crate::solver) fn plan(&self, wanted: impl Fn(SurvivorCounts) -> bool) -> Option<Plan> {
        let (node, _) = best(self.ends_as_asked().filter(|&(_, counts)| wanted(counts)))?;
        Some(match self.asked {
            None => self.layers.shortest(node),
            Some(asked) => self.plan_to(asked, node),
        })
    }

    /// The best plans that keep the bounds at the nearest shorter and the nearest longer horizon.
    pub(in crate::solver) fn nearest(&self) -> [Option<Plan>; 2] {
        let Some(asked) = self.asked else { return [None, None] };
        let wanted = |length: &usize| self.place(*length).is_some_and(|place| self.wanted[place]);
        let shorter = (0..asked).rev().find(wanted);
        let last = match self.cycle {
            Some((first, period)) => asked.max(first) + period,
            None => self.layers.length(),
        };
        let longer = (asked + 1..=last.min(MAX_HORIZON)).find(wanted);
        [shorter, longer].map(|length| {
            let length = length?;
            let ends = self.ends.of(self.layers.set(self.place(length)?));
            let (node, _) = best(ends.filter(|&(_, counts)| self.keeps_bounds(counts)))?;
            Some(self.plan_to(length, node))
        })
    }

    fn plan_to(&self, length: usize, node: usize) -> Plan {
        let before = self.layers.predecessors();
        self.layers.plan(&before, length, node, |length| self.place(length).unwrap_or(length))
    }
}
