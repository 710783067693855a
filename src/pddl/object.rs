//! Objects and constants, and their names.

use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::error::PddlError;
use super::expression::{Expression, Expressions};
use super::types::{TypeSet, Types};

/// An object of a task or a constant of its domain, by its number. The constants come first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ObjectId(u32);

impl ObjectId {
    pub(super) fn new(index: usize) -> Self {
        Self(index as u32)
    }

    /// Its number.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// Objects with their types.
#[derive(Debug, Clone, Default)]
pub struct Objects {
    names: Vec<String>,
    types: Vec<Arc<TypeSet>>,
    numbers: FxHashMap<String, ObjectId>,
}

impl Objects {
    /// Reads a typed list, after the objects that are there already.
    pub(super) fn read(&mut self, types: &Types, items: Expressions<'_>) -> Result<(), PddlError> {
        for (item, set) in types.list(items)? {
            let name = item.name("the name of an object")?;
            let id = ObjectId::new(self.names.len());
            if self.numbers.insert(name.clone(), id).is_some() {
                let found = format!("the object {} for the second time", item.shown());
                return Err(item.wrong(found, "each object and constant declared once"));
            }
            self.names.push(name);
            self.types.push(set);
        }
        Ok(())
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }

    /// All of them, in order.
    pub fn ids(&self) -> impl Iterator<Item = ObjectId> + use<> {
        (0..self.names.len()).map(ObjectId::new)
    }

    /// The name of one, in small letters.
    pub fn name(&self, id: ObjectId) -> &str {
        &self.names[id.index()]
    }

    /// The one of this name, which stands here in small letters.
    pub fn named(&self, name: &str) -> Option<ObjectId> {
        self.numbers.get(name).copied()
    }

    /// The types one was declared with. With `either` it is of each of them.
    pub fn types(&self, id: ObjectId) -> &TypeSet {
        &self.types[id.index()]
    }

    /// The object named here.
    pub(super) fn find(&self, place: Expression<'_>) -> Result<ObjectId, PddlError> {
        let name = place.name("the name of an object")?;
        self.named(&name).ok_or_else(|| {
            let found = format!("the undeclared object {}", place.shown());
            let names = super::types::some(self.names.iter().map(String::as_str));
            place.wrong(found, format!("an object or a constant: {names}"))
        })
    }
}
