//! Makes a problem of a delivery.

use std::sync::Arc;

use super::{Delivery, DeliveryObserver, LoadSymbols, MAX_PACKAGES};
use crate::document::{DocumentError, Names};
use crate::domain::observers::{listed, true_goal, unexpected};
use crate::problem::{Goal, MAX_GOALS, Observer, Problem, StateNaming};
use crate::sensor::{Sensor, SensorBuilder};
use crate::task::{Fact, Task, TaskBuilder};

/// What joins the packages of a goal in its name.
const AND: &str = "+";
/// The action that brings the truck to the delivery area.
const DELIVER: &str = "deliver";

/// A package and where it lies.
struct Package<'a> {
    name: &'a str,
    factory: usize,
    path: String,
}

impl Delivery {
    /// Checks that everything fits together and makes the problem.
    ///
    /// # Errors
    ///
    /// [`DocumentError`] with the place of what does not fit.
    pub fn problem(&self) -> Result<Problem, DocumentError> {
        let packages = self.packages()?;
        let sets = self.goal_sets(&packages)?;
        let mut builder = TaskBuilder::default();
        let facts = self.facts(&mut builder, &packages);
        self.operators(&mut builder, &packages, &facts);
        let named = |set: &Vec<usize>| {
            set.iter().map(|&package| packages[package].name).collect::<Vec<_>>().join(AND)
        };
        let names: Vec<String> = sets.iter().map(named).collect();
        let name_refs: Vec<&str> = names.iter().map(String::as_str).collect();
        let true_goal = true_goal(&name_refs, &self.canonical_goal(&packages))?;
        let goals: Vec<Goal> = sets
            .iter()
            .zip(&names)
            .map(|(set, name)| {
                let loaded = set.iter().map(|&package| facts.loaded[package]);
                let condition = loaded.chain([facts.delivery_area]).collect();
                Goal { name: name.clone(), condition }
            })
            .collect();
        let initial: Vec<Fact> =
            facts.at_factory.iter().copied().chain([facts.room[0], facts.yard]).collect();
        let task = builder
            .build(&initial, &goals[true_goal].condition)
            .map_err(|error| DocumentError::invalid("document", error.to_string(), "a task"))?;
        let mut observers = Vec::new();
        for (role, observer) in self.observers.iter() {
            let path = format!("observers.{}", role.name());
            observers.push(Observer {
                name: role.name().to_owned(),
                role,
                sensor: Arc::new(self.sensor(&task, observer, &packages, &path)?),
                initial_belief: vec![task.initial_state().clone()].into(),
            });
        }
        Problem::new(task, goals, true_goal, observers, StateNaming::Facts)
            .map_err(|error| unexpected(&error))
    }

