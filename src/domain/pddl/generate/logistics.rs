//! Draws random Logistics problems.

use super::{Draft, MAX_BELIEF, below, distinct, halves, numbered, other_than};
use crate::domain::generate::{Drawn, GenerateError, draw, in_range, random};
use crate::domain::pddl::Pddl;

/// The size of a random Logistics problem. The default is that of the competition's smallest tasks,
/// whose goals have the paper's 4 facts: two cities with an airport, another place and a truck each,
/// one airplane, 6 packages; and 5 candidate goals, each for 4 of the packages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LogisticsShape {
    /// Cities, each with an airport, a truck and a place beside the airport.
    pub cities: u32,
    /// Airplanes.
    pub airplanes: u32,
    /// Packages, named p1, p2, p3, ….
    pub packages: u32,
    /// Facts of a goal.
    pub facts: u32,
    /// Candidate goals.
    pub goals: u32,
    /// States in each initial belief, at most: 1 is the initial state alone. Of more, each observer
    /// has from 1 to this many drawn for itself.
    pub belief: u32,
}

impl Default for LogisticsShape {
    fn default() -> Self {
        Self { cities: 2, airplanes: 1, packages: 6, facts: 4, goals: 5, belief: 1 }
    }
}

impl LogisticsShape {
    /// Draws places for vehicles and packages, and goals that bring packages elsewhere.
    ///
    /// # Errors
    ///
    /// The numbers make no sense together.
    pub fn generate(self, seed: u64) -> Result<Drawn<Pddl>, GenerateError> {
        in_range("cities", self.cities, 1..=64)?;
        in_range("airplanes", self.airplanes, 1..=64)?;
        in_range("packages", self.packages, 1..=64)?;
        in_range("facts", self.facts, 1..=self.packages)?;
        // A goal chooses packages and for each of them a place where it is not.
        let choices = (0..self.facts)
            .fold(1_u32, |ways, taken| ways.saturating_mul(self.packages - taken) / (taken + 1));
        let goals = (2 * self.cities - 1).saturating_pow(self.facts).saturating_mul(choices);
        in_range("goals", self.goals, 2..=goals.min(1024))?;
        in_range("belief", self.belief, 1..=MAX_BELIEF)?;
        let mut random = random(seed);
        let places: Vec<String> =
            (1..=self.cities).flat_map(|c| [format!("airport{c}"), format!("place{c}")]).collect();
        let (trucks, airplanes) =
            (numbered("truck", self.cities), numbered("plane", self.airplanes));
        let packages = numbered("p", self.packages);
        let at = |thing: &str, place: usize| format!("(at {thing} {})", places[place]);
        let truck = |(city, name): (usize, &String)| at(name, 2 * city + below(&mut random, 2));
        let truck_lines: Vec<String> = trucks.iter().enumerate().map(truck).collect();
        let cities = self.cities as usize;
        let plane = |name: &String| at(name, 2 * below(&mut random, cities));
        let airplane_lines: Vec<String> = airplanes.iter().map(plane).collect();
        let start: Vec<usize> = packages.iter().map(|_| below(&mut random, places.len())).collect();
        let goal = || {
            let mut chosen =
                draw(&mut random, &mut (0..packages.len()).collect(), self.facts as usize);
            chosen.sort_unstable();
            let elsewhere =
                |package: usize| (package, other_than(&mut random, places.len(), start[package]));
            chosen.into_iter().map(elsewhere).collect::<Vec<_>>()
        };
        let goals = distinct(self.goals, Vec::new(), goal);
        let roads = places.chunks(2).map(|city| {
            let [airport, place] = [&city[0], &city[1]];
            format!("(road {airport} {place}) (road {place} {airport})")
        });
        let airports: Vec<&String> = places.iter().step_by(2).collect();
        let routes = airports.iter().flat_map(|from| {
            let others = airports.iter().filter(move |to| *to != from);
            others.map(move |to| format!("(route {from} {to})"))
        });
        let here = packages.iter().zip(&start).map(|(name, &place)| at(name, place));
        let init = roads.chain(routes).chain(truck_lines).chain(airplane_lines).chain(here);
        let fact = |&(package, place): &(usize, usize)| at(&packages[package], place);
        let airport_names = places.iter().step_by(2).map(String::as_str).collect::<Vec<_>>();
        let place_names = places.iter().skip(1).step_by(2).map(String::as_str).collect::<Vec<_>>();
        let document = Draft {
            domain: "logistics",
            text: include_str!("logistics.pddl"),
            seed,
            objects: vec![
                format!("{} - airport", airport_names.join(" ")),
                format!("{} - place", place_names.join(" ")),
                format!("{} - truck", trucks.join(" ")),
                format!("{} - airplane", airplanes.join(" ")),
                format!("{} - package", packages.join(" ")),
            ],
            init: init.collect(),
            goals: goals.iter().map(|goal| goal.iter().map(fact).collect()).collect(),
            groups: [halves(&trucks), halves(&airplanes), halves(&packages)].concat(),
        };
        Ok(Drawn { document: document.document(self.belief, &mut random), redraws: 0 })
    }
}
