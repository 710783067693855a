//! Beliefs as multi-valued decision diagrams, which never list their states.
//!
//! A diagram has a level for each group of exclusive facts of the task, in the task's group order, and a node an edge for each
//! value of its group that some state of the set takes (Srinivasan et al. 1990, "Algorithms for discrete function
//! manipulation", doi:10.1109/ICCAD.1990.129849). Nodes are interned, so that equal sets are the same number and beliefs
//! share what they have in common. A belief of 10⁹ states can take a few hundred nodes.
//!
//! - [`store`]: the nodes, union; `condition`: where a conjunction of facts holds.
//! - [`relation`]: the operators behind a symbol as one relation, and the image of a set under it.
//! - [`reachable`](mod@reachable): all states of a task.
//! - [`measure`]: how many states a set has, in how many a fact holds, some of its states.

mod condition;
pub mod measure;
pub mod reachable;
pub mod relation;
mod step;
pub mod store;
#[cfg(test)]
mod tests;

pub use measure::StateCount;
pub use reachable::reachable;
pub use relation::{SymbolRelations, suits};
pub use store::{Diagrams, SetId};
