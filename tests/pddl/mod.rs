//! The PDDL reader and the grounder.

mod ipc;
