//! Candidate goals by permutation: the objects of a goal change places with others of their kind.

use std::collections::BTreeMap;

use rand::Rng;
use rustc_hash::{FxHashMap, FxHashSet};

use crate::domain::generate::draw;
use crate::pddl::{Atom, Condition, Domain, ObjectId, TaskDefinition, TypeId};

/// How many permutations are drawn.
const MAX_DRAWS: u32 = 10_000;

/// What objects have in common that may change places: their declared types, and the predicates of one argument that
/// hold for them and that no action changes, by which tasks without types tell kinds of objects apart.
type Kind = (Vec<TypeId>, Vec<usize>);

/// Permutations of the objects of a goal within their kinds.
#[derive(Debug)]
pub(super) struct Permutations<'a> {
    goal: &'a Condition,
    /// The objects of the goal, kind by kind, in order.
    kinds: Vec<Vec<ObjectId>>,
}

impl<'a> Permutations<'a> {
    /// Those of the goal of a task.
    pub(super) fn new(domain: &Domain, task: &'a TaskDefinition) -> Self {
        let changing: FxHashSet<usize> = domain.changing().collect();
        let mut properties: FxHashMap<ObjectId, Vec<usize>> = FxHashMap::default();
        for atom in &task.initial {
            let predicate = atom.predicate.index();
            if let ([object], false) = (&*atom.objects, changing.contains(&predicate)) {
                properties.entry(*object).or_default().push(predicate);
            }
        }
        let atoms = task.goal.positive.iter().chain(&task.goal.negative);
        let mut objects: Vec<ObjectId> = atoms.flat_map(|atom| atom.objects.to_vec()).collect();
        objects.sort_unstable();
        objects.dedup();
        let mut kinds: BTreeMap<Kind, Vec<ObjectId>> = BTreeMap::new();
        for object in objects {
            let types = task.objects.types(object).types().to_vec();
            let properties = properties.remove(&object).unwrap_or_default();
            kinds.entry((types, properties)).or_default().push(object);
        }
        Self { goal: &task.goal, kinds: kinds.into_values().collect() }
    }

    /// The goal with its objects in places drawn at random.
    fn drawn(&self, random: &mut impl Rng) -> Condition {
        let mut place: FxHashMap<ObjectId, ObjectId> = FxHashMap::default();
        for objects in &self.kinds {
            let drawn = draw(random, &mut objects.clone(), objects.len());
            place.extend(objects.iter().copied().zip(drawn));
        }
        let moved = |atoms: &[Atom]| {
            let mut atoms: Vec<Atom> = atoms
                .iter()
                .map(|atom| Atom {
                    predicate: atom.predicate,
                    objects: atom.objects.iter().map(|object| place[object]).collect(),
                })
                .collect();
            atoms.sort_unstable();
            atoms
        };
        Condition {
            positive: moved(&self.goal.positive),
            negative: moved(&self.goal.negative),
            ..Condition::default()
        }
    }

    /// The goal and others, `count` in all and each once, or fewer where no more are found. Those that are not
    /// `wanted` are left out; those that hold at the start come only where there are not enough others.
    pub(super) fn goals(
        &self,
        count: usize,
        random: &mut impl Rng,
        wanted: impl Fn(&Condition) -> bool,
        holds: impl Fn(&Condition) -> bool,
    ) -> Vec<Condition> {
        let mut known = FxHashSet::from_iter([self.goal.clone()]);
        let (mut goals, mut held) = (vec![self.goal.clone()], Vec::new());
        for _ in 0..MAX_DRAWS {
            if goals.len() >= count {
                break;
            }
            let goal = self.drawn(random);
            if !known.insert(goal.clone()) || !wanted(&goal) {
                continue;
            }
            if holds(&goal) { held.push(goal) } else { goals.push(goal) }
        }
        held.truncate(count.saturating_sub(goals.len()));
        goals.append(&mut held);
        goals
    }
}
