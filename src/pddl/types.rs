//! Types and their hierarchy.

use std::sync::Arc;

use fixedbitset::FixedBitSet;
use rustc_hash::FxHashMap;

use super::error::{PddlError, quoted};
use super::expression::{Expression, Expressions};

/// The most types of a domain.
pub const MAX_TYPES: usize = 1024;

/// The most names in a `:types` section, which may stand there several times.
const MAX_DECLARED: usize = 4 * MAX_TYPES;

/// The most types in one `(either …)`.
pub const MAX_ALTERNATIVES: usize = 256;

/// A type of a domain, by its number. Number 0 is `object`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TypeId(u32);

impl TypeId {
    /// The type of everything.
    pub const OBJECT: Self = Self(0);

    /// Its number.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// One type, or several with `either`.
#[derive(Debug)]
pub struct TypeSet {
    types: Box<[TypeId]>,
    /// The types of which everything is of one of these, themselves among them.
    below: FixedBitSet,
}

impl TypeSet {
    /// The types, without those below them.
    pub fn types(&self) -> &[TypeId] {
        &self.types
    }

    /// Whether everything of a type is of one of these.
    pub fn contains(&self, id: TypeId) -> bool {
        self.below.contains(id.index())
    }

    /// Whether something declared to be of these types is of one of the types `wanted`.
    pub fn is_within(&self, wanted: &TypeSet) -> bool {
        self.types.iter().any(|&id| wanted.contains(id))
    }

    /// Whether something could be of types of both.
    pub(super) fn meets(&self, other: &TypeSet) -> bool {
        !self.below.is_disjoint(&other.below)
    }
}

/// The types of a domain.
#[derive(Debug, Clone)]
pub struct Types {
    names: Vec<String>,
    numbers: FxHashMap<String, TypeId>,
    /// Each type alone.
    single: Vec<Arc<TypeSet>>,
}

impl Types {
    /// `object` alone.
    pub(super) fn untyped() -> Self {
        let mut below = FixedBitSet::with_capacity(1);
        below.insert(0);
        Self {
            names: vec!["object".to_owned()],
            numbers: std::iter::once(("object".to_owned(), TypeId::OBJECT)).collect(),
            single: vec![Arc::new(TypeSet { types: Box::new([TypeId::OBJECT]), below })],
        }
    }

    /// Reads the typed list of a `:types` section. A type that stands only behind a dash counts as
    /// declared. One that stands there several times, as in the Storage domain of IPC 2006, is
    /// below everything that it was said to be below.
    pub(super) fn read(items: Expressions<'_>) -> Result<Self, PddlError> {
        let mut types = Self::untyped();
        let mut declared: Vec<Option<Expression<'_>>> = vec![None];
        let mut parents: Vec<Vec<TypeId>> = vec![Vec::new()];
        let list = typed_list(items)?;
        if let Some(typed) = list.get(MAX_DECLARED) {
            let found = format!("more than {MAX_DECLARED} names of types");
            return Err(typed.item.wrong(found, "at most that"));
        }
        for typed in list {
            let name = typed.item.name("a type")?;
            let id = types.number(name, typed.item, &mut declared, &mut parents)?;
            let mut above = Vec::new();
            for parent in typed.alternatives()? {
                let name = parent.name("a type")?;
                above.push(types.number(name, parent, &mut declared, &mut parents)?);
            }
            if id == TypeId::OBJECT {
                if above.iter().any(|&parent| parent != TypeId::OBJECT) {
                    return Err(typed.item.wrong("\"object\" with a type of its own", "none"));
                }
                continue;
            }
            declared[id.index()].get_or_insert(typed.item);
            for parent in above {
                if !parents[id.index()].contains(&parent) {
                    parents[id.index()].push(parent);
                }
            }
        }
        types.close(&declared, &parents)?;
        Ok(types)
    }