    /// All packages, each with a name of its own.
    fn packages(&self) -> Result<Vec<Package<'_>>, DocumentError> {
        let mut packages: Vec<Package<'_>> = Vec::new();
        let mut names = Names::default();
        let mut take = |name, path: &str| names.add(name, "the name", || path.to_owned());
        for (index, factory) in self.factories.iter().enumerate() {
            take(&factory.name, &format!("factories[{index}].name"))?;
            for (position, name) in factory.packages.iter().enumerate() {
                let path = format!("factories[{index}].packages[{position}]");
                take(name, &path)?;
                if name.contains(AND) {
                    let expected = format!("a name without {AND}");
                    return Err(DocumentError::invalid(path, format!("{name:?}"), expected));
                }
                packages.push(Package { name, factory: index, path });
            }
            if packages.len() > MAX_PACKAGES {
                let found = format!("{} packages", packages.len());
                let expected = format!("at most {MAX_PACKAGES}");
                return Err(DocumentError::invalid("factories", found, expected));
            }
        }
        if self.deliver == 0 || self.deliver as usize > packages.len() {
            let expected = format!("a whole number from 1 to {}", packages.len());
            return Err(DocumentError::invalid("deliver", self.deliver.to_string(), expected));
        }
        Ok(packages)
    }

    /// The sets of `deliver` packages, in lexicographic order.
    fn goal_sets(&self, packages: &[Package<'_>]) -> Result<Vec<Vec<usize>>, DocumentError> {
        let size = self.deliver as usize;
        let mut count = 1_usize;
        // As many ways to leave behind as to take along; the smaller number only ever grows.
        for taken in 0..size.min(packages.len() - size) {
            count = count.saturating_mul(packages.len() - taken) / (taken + 1);
            if count > MAX_GOALS * packages.len() {
                break;
            }
        }
        if !(2..=MAX_GOALS).contains(&count) {
            let found = format!("{size} of {} packages", packages.len());
            let expected = format!("between 2 and {MAX_GOALS} possible sets, which are the goals");
            return Err(DocumentError::invalid("deliver", found, expected));
        }
        let mut set: Vec<usize> = (0..size).collect();
        let mut sets = vec![set.clone()];
        // The last place that can still move up does; those behind it follow closely.
        while let Some(place) = (0..size).rev().find(|&i| set[i] < packages.len() - size + i) {
            set[place] += 1;
            for next in place + 1..size {
                set[next] = set[next - 1] + 1;
            }
            sets.push(set.clone());
        }
        Ok(sets)
    }

    /// The name of the true goal with its packages in the order of the document.
    fn canonical_goal(&self, packages: &[Package<'_>]) -> String {
        let place = |part: &str| packages.iter().position(|package| package.name == part);
        // Few: put in one by one, they need no copy of the sort in the wasm file.
        let mut parts: Vec<&str> = Vec::new();
        for part in self.true_goal.split(AND) {
            let at = parts.partition_point(|before| place(before) <= place(part));
            parts.insert(at, part);
        }
        parts.join(AND)
    }

    fn facts(&self, builder: &mut TaskBuilder, packages: &[Package<'_>]) -> Facts {
        let yard = builder.fact("truck in the yard");
        let at: Vec<Fact> = self
            .factories
            .iter()
            .map(|factory| builder.fact(format!("truck at {}", factory.name)))
            .collect();
        let delivery_area = builder.fact("truck at the delivery area");
        builder.exclusive([vec![yard], at.clone(), vec![delivery_area]].concat());
        let room: Vec<Fact> =
            (0..=self.deliver).map(|count| builder.fact(format!("{count} loaded"))).collect();
        builder.exclusive(room.clone());
        let (mut at_factory, mut loaded) = (Vec::new(), Vec::new());
        for package in packages {
            let factory = &self.factories[package.factory].name;
            let here = builder.fact(format!("{} at {factory}", package.name));
            let there = builder.fact(format!("{} in the truck", package.name));
            builder.exclusive(vec![here, there]);
            at_factory.push(here);
            loaded.push(there);
        }
        Facts { yard, at, delivery_area, room, at_factory, loaded }
    }

    /// Loading takes the truck from wherever it is to the factory, as long as it has room.
    fn operators(&self, builder: &mut TaskBuilder, packages: &[Package<'_>], facts: &Facts) {
        for (index, package) in packages.iter().enumerate() {
            let (here, there) = (facts.at_factory[index], facts.loaded[index]);
            let factory = facts.at[package.factory];
            let action = format!("load {}", package.name);
            for room in facts.room.windows(2) {
                for &place in facts.at.iter().chain([&facts.yard]) {
                    let before = [place, here, room[0]];
                    builder.operator(&action, &before, &[factory, there, room[1]], &before);
                }
            }
        }
        let full = facts.room[self.deliver as usize];
        for &place in &facts.at {
            builder.operator(DELIVER, &[place, full], &[facts.delivery_area], &[place]);
        }
    }

    fn sensor(
        &self,
        task: &Task,
        observer: &DeliveryObserver,
        packages: &[Package<'_>],
        path: &str,
    ) -> Result<Sensor, DocumentError> {
        let load = |package: &Package<'_>| {
            let symbols = match &observer.sensor.load {
                LoadSymbols::Same(symbol) => return Ok(symbol),
                LoadSymbols::Each(symbols) => symbols,
            };
            let factory = &self.factories[package.factory].name;
            let of = |wanted: &str| symbols.iter().find(|(name, _)| name == wanted);
            of(package.name).or_else(|| of(factory)).map(|(_, symbol)| symbol).ok_or_else(|| {
                let found = format!("no symbol for {} ({})", package.name, package.path);
                let expected = format!("a symbol for {} or for {factory}", package.name);
                DocumentError::invalid(format!("{path}.sensor.load"), found, expected)
            })
        };
        if let LoadSymbols::Each(symbols) = &observer.sensor.load {
            let known: Vec<&str> = self
                .factories
                .iter()
                .map(|factory| factory.name.as_str())
                .chain(packages.iter().map(|package| package.name))
                .collect();
            if let Some((name, _)) = symbols.iter().find(|(name, _)| !known.contains(&&**name)) {
                let expected = format!("a factory or a package: {}", listed(&known));
                let path = format!("{path}.sensor.load");
                return Err(DocumentError::invalid(path, format!("{name:?}"), expected));
            }
        }
        let mut shapes = Names::default();
        if let LoadSymbols::Each(symbols) = &observer.sensor.load {
            for (name, symbol) in symbols {
                shapes.add_symbol(symbol, || format!("{path}.sensor.load.{name}"))?;
            }
        }
        shapes.add_symbol(&observer.sensor.deliver, || format!("{path}.sensor.deliver"))?;
        let mut builder = SensorBuilder::new(task);
        for (id, operator) in task.operator_ids() {
            let name = task.action_name(operator.action);
            match packages.iter().find(|package| name == format!("load {}", package.name)) {
                Some(package) => builder.always(id, load(package)?),
                None => builder.always(id, &observer.sensor.deliver),
            }
        }
        builder
            .build(task)
            .map_err(|error| DocumentError::invalid(path, error.to_string(), "a symbol"))
    }
}

/// The facts of a delivery.
struct Facts {
    yard: Fact,
    at: Vec<Fact>,
    delivery_area: Fact,
    room: Vec<Fact>,
    at_factory: Vec<Fact>,
    loaded: Vec<Fact>,
}
