//! Random deliveries, and what they mean as tables, worked out from their description.

use mo_copp::domain::delivery::{DeliveryObserver, DeliverySymbols, Factory, LoadSymbols};
use mo_copp::domain::{Delivery, Observers};
use mo_copp::problem::Role;

use super::dice::Dice;
use super::table::{Table, Watcher, symbol};

/// A few factories and packages; a sensor knows nothing, the factory, or the package.
pub fn random(dice: &mut Dice) -> Delivery {
    let mut factories = Vec::new();
    let mut packages = Vec::new();
    let mut left = dice.between(2, 4);
    for (name, small) in [("A", "a"), ("B", "b"), ("C", "c")] {
        let count = if name == "C" { left } else { dice.between(usize::from(name == "A"), left) };
        left -= count;
        let here: Vec<String> = (1..=count).map(|number| format!("{small}{number}")).collect();
        packages.extend(here.iter().cloned());
        factories.push(Factory { name: name.to_owned(), packages: here });
    }
    let deliver = dice.between(1, packages.len() - 1);
    let mut goal = packages.clone();
    while goal.len() > deliver {
        goal.swap_remove(dice.below(goal.len()));
    }
    let mut observer = || {
        let load = match dice.below(3) {
            0 => LoadSymbols::Same("package".to_owned()),
            1 => LoadSymbols::Each(
                factories.iter().map(|f| (f.name.clone(), format!("from {}", f.name))).collect(),
            ),
            _ => LoadSymbols::Each(
                packages
                    .iter()
                    .map(|package| (package.clone(), format!("shape {}", dice.below(2))))
                    .collect(),
            ),
        };
        DeliveryObserver { sensor: DeliverySymbols { load, deliver: "delivery".to_owned() } }
    };
    let observers = Observers { adversarial: observer(), cooperative: observer() };
    Delivery { factories, deliver: deliver as u32, true_goal: goal.join("+"), observers }
}

/// Where the truck is (0 the yard, then the factories, then the delivery area) and what it has.
type Truck = (usize, Vec<bool>);

fn count(set: &[bool]) -> usize {
    set.iter().filter(|&&taken| taken).count()
}

/// Every set of so many of the packages, in the order of their numbers.
fn subsets(packages: usize, size: usize) -> Vec<Vec<bool>> {
    let mut sets: Vec<Vec<bool>> = vec![vec![]];
    for _ in 0..packages {
        let mut longer = Vec::new();
        for set in &sets {
            for taken in [true, false] {
                longer.push([set.as_slice(), &[taken]].concat());
            }
        }
        sets = longer;
    }
    sets.retain(|set| count(set) == size);
    sets
}

/// States are what trucks and packages can be in, labelled by their facts.
pub fn table(delivery: &Delivery) -> Table {
    let factories = &delivery.factories;
    let mut packages = Vec::new();
    for (number, factory) in factories.iter().enumerate() {
        packages.extend(factory.packages.iter().map(|name| (name.clone(), number)));
    }
    let area = factories.len() + 1;
    let room = delivery.deliver as usize;
    let go = |(place, loaded): &Truck, action: usize| {
        if action == packages.len() {
            let full = count(loaded) == room && *place != 0 && *place != area;
            return full.then(|| (area, loaded.clone()));
        }
        let possible = *place != area && !loaded[action] && count(loaded) < room;
        possible.then(|| {
            let mut after = loaded.clone();
            after[action] = true;
            (packages[action].1 + 1, after)
        })
    };
    let mut trucks: Vec<Truck> = vec![(0, vec![false; packages.len()])];
    let mut next = Vec::new();
    while next.len() < trucks.len() {
        let here = trucks[next.len()].clone();
        let row = (0..=packages.len()).map(|action| {
            let after = go(&here, action)?;
            Some(trucks.iter().position(|known| *known == after).unwrap_or_else(|| {
                trucks.push(after);
                trucks.len() - 1
            }))
        });
        let row = row.collect();
        next.push(row);
    }
    let label = |(place, loaded): &Truck| {
        let mut facts = vec![match *place {
            0 => "truck in the yard".to_owned(),
            place if place == area => "truck at the delivery area".to_owned(),
            place => format!("truck at {}", factories[place - 1].name),
        }];
        facts.push(format!("{} loaded", count(loaded)));
        for ((name, factory), loaded) in packages.iter().zip(loaded) {
            let place = format!("at {}", factories[*factory].name);
            let place = if *loaded { "in the truck" } else { &place };
            facts.push(format!("{name} {place}"));
        }
        format!("{{{}}}", facts.join(", "))
    };
    let wanted = subsets(packages.len(), room);
    let named = |set: &Vec<bool>| {
        let taken = packages.iter().zip(set).filter(|(_, taken)| **taken);
        taken.map(|((name, _), _)| name.as_str()).collect::<Vec<_>>().join("+")
    };
    let goal_names: Vec<String> = wanted.iter().map(named).collect();
    let goal = |set: &Vec<bool>| {
        let of_goal = |(_, truck): &(usize, &Truck)| truck.0 == area && truck.1 == *set;
        let states = trucks.iter().enumerate().filter(of_goal);
        states.map(|(state, _)| 1 << state).sum()
    };
    let mut truth: Vec<&str> = delivery.true_goal.split('+').collect();
    truth.sort_by_key(|part| packages.iter().position(|(name, _)| name == part));
    let truth = truth.join("+");
    let watcher = |role, observer: &DeliveryObserver| {
        let mut symbols = Vec::new();
        let mut sensor = Vec::new();
        for (package, factory) in &packages {
            let name = match &observer.sensor.load {
                LoadSymbols::Same(name) => name,
                LoadSymbols::Each(names) => {
                    let of = |wanted: &str| names.iter().find(|(name, _)| name == wanted);
                    &of(package).or_else(|| of(&factories[*factory].name)).unwrap().1
                }
            };
            sensor.push(vec![symbol(&mut symbols, name); trucks.len()]);
        }
        sensor.push(vec![symbol(&mut symbols, &observer.sensor.deliver); trucks.len()]);
        Watcher { role, belief: 1, symbols, sensor }
    };
    let load = |(name, _): &(String, usize)| format!("load {name}");
    Table {
        states: trucks.iter().map(label).collect(),
        actions: packages.iter().map(load).chain(["deliver".to_owned()]).collect(),
        start: 0,
        goals: wanted.iter().map(goal).collect(),
        true_goal: goal_names.iter().position(|name| *name == truth).unwrap(),
        goal_names,
        watchers: vec![
            watcher(Role::Adversarial, &delivery.observers.adversarial),
            watcher(Role::Cooperative, &delivery.observers.cooperative),
        ],
        next,
    }
}