    fn number<'t>(
        &mut self,
        name: String,
        place: Expression<'t>,
        declared: &mut Vec<Option<Expression<'t>>>,
        parents: &mut Vec<Vec<TypeId>>,
    ) -> Result<TypeId, PddlError> {
        if let Some(&known) = self.numbers.get(&name) {
            return Ok(known);
        }
        if self.names.len() == MAX_TYPES {
            return Err(place.wrong(format!("more than {MAX_TYPES} types"), "at most that"));
        }
        let id = TypeId(self.names.len() as u32);
        self.numbers.insert(name.clone(), id);
        self.names.push(name);
        declared.push(None);
        parents.push(Vec::new());
        Ok(id)
    }

    /// Works out what is below each type, children first.
    fn close(
        &mut self,
        declared: &[Option<Expression<'_>>],
        parents: &[Vec<TypeId>],
    ) -> Result<(), PddlError> {
        let count = self.names.len();
        let mut waiting = vec![0_u32; count];
        for parent in parents.iter().flatten() {
            waiting[parent.index()] += 1;
        }
        let mut below = vec![FixedBitSet::with_capacity(count); count];
        let mut ready: Vec<usize> = (0..count).filter(|&id| waiting[id] == 0).collect();
        let mut done = 0;
        while let Some(id) = ready.pop() {
            done += 1;
            let mut mine = std::mem::take(&mut below[id]);
            mine.insert(id);
            for parent in &parents[id] {
                below[parent.index()].union_with(&mine);
                waiting[parent.index()] -= 1;
                if waiting[parent.index()] == 0 {
                    ready.push(parent.index());
                }
            }
            below[id] = mine;
        }
        if done < count {
            return Err(self.circle(declared, parents, &waiting));
        }
        below[TypeId::OBJECT.index()].insert_range(..);
        let single = |(id, below)| Arc::new(TypeSet { types: Box::new([TypeId(id)]), below });
        self.single = (0..).zip(below).map(single).collect();
        Ok(())
    }

    /// The error that types are above themselves.
    fn circle(
        &self,
        declared: &[Option<Expression<'_>>],
        parents: &[Vec<TypeId>],
        waiting: &[u32],
    ) -> PddlError {
        // Whatever waits has a child that waits: going down enters a circle at last.
        let count = self.names.len();
        let mut child = vec![0; count];
        for (id, parents) in parents.iter().enumerate() {
            for parent in parents.iter().filter(|_| waiting[id] > 0) {
                child[parent.index()] = id;
            }
        }
        let mut at = (0..count).find(|&id| waiting[id] > 0).unwrap_or(0);
        for _ in 0..count {
            at = child[at];
        }
        let found = format!("the type {}, which is below itself", quoted(&self.names[at]));
        let place = declared[at].or_else(|| declared.iter().copied().flatten().next());
        match place {
            Some(place) => place.wrong(found, "no circle of types"),
            None => PddlError { line: 1, column: 1, found, expected: "no circle of types".into() },
        }
    }

    /// The name of a type.
    pub fn name(&self, id: TypeId) -> &str {
        &self.names[id.index()]
    }

    /// The type of this name, in small letters.
    pub fn named(&self, name: &str) -> Option<TypeId> {
        self.numbers.get(name).copied()
    }

    /// All of them, `object` first.
    pub fn ids(&self) -> impl Iterator<Item = TypeId> + use<> {
        (0..self.names.len() as u32).map(TypeId)
    }

    /// One type as a set.
    pub fn alone(&self, id: TypeId) -> &TypeSet {
        &self.single[id.index()]
    }

    /// How many types there are.
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// Never: there is always `object`.
    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }

    /// Reads a typed list; a type stands for all names before it.
    pub(super) fn list<'t>(
        &self,
        items: Expressions<'t>,
    ) -> Result<Vec<(Expression<'t>, Arc<TypeSet>)>, PddlError> {
        let mut list = Vec::new();
        let mut last: Option<(Typed<'_>, Arc<TypeSet>)> = None;
        for typed in typed_list(items)? {
            let types = match &last {
                Some((before, types)) if before.is_typed_as(&typed) => Arc::clone(types),
                _ => self.resolve(&typed)?,
            };
            list.push((typed.item, Arc::clone(&types)));
            last = Some((typed, types));
        }
        Ok(list)
    }

    /// What stands behind a dash: a type or `(either …)`.
    pub(super) fn resolve(&self, typed: &Typed<'_>) -> Result<Arc<TypeSet>, PddlError> {
        let mut types = Vec::new();
        for place in typed.alternatives()? {
            types.push(self.find(place)?);
        }
        types.sort_unstable();
        types.dedup();
        match types[..] {
            [] => Ok(Arc::clone(&self.single[TypeId::OBJECT.index()])),
            [only] => Ok(Arc::clone(&self.single[only.index()])),
            _ => {
                let mut below = FixedBitSet::with_capacity(self.names.len());
                for id in &types {
                    below.union_with(&self.single[id.index()].below);
                }
                Ok(Arc::new(TypeSet { types: types.into_boxed_slice(), below }))
            }
        }
    }

    /// The type named here.
    fn find(&self, place: Expression<'_>) -> Result<TypeId, PddlError> {
        let name = place.name("a type")?;
        self.named(&name).ok_or_else(|| {
            let found = format!("the undeclared type {}", place.shown());
            place.wrong(found, self.some_names())
        })
    }

    /// The type named here, and those below it.
    pub(super) fn find_set(&self, place: Expression<'_>) -> Result<&TypeSet, PddlError> {
        Ok(&*self.single[self.find(place)?.index()])
    }

    /// The names of some types, for an error.
    fn some_names(&self) -> String {
        format!("a type of the domain: {}", some(self.names.iter().map(String::as_str)))
    }

    /// Types as they are written, for an error.
    pub(super) fn written(&self, set: &TypeSet) -> String {
        let names = some(set.types.iter().map(|&id| self.name(id)));
        if set.types.len() == 1 { names } else { format!("either {names}") }
    }
}

/// The first few names, for an error.
pub(super) fn some<'a>(names: impl Iterator<Item = &'a str>) -> String {
    const SHOWN: usize = 8;
    let mut text = String::new();
    for (number, name) in names.enumerate() {
        if number > 0 {
            text.push_str(", ");
        }
        if number == SHOWN {
            text.push('…');
            break;
        }
        text.push_str(name);
    }
    text
}

