//! The PDDL reader and the grounder.

mod exclusive;
mod fuzz;
mod grounding;
mod ipc;
mod oracle;
mod reading;
