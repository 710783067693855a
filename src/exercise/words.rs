//! Words of questions, by the format of their problem: what a goal is about, and what a belief is made of.

use crate::domain::Document;

/// That the true goal holds at the end of a walk.
pub(super) fn ends_in_goal(document: &Document) -> &'static str {
    match document {
        Document::Gridworld(_) => "At the end of its walk the agent is in its goal.",
        Document::BoxPushing(_) => "At the end of the agent's walk the box is in its goal.",
        Document::RecyclingRobot(_) => "At the end of the robot's walk the can is in its goal.",
        _ => "At the end of the agent's walk its goal holds.",
    }
}

/// What an observer knows at the end of a walk.
pub(super) fn asks_for_belief(document: &Document, who: &str) -> String {
    match document {
        Document::Gridworld(_) => format!("where can the agent be for all that {who} knows?"),
        _ => format!("which states are possible for all that {who} knows?"),
    }
}

/// That a walk does not end where it should.
pub(super) fn misses_goal(document: &Document, end: &str, goal: &str) -> String {
    match document {
        Document::Gridworld(_) => {
            format!("The walk ends at {end}, which is not in the true goal {goal}.")
        }
        _ => format!("The walk ends in {end}, where the true goal {goal} does not hold."),
    }
}
