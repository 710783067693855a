//! A state: the set of facts that hold, packed by a [`Layout`](super::fact::Layout).

/// A packed state. Two states of one task are equal when the same facts hold in them.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct State {
    words: Box<[u64]>,
}

impl State {
    pub(crate) fn from_words(words: Vec<u64>) -> Self {
        Self { words: words.into_boxed_slice() }
    }

    /// The packed words.
    pub fn words(&self) -> &[u64] {
        &self.words
    }
}
