//! Plans as texts: actions with commas between them, or one on each line.

use std::path::Path;

use mo_copp::plan::Plan;
use mo_copp::problem::Problem;
use rustc_hash::FxHashSet;

use super::error::CliError;
use super::input;

/// The plan that the arguments give: by its text or by a file; without either the plan without actions.
pub fn plan(problem: &Problem, text: Option<&str>, file: Option<&Path>) -> Result<Plan, CliError> {
    let names = match (text, file) {
        (Some(plan), _) => Known::of(problem).between_commas(plan),
        (None, Some(file)) => Known::of(problem).on_lines(&input::text(file)?),
        (None, None) => Vec::new(),
    };
    Ok(Plan::from_names(problem.task(), &names)?)
}

/// The names of what can be done.
struct Known<'t>(FxHashSet<&'t str>);

impl<'t> Known<'t> {
    fn of(problem: &'t Problem) -> Self {
        let task = problem.task();
        let operators = task.operators().iter();
        Self(operators.map(|operator| task.action_name(operator.action)).collect())
    }

    /// The action that is written here, by the name that the task has for it: with blanks around it
    /// or not, and operators of PDDL also in capitals, with more blanks between the words, and
    /// without parentheses.
    fn named(&self, written: &str) -> Option<String> {
        let bare = written.trim();
        let line = written.strip_suffix('\r').unwrap_or(written);
        if let Some(name) = [written, line, bare].into_iter().find(|name| self.0.contains(name)) {
            return Some(name.to_owned());
        }
        let inner = match (bare.strip_prefix('('), bare.ends_with(')')) {
            (Some(inner), true) => inner.strip_suffix(')')?,
            (None, false) => bare,
            _ => return None,
        };
        let words: Vec<String> = inner.split_whitespace().map(str::to_lowercase).collect();
        let in_pddl = format!("({})", words.join(" "));
        self.0.contains(&in_pddl[..]).then_some(in_pddl)
    }

    /// The names of a plan that has commas between them. Names may hold commas themselves: the
    /// longest stretch that is an action is one.
    fn between_commas(&self, plan: &str) -> Vec<String> {
        if plan.trim().is_empty() && self.named(plan).is_none() {
            return Vec::new();
        }
        let most = self.0.iter().map(|name| name.matches(',').count()).max().unwrap_or(0);
        // Where each part begins and ends.
        let mut parts = Vec::new();
        let mut begin = 0;
        for part in plan.split(',') {
            parts.push((begin, begin + part.len()));
            begin += part.len() + 1;
        }
        let mut names = Vec::new();
        let mut next = 0;
        while let Some(&(begin, end)) = parts.get(next) {
            let longest = parts.len().min(next + most + 1);
            let action = (next..longest)
                .rev()
                .find_map(|last| Some((self.named(&plan[begin..parts[last].1])?, last)));
            let (name, last) = action.unwrap_or_else(|| (plan[begin..end].trim().to_owned(), next));
            names.push(name);
            next = last + 1;
        }
        names
    }

    /// The names of a plan that has one on each line. Other planners write what they found about a
    /// plan as comments of PDDL.
    fn on_lines(&self, plan: &str) -> Vec<String> {
        let name = |line: &str| {
            let bare = line.trim();
            let is_plain = !bare.is_empty() && !bare.starts_with(';');
            self.named(line).or_else(|| is_plain.then(|| bare.to_owned()))
        };
        plan.split('\n').filter_map(name).collect()
    }
}
