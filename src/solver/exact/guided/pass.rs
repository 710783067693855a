//! Looks for a plan that is worth at least so much.
//!
//! Depth first, in the order of the operators, through the nodes that can be part of such a plan as
//! far as the estimates say. At a horizon, a node is gone into once for each step. Over all lengths,
//! the length is raised from the least that the estimates allow, as in iterative deepening A*
//! (Korf 1985, doi:10.1016/0004-3702(85)90084-0), and a node is gone into again only with more
//! actions left than before; so the plan found is a shortest one. Of several the one whose actions
//! come first is found.

use fixedbitset::FixedBitSet;

use super::estimates::Aim;
use super::ground::Ground;
use super::twins::NEVER;
use crate::limits::LimitReached;
use crate::plan::Plan;

/// Nothing is known of a node.
const UNKNOWN: u32 = u32::MAX - 1;

/// What a step has come to.
#[derive(Debug)]
pub(super) enum Went {
    /// It goes on.
    On,
    /// A plan that is worth what is aimed at.
    Found(Plan),
    /// There is none.
    Nowhere,
}

/// Which nodes have been gone into in vain.
#[derive(Debug)]
enum Vain {
    /// With so many actions left, plus one; 0 for none.
    Within(Vec<u32>),
    /// After each number of steps.
    After(Vec<FixedBitSet>),
}

/// One search.
#[derive(Debug)]
pub(super) struct Pass {
    pub(super) aim: Aim,
    /// The most actions of a plan.
    length: u32,
    begun: bool,
    /// Nodes, each with the place of the next transition to take.
    stack: Vec<(u32, u32)>,
    vain: Vain,
    /// The estimate of each node in this edition of the tables.
    estimates: Vec<u32>,
    edition: u32,
    /// Nodes that take more actions than there are, with the fewest steps that lead to them.
    beyond: Vec<u32>,
    steps_to: Vec<u32>,
    visits: u64,
    /// Visits after which others have their turn.
    pub(super) turn: u64,
}

impl Pass {
    pub(super) fn new(aim: Aim, horizon: Option<usize>, turn: u64) -> Self {
        Self {
            aim,
            length: horizon.unwrap_or_default() as u32,
            begun: false,
            stack: Vec::new(),
            vain: match horizon {
                None => Vain::Within(Vec::new()),
                Some(steps) => Vain::After(vec![FixedBitSet::new(); steps + 1]),
            },
            estimates: Vec::new(),
            edition: 0,
            beyond: Vec::new(),
            steps_to: Vec::new(),
            visits: 0,
            turn,
        }
    }

    /// Whether it is time for others.
    pub(super) fn had_its_turn(&self) -> bool {
        self.visits >= self.turn
    }

    /// Bytes in use, counted by contents.
    pub(super) fn bytes(&self) -> u64 {
        let vain = match &self.vain {
            Vain::Within(left) => 4 * left.len(),
            Vain::After(steps) => steps.iter().map(|nodes| nodes.len() / 8).sum(),
        };
        let lists = self.estimates.len() + self.beyond.len() + self.steps_to.len();
        (vain + 4 * lists + 8 * self.stack.len()) as u64
    }

    fn estimate(&mut self, ground: &mut Ground, node: u32) -> u32 {
        if self.edition != ground.estimates.edition() {
            self.edition = ground.estimates.edition();
            self.estimates.clear();
        }
        let number = node as usize;
        if self.estimates.len() <= number {
            self.estimates.resize(ground.graph.len(), UNKNOWN);
        }
        if self.estimates[number] == UNKNOWN {
            self.estimates[number] = ground.least(number, self.aim);
        }
        self.estimates[number]
    }

    /// Whether a node was gone into in vain, with so many actions left after so many steps.
    fn in_vain(&self, node: u32, steps: usize, left: u32) -> bool {
        match &self.vain {
            Vain::Within(known) => known.get(node as usize).is_some_and(|&known| known > left),
            Vain::After(known) => known[steps].contains(node as usize),
        }
    }