/// An item of a typed list and what stands behind its dash.
#[derive(Debug, Clone, Copy)]
pub(super) struct Typed<'t> {
    pub item: Expression<'t>,
    pub kind: Option<Expression<'t>>,
}

impl<'t> Typed<'t> {
    /// The types named: one, several with `either`, or none.
    pub(super) fn alternatives(&self) -> Result<Vec<Expression<'t>>, PddlError> {
        const EXPECTED: &str = "a type or (either …)";
        let Some(kind) = self.kind else { return Ok(Vec::new()) };
        if kind.symbol().is_some() {
            return Ok(vec![kind]);
        }
        let (head, items) = kind.headed(EXPECTED)?;
        let items: Vec<_> = items.collect();
        if !head.is("either") || items.is_empty() {
            return Err(kind.expected(EXPECTED));
        }
        if items.len() > MAX_ALTERNATIVES {
            let found = format!("more than {MAX_ALTERNATIVES} types");
            return Err(kind.wrong(found, "at most that"));
        }
        Ok(items)
    }

    /// Whether the types of two items are written by the same dash, or by none.
    pub(super) fn is_typed_as(&self, other: &Typed<'_>) -> bool {
        match (self.kind, other.kind) {
            (None, None) => true,
            (Some(one), Some(other)) => one.is_same(other),
            _ => false,
        }
    }
}

/// Reads `a b - t c`. Linear.
pub(super) fn typed_list(items: Expressions<'_>) -> Result<Vec<Typed<'_>>, PddlError> {
    let mut list: Vec<Typed<'_>> = Vec::new();
    let mut untyped = 0;
    let mut items = items;
    while let Some(item) = items.next() {
        if !item.is("-") {
            list.push(Typed { item, kind: None });
            continue;
        }
        if untyped == list.len() {
            return Err(item.expected("a name before the dash"));
        }
        let Some(kind) = items.next() else {
            return Err(item.wrong("a dash at the end of a list", "a type behind it"));
        };
        for typed in &mut list[untyped..] {
            typed.kind = Some(kind);
        }
        untyped = list.len();
    }
    Ok(list)
}
