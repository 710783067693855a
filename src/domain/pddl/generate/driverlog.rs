//! Draws random Driverlog problems.

use super::{Draft, MAX_BELIEF, below, distinct, halves, numbered, other_than};
use crate::domain::generate::{Drawn, GenerateError, draw, in_range, random};
use crate::domain::pddl::Pddl;

/// The size of a random Driverlog problem. The default is that of the competition's smallest task,
/// whose goal has the paper's 4 facts: 3 places, 2 drivers, 2 trucks, 2 packages; and 5 candidate
/// goals, each for all packages and two of the drivers and trucks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DriverlogShape {
    /// Places, with a road between any two and a footpath from each to the next.
    pub places: u32,
    /// Drivers.
    pub drivers: u32,
    /// Trucks.
    pub trucks: u32,
    /// Packages, named p1, p2, p3, ….
    pub packages: u32,
    /// Candidate goals.
    pub goals: u32,
    /// States in each initial belief, at most: 1 is the initial state alone. Of more, each observer
    /// has from 1 to this many drawn for itself.
    pub belief: u32,
}

impl Default for DriverlogShape {
    fn default() -> Self {
        Self { places: 3, drivers: 2, trucks: 2, packages: 2, goals: 5, belief: 1 }
    }
}

/// Drivers and trucks in a goal.
const OTHERS: usize = 2;

impl DriverlogShape {
    /// Draws places for drivers, trucks and packages, and goals that bring some of them elsewhere.
    ///
    /// # Errors
    ///
    /// The numbers make no sense together.
    pub fn generate(self, seed: u64) -> Result<Drawn<Pddl>, GenerateError> {
        in_range("places", self.places, 2..=64)?;
        in_range("drivers", self.drivers, 1..=64)?;
        in_range("trucks", self.trucks, 1..=64)?;
        in_range("packages", self.packages, 1..=64)?;
        // A goal is fixed by which drivers and trucks are in it and where all in it go.
        let pairs = (self.drivers + self.trucks) * (self.drivers + self.trucks - 1) / 2;
        let ways = (self.places - 1).saturating_pow(OTHERS as u32 + self.packages);
        in_range("goals", self.goals, 2..=ways.saturating_mul(pairs).min(1024))?;
        in_range("belief", self.belief, 1..=MAX_BELIEF)?;
        let mut random = random(seed);
        let places = numbered("s", self.places);
        let paths: Vec<String> =
            (1..self.places).map(|place| format!("f{place}-{}", place + 1)).collect();
        let (drivers, trucks) = (numbered("driver", self.drivers), numbered("truck", self.trucks));
        let packages = numbered("p", self.packages);
        let others = [drivers.clone(), trucks.clone()].concat();
        let movable = [others.clone(), packages.clone()].concat();
        let start: Vec<usize> = movable.iter().map(|_| below(&mut random, places.len())).collect();
        let goal = || {
            let mut chosen = draw(&mut random, &mut (0..others.len()).collect(), OTHERS);
            chosen.sort_unstable();
            chosen.extend(others.len()..movable.len());
            let elsewhere =
                |thing: usize| (thing, other_than(&mut random, places.len(), start[thing]));
            chosen.into_iter().map(elsewhere).collect::<Vec<_>>()
        };
        let goals = distinct(self.goals, Vec::new(), goal);
        let at = |thing: &str, place: usize| format!("(at {thing} {})", places[place]);
        let roads = places.iter().flat_map(|from| {
            let others = places.iter().filter(move |to| *to != from);
            others.map(move |to| format!("(road {from} {to})"))
        });
        let both = |path: &str, place: &str| format!("(path {path} {place}) (path {place} {path})");
        let walks = paths
            .iter()
            .zip(places.windows(2))
            .flat_map(|(path, ends)| ends.iter().map(move |place| both(path, place)));
        let here = movable.iter().zip(&start).map(|(name, &place)| at(name, place));
        let empty = trucks.iter().map(|truck| format!("(empty {truck})"));
        let fact = |&(thing, place): &(usize, usize)| at(&movable[thing], place);
        let document = Draft {
            domain: "driverlog",
            text: include_str!("driverlog.pddl"),
            seed,
            objects: vec![
                format!("{} {} - place", places.join(" "), paths.join(" ")),
                format!("{} - driver", drivers.join(" ")),
                format!("{} - truck", trucks.join(" ")),
                format!("{} - package", packages.join(" ")),
            ],
            init: roads.chain(walks).chain(here).chain(empty).collect(),
            goals: goals.iter().map(|goal| goal.iter().map(fact).collect()).collect(),
            groups: [halves(&drivers), halves(&trucks), halves(&packages)].concat(),
        };
        Ok(Drawn { document: document.document(self.belief, &mut random), redraws: 0 })
    }
}