    /// Goes into a node. Until it is known better this counts as in vain.
    fn go_into(&mut self, ground: &mut Ground, node: u32) -> Result<Went, LimitReached> {
        ground.check_limits(self)?;
        ground.count_visit();
        self.visits += 1;
        let steps = self.stack.len();
        let left = self.length - steps as u32;
        match &mut self.vain {
            Vain::Within(known) => {
                known.resize(known.len().max(ground.graph.len()), 0);
                known[node as usize] = left + 1;
            }
            Vain::After(known) => known[steps].grow_and_insert(node as usize),
        }
        self.stack.push((node, 0));
        let open = self.is_open();
        if (open || left == 0)
            && let Some(counts) = ground.worth(node as usize)
        {
            if ground.is_better(counts) {
                ground.best = Some((counts, self.plan(ground)));
            }
            if counts.difference() >= self.aim.value {
                return Ok(Went::Found(self.plan(ground)));
            }
        }
        if open || left > 0 {
            ground.expand(node as usize)?;
        }
        Ok(Went::On)
    }

    /// Whether plans of all lengths are looked for.
    fn is_open(&self) -> bool {
        matches!(self.vain, Vain::Within(_))
    }

    /// The actions that led to where it is.
    fn plan(&self, ground: &Ground) -> Plan {
        let taken = |pair: &[(u32, u32)]| {
            let (node, next) = pair[0];
            ground.graph.after(node as usize)[next as usize - 1].1
        };
        Plan { actions: self.stack.windows(2).map(taken).collect() }
    }

    /// Begins at the first node; with more actions than before, unless there is a horizon.
    fn begin(&mut self, ground: &mut Ground) -> Result<Went, LimitReached> {
        let least = match (&self.vain, self.begun) {
            (Vain::After(_), true) => NEVER,
            (Vain::After(_), false) if !ground.can_end(0, self.length) => NEVER,
            (_, false) => self.estimate(ground, 0),
            (Vain::Within(_), true) => {
                ground.complete();
                self.raised(ground)
            }
        };
        if least == NEVER || (!self.is_open() && least > self.length) {
            return Ok(Went::Nowhere);
        }
        if !self.begun {
            ground.reach(least.max(self.length));
        }
        self.begun = true;
        self.length = self.length.max(least);
        self.go_into(ground, 0)
    }

    /// The fewest actions with which another node can be gone into.
    fn raised(&mut self, ground: &mut Ground) -> u32 {
        let mut beyond = std::mem::take(&mut self.beyond);
        let mut length = NEVER;
        beyond.retain(|&node| {
            let gone_into = self.in_vain(node, 0, 0);
            let least = if gone_into { NEVER } else { self.estimate(ground, node) };
            if least != NEVER {
                length = length.min(self.steps_to[node as usize] + least);
            }
            least != NEVER
        });
        self.beyond = beyond;
        length
    }

    /// Takes one transition, or goes back over one.
    pub(super) fn step(&mut self, ground: &mut Ground) -> Result<Went, LimitReached> {
        let Some((node, next)) = self.stack.last_mut() else {
            return self.begin(ground);
        };
        let Some(&(after, _)) = ground.graph.after(*node as usize).get(*next as usize) else {
            self.stack.pop();
            return Ok(Went::On);
        };
        *next += 1;
        let (open, steps) = (self.is_open(), self.stack.len());
        let left = self.length.checked_sub(steps as u32);
        let known = match left {
            Some(left) => {
                self.in_vain(after, steps, left) || !open && !ground.can_end(after as usize, left)
            }
            None => !open || self.in_vain(after, steps, 0),
        };
        if known {
            return Ok(Went::On);
        }
        let least = self.estimate(ground, after);
        if left.is_some_and(|left| least <= left) {
            return self.go_into(ground, after);
        }
        if open && least != NEVER {
            self.put_beyond(ground, after, steps as u32);
        }
        Ok(Went::On)
    }

    fn put_beyond(&mut self, ground: &Ground, node: u32, steps: u32) {
        self.steps_to.resize(self.steps_to.len().max(ground.graph.len()), UNKNOWN);
        let known = &mut self.steps_to[node as usize];
        if *known == UNKNOWN {
            self.beyond.push(node);
        }
        *known = steps.min(*known);
    }
}
