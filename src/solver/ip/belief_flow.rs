//! The belief-flow encoding: small, and nearly integral.
//!
//! Under one sensor beliefs form a deterministic automaton, and the part of it that a horizon can
//! reach is small. So for each observer `i` there is a network whose nodes are (step, state,
//! belief of `i`) and whose arcs are the actor's transitions; a plan is a unit of flow through it.
//! The networks of all observers are tied together on each transition of the actor, and nothing
//! else:
//!
//! - `f_{i,t,v,a} ∈ [0, 1]` is the flow of observer `i` out of node `v` by action `a`,
//! - *start*: the flow out of (0, I, B₀) is 1,
//! - *keep*: what flows into a node flows out of it,
//! - *tie*: for each step and transition (s, a), the flows of all observers, summed over their
//!   beliefs, are equal,
//! - what an arc into (T, s, B) carries adds `|G_i(B)|` to the count of observer `i`.
//!
//! The flows of the first observer are binary. Then the actor's path is one path, and since its
//! symbols decide every belief on it, so are the flows of all the others.
//!
//! Bounds need no rows: a node at step T whose belief breaks them is left out, and so is every node
//! that leads to no other. Nodes from which the same transitions lead to the same counts are one
//! node: the layered automaton is minimised from the last step to the first, as acyclic automata
//! are (Revuz 1992, doi:10.1016/0304-3975(92)90142-3).

use fixedbitset::FixedBitSet;
use rustc_hash::{FxHashMap, FxHashSet};

use super::Encoded;
use super::model::{Comparison, Kind, Model, Name, Variable};
use super::objective::maximise_difference;
use crate::belief::BeliefId;
use crate::limits::LimitReached;
use crate::problem::{JointSpace, Role};
use crate::solver::ground::dead_ends::StatesBySteps;
use crate::solver::{Bounds, Stats};
use crate::task::{Action, StateId};

/// A transition in the network of one observer.
#[derive(Debug, Clone, Copy)]
struct Arc {
    from: u32,
    to: u32,
    /// Its position in the list of edges of the state space, the same for all observers.
    edge: u32,
}

/// The network of one observer: nodes are numbered within their step.
#[derive(Debug)]
struct Network {
    /// How many nodes each step has.
    sizes: Vec<usize>,
    /// The arcs out of each step.
    arcs: Vec<Vec<Arc>>,
    /// For each node of the last step how many goals survive, where the bounds allow it.
    ends: Vec<Option<usize>>,
}

impl Network {
    /// Everything that can be reached along live states.
    fn new(
        joint: &mut JointSpace,
        bounds: &Bounds,
        observer: usize,
        live: &StatesBySteps,
        horizon: usize,
    ) -> Result<Self, LimitReached> {
        let start = joint.initial();
        let belief = joint.belief(start.profile, observer);
        let mut nodes = vec![vec![(start.state, belief)]];
        let mut arcs = Vec::new();
        let mut size = 0;
        for step in 0..horizon {
            let mut next = Vec::new();
            let mut numbers: FxHashMap<(StateId, BeliefId), u32> = FxHashMap::default();
            let mut out = Vec::new();
            for (from, &(state, belief)) in (0..).zip(&nodes[step]) {
                joint.states_mut().expand(state);
                for edge in joint.states().edge_range(state) {
                    let target = joint.states().all_edges()[edge].target;
                    if !live.contains(step + 1, target) {
                        continue;
                    }
                    let symbol = joint.symbol(observer, edge);
                    let node = (target, joint.update(observer, belief, symbol)?);
                    let to = *numbers.entry(node).or_insert_with(|| {
                        next.push(node);
                        next.len() as u32 - 1
                    });
                    out.push(Arc { from, to, edge: edge as u32 });
                }
            }
            // A nonzero or two for each arc: more than the limit is no use to anybody.
            size += out.len() as u64;
            if 2 * size > joint.limits().nonzeros {
                return Err(LimitReached::Model { limit: joint.limits().nonzeros });
            }
            nodes.push(next);
            arcs.push(out);
        }
        let sizes = nodes.iter().map(Vec::len).collect();
        let end = |&(_, belief): &(StateId, BeliefId)| worth(joint, bounds, observer, belief);
        let ends = nodes[horizon].iter().map(end).collect();
        Ok(Self { sizes, arcs, ends })
    }

