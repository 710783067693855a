//! Problem documents: values moved, doubled, left out, and taken from other documents.

use std::fmt::Write;
use std::sync::Arc;

use mo_copp::domain::Document;
use mo_copp::solver::{Horizon, Options, Run, Solver};

use crate::dice::Dice;
use crate::{Target, json, repository_documents, shape};

pub struct Documents;

impl Target for Documents {
    fn name(&self) -> &'static str {
        "documents"
    }

    fn seeds(&self) -> Vec<String> {
        repository_documents()
    }

    fn changed(&self, dice: &mut Dice, input: &str, other: &str) -> String {
        json::changed(dice, input, other)
    }

    fn behaviour(&self, input: &str) -> String {
        let document = match Document::parse(input) {
            Ok(document) => document,
            Err(error) => return shape(&error.to_string()),
        };
        assert_eq!(Document::parse(&document.to_json()).as_ref(), Ok(&document), "read again");
        let problem = match document.problem() {
            Ok(problem) => Arc::new(problem),
            Err(error) => return shape(&error.to_string()),
        };
        let mut said = format!(
            "{} goals, {} observers",
            problem.goals().len().min(8),
            problem.observers().len()
        );
        for solver in Solver::ALL {
            let mut options = Options::new(solver);
            options.limits.bytes = 64 << 20;
            options.limits.expansions = 50;
            options.limits.nonzeros = 5_000;
            options.limits.nodes = 5;
            if solver == Solver::Ip {
                options.horizon = Horizon::Steps(2);
            }
            let mut run = Run::new(Arc::clone(&problem), options).unwrap();
            for _ in 0..20 {
                if run.advance(10).unwrap() {
                    break;
                }
            }
            let outcome = run.outcome().unwrap();
            let has_plan = outcome.goal_difference.is_some();
            // Writing to a text cannot fail.
            let _ = write!(said, ", {:?} {has_plan}", outcome.status);
        }
        said
    }
}