    /// Drops arcs that cannot end in an allowed node, or that no other observer's network has any
    /// more, or that nothing leads to; true when that changed anything.
    fn prune(&mut self, shared: &[FixedBitSet]) -> bool {
        let before: usize = self.arcs.iter().map(Vec::len).sum();
        let ends = self.ends.iter().enumerate().filter(|(_, end)| end.is_some());
        let mut wanted: FixedBitSet = ends.map(|(node, _)| node).collect();
        for step in (0..self.arcs.len()).rev() {
            self.arcs[step].retain(|arc| {
                wanted.contains(arc.to as usize) && shared[step].contains(arc.edge as usize)
            });
            wanted = self.arcs[step].iter().map(|arc| arc.from as usize).collect();
        }
        let mut reached: FixedBitSet = std::iter::once(0).collect();
        for arcs in &mut self.arcs {
            arcs.retain(|arc| reached.contains(arc.from as usize));
            reached = arcs.iter().map(|arc| arc.to as usize).collect();
        }
        self.arcs.iter().map(Vec::len).sum::<usize>() != before
    }

    /// Makes one node of all nodes of a step that the same transitions lead out of to the same
    /// nodes; at the last step, of those of one state with the same count.
    fn minimise(&mut self) {
        let horizon = self.arcs.len();
        // The class of each node of the step after the present one.
        let mut classes: Vec<u32> = Vec::new();
        for step in (0..=horizon).rev() {
            // What tells nodes apart: transitions and classes, or the count at the end. Arcs into
            // the same class by the same transition come from the same state.
            let mut signatures: Vec<Vec<(u32, u32)>> = vec![Vec::new(); self.sizes[step]];
            if step == horizon {
                for (signature, end) in signatures.iter_mut().zip(&self.ends) {
                    signature.extend(end.map(|count| (u32::MAX, count as u32)));
                }
            } else {
                for arc in &self.arcs[step] {
                    signatures[arc.from as usize].push((arc.edge, classes[arc.to as usize]));
                }
            }
            let mut numbers: FxHashMap<Vec<(u32, u32)>, u32> = FxHashMap::default();
            let mut of_nodes = Vec::with_capacity(signatures.len());
            for signature in signatures {
                let next = numbers.len() as u32;
                of_nodes.push(*numbers.entry(signature).or_insert(next));
            }
            if step == horizon {
                let mut ends = vec![None; numbers.len()];
                for (&class, &end) in of_nodes.iter().zip(&self.ends) {
                    ends[class as usize] = end;
                }
                self.ends = ends;
            } else {
                self.merge(step, &of_nodes, &classes);
            }
            self.sizes[step] = numbers.len();
            classes = of_nodes;
        }
    }

    /// Renames both ends of the arcs out of a step and drops those that are there already.
    fn merge(&mut self, step: usize, from: &[u32], to: &[u32]) {
        let mut known = FxHashSet::default();
        self.arcs[step].retain_mut(|arc| {
            arc.from = from[arc.from as usize];
            arc.to = to[arc.to as usize];
            known.insert((arc.from, arc.edge))
        });
    }

    /// The edges that occur at each step.
    fn edges(&self) -> Vec<FixedBitSet> {
        self.arcs.iter().map(|arcs| arcs.iter().map(|arc| arc.edge as usize).collect()).collect()
    }
}

/// How many goals survive for an observer in a belief; none where that breaks the bounds.
fn worth(
    joint: &mut JointSpace,
    bounds: &Bounds,
    observer: usize,
    belief: BeliefId,
) -> Option<usize> {
    let role = joint.problem().observers()[observer].role;
    let survivors = joint.survivors(observer, belief);
    let count = survivors.len();
    let counts = match role {
        Role::Adversarial => bounds.at_least.is_none_or(|k| count >= k),
        Role::Cooperative => bounds.at_most.is_none_or(|j| count <= j),
    };
    let mut required = bounds.required.iter().filter(|w| w.observer == observer);
    let mut forbidden = bounds.forbidden.iter().filter(|w| w.observer == observer);
    let goals = required.all(|w| survivors.contains(w.goal))
        && !forbidden.any(|w| survivors.contains(w.goal));
    (counts && goals).then_some(count)
}

/// Writes the model; none when some observer's network has no way to an allowed end.
///
/// # Errors
///
/// The memory limit, or the limit on the size of a model.
pub(super) fn encode(
    joint: &mut JointSpace,
    bounds: &Bounds,
    horizon: usize,
) -> Result<Option<Encoded>, LimitReached> {
    let live = StatesBySteps::new(joint, horizon)?;
    let start = joint.initial();
    if !live.contains(0, start.state) {
        return Ok(None);
    }
    let observers = joint.problem().observers().len();
    let mut networks = Vec::new();
    for observer in 0..observers {
        let network = Network::new(joint, bounds, observer, &live, horizon)?;
        if network.ends.iter().all(Option::is_none) {
            return Ok(None);
        }
        networks.push(network);
    }
    // Until nothing changes: a transition that one network has lost is of no use to the others.
    loop {
        let mut shared = networks[0].edges();
        for network in &networks[1..] {
            for (mine, theirs) in shared.iter_mut().zip(network.edges()) {
                mine.intersect_with(&theirs);
            }
        }
        let mut changed = false;
        for network in &mut networks {
            changed |= network.prune(&shared);
        }
        if !changed {
            break;
        }
    }
    if horizon > 0 && networks.iter().any(|network| network.arcs[0].is_empty()) {
        return Ok(None);
    }
    networks.iter_mut().for_each(Network::minimise);
    write(joint, &networks, horizon).map(Some)
}

fn write(
    joint: &mut JointSpace,
    networks: &[Network],
    horizon: usize,
) -> Result<Encoded, LimitReached> {
    let problem = std::sync::Arc::clone(joint.problem());
    let limits = *joint.limits();
    let mut model = Model::default();
    model.note("belief-flow encoding: f_i_t_v_a is the flow of observer i at step t");
    model.note("out of node v (a state and a belief of i) by transition a");
    let mut counts: Vec<Vec<(Variable, f64)>> = vec![Vec::new(); networks.len()];
    let mut choices: Vec<Vec<(Action, Vec<Variable>)>> = Vec::new();
    // Variables on each edge of each step, by observer, to tie together.
    let mut ties: Vec<FxHashMap<u32, Vec<Vec<Variable>>>> = vec![FxHashMap::default(); horizon];
    for (observer, network) in networks.iter().enumerate() {
        let kind = if observer == 0 { Kind::Binary } else { Kind::Continuous };
        let mut into: Vec<Vec<Variable>> = Vec::new();
        for (step, ties) in ties.iter_mut().enumerate() {
            let mut out = vec![Vec::new(); network.sizes[step]];
            let mut next = vec![Vec::new(); network.sizes[step + 1]];
            for arc in &network.arcs[step] {
                let numbers = [observer, step, arc.from as usize, arc.edge as usize];
                let flow = model.add(Name::new("f", numbers), kind);
                out[arc.from as usize].push((flow, 1.0));
                next[arc.to as usize].push(flow);
                let tied = ties.entry(arc.edge);
                tied.or_insert_with(|| vec![Vec::new(); networks.len()])[observer].push(flow);
                if step + 1 == horizon {
                    let survivors = network.ends[arc.to as usize].unwrap_or_default();
                    counts[observer].push((flow, survivors as f64));
                }
            }
            for (node, mut terms) in out.into_iter().enumerate() {
                let name = |letter| Name::new(letter, [observer, step, node]);
                if step == 0 {
                    model.row(name("start"), terms, Comparison::Equal, 1.0);
                } else if !into[node].is_empty() {
                    terms.extend(into[node].iter().map(|&flow| (flow, -1.0)));
                    model.row(name("keep"), terms, Comparison::Equal, 0.0);
                }
            }
            into = next;
            model.check(&limits)?;
        }
    }
    for (step, ties) in ties.into_iter().enumerate() {
        let mut ties: Vec<_> = ties.into_iter().collect();
        ties.sort_unstable_by_key(|(edge, _)| *edge);
        let mut taken: Vec<(Action, Vec<Variable>)> = Vec::new();
        for (edge, flows) in ties {
            let action = joint.states().all_edges()[edge as usize].action;
            match taken.iter_mut().find(|(known, _)| *known == action) {
                Some((_, variables)) => variables.extend(&flows[0]),
                None => taken.push((action, flows[0].clone())),
            }
            for observer in 1..networks.len() {
                let mine = flows[0].iter().map(|&flow| (flow, 1.0));
                let theirs = flows[observer].iter().map(|&flow| (flow, -1.0));
                let name = Name::new("tie", [observer, step, edge as usize]);
                model.row(name, mine.chain(theirs).collect(), Comparison::Equal, 0.0);
            }
        }
        choices.push(taken);
        model.check(&limits)?;
    }
    if horizon == 0 {
        // Nothing to decide: a variable fixed at 1 carries what the initial beliefs are worth.
        let one = model.add(Name::new("one", []), Kind::Binary);
        model.fix(one, 1.0);
        for (count, network) in counts.iter_mut().zip(networks) {
            count.push((one, network.ends[0].unwrap_or_default() as f64));
        }
    }
    maximise_difference(&mut model, &problem, &counts);
    model.check(&limits)?;
    Ok(Encoded { model, choices, spaces: Stats::default() })
}
