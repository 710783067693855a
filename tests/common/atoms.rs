//! Blocksworld, Logistics and Driverlog as plain tables, worked out from what their actions mean:
//! states are sets of atoms, atoms are texts. Shares nothing with the reader and the grounder but
//! the lists of objects and of atoms in a document, which are taken apart here by splitting texts.

use std::collections::BTreeSet;
use std::slice::from_ref;

use mo_copp::domain::Pddl;
use mo_copp::domain::pddl::{PddlBelief, PddlObserver, PddlSensor, PddlState};
use mo_copp::problem::Role;

use super::dice::Dice;
use super::table::{Table, Watcher, symbol};

/// The atoms that hold.
type Atoms = BTreeSet<String>;

/// A ground action.
struct Act {
    name: &'static str,
    arguments: Vec<String>,
    before: Vec<String>,
    add: Vec<String>,
    delete: Vec<String>,
}

impl Act {
    fn text(&self) -> String {
        format!("({} {})", self.name, self.arguments.join(" "))
    }

    fn successor(&self, state: &Atoms) -> Option<Atoms> {
        if !self.before.iter().all(|atom| state.contains(atom)) {
            return None;
        }
        let mut after = state.clone();
        after.retain(|atom| !self.delete.contains(atom));
        after.extend(self.add.iter().cloned());
        Some(after)
    }
}

/// The atoms of a text, those inside of an `and` or a section too.
fn atoms(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for piece in text.split('(').skip(1) {
        if let Some((inner, _)) = piece.split_once(')') {
            found.push(format!("({inner})"));
        }
    }
    found
}

/// The objects of a problem with their types, in order.
fn objects(problem: &str) -> Vec<(String, String)> {
    let section = problem.split("(:objects").nth(1).unwrap().split(')').next().unwrap();
    let mut found = Vec::new();
    for line in section.lines().filter(|line| !line.trim().is_empty()) {
        let (names, kind) = line.split_once(" - ").unwrap();
        let typed = names.split_whitespace().map(|name| (name.to_owned(), kind.trim().to_owned()));
        found.extend(typed);
    }
    found
}

/// Writes `at {} {}` with arguments as an atom.
fn atom(words: &[&str]) -> String {
    format!("({})", words.join(" "))
}

struct Things(Vec<(String, String)>);

impl Things {
    fn of(&self, kind: &str) -> Vec<&str> {
        let of = self
            .0
            .iter()
            .filter(|(_, other)| other == kind || (kind == "place" && other == "airport"));
        of.map(|(name, _)| name.as_str()).collect()
    }
}

fn act(name: &'static str, arguments: &[&str], changes: [&[String]; 3]) -> Act {
    let [before, add, delete] = changes.map(<[String]>::to_vec);
    let arguments = arguments.iter().map(|&argument| argument.to_owned()).collect();
    Act { name, arguments, before, add, delete }
}

fn blocksworld(things: &Things) -> Vec<Act> {
    let blocks = things.of("block");
    let hand = "(handempty)".to_owned();
    let mut acts = Vec::new();
    for &x in &blocks {
        let [table, clear, held] =
            ["ontable", "clear", "holding"].map(|predicate| atom(&[predicate, x]));
        let here = [hand.clone(), clear.clone(), table];
        acts.push(act("pick-up", &[x], [&here, from_ref(&held), &here]));
        acts.push(act("put-down", &[x], [from_ref(&held), &here, from_ref(&held)]));
        for &y in blocks.iter().filter(|&&y| y != x) {
            let on = [hand.clone(), clear.clone(), atom(&["on", x, y])];
            let off = [held.clone(), atom(&["clear", y])];
            acts.push(act("stack", &[x, y], [&off, &on, &off]));
            acts.push(act("unstack", &[x, y], [&on, &off, &on]));
        }
    }
    acts
}

/// Loading and unloading, for both domains with vehicles.
fn loading(
    acts: &mut Vec<Act>,
    [load, unload]: [&'static str; 2],
    [package, vehicle, place]: [&str; 3],
) {
    let there = atom(&["at", vehicle, place]);
    let (lies, inside) = (atom(&["at", package, place]), atom(&["in", package, vehicle]));
    let names = [package, vehicle, place];
    let before = [there.clone(), lies.clone()];
    acts.push(act(load, &names, [&before, from_ref(&inside), from_ref(&lies)]));
    let before = [there, inside.clone()];
    acts.push(act(unload, &names, [&before, &[lies], &[inside]]));
}

fn moving(name: &'static str, arguments: &[&str], more: &[String]) -> Act {
    let [who, from, to] = [arguments[0], arguments[1], arguments[2]];
    let here = atom(&["at", who, from]);
    let before = [more, from_ref(&here)].concat();
    act(name, arguments, [&before, &[atom(&["at", who, to])], &[here]])
}

fn logistics(things: &Things) -> Vec<Act> {
    let mut acts = Vec::new();
    for (kind, fields, names) in [
        ("truck", "place", ["load-truck", "unload-truck"]),
        ("airplane", "airport", ["load-airplane", "unload-airplane"]),
    ] {
        for &vehicle in &things.of(kind) {
            for &place in &things.of(fields) {
                for &package in &things.of("package") {
                    loading(&mut acts, names, [package, vehicle, place]);
                }
                for &to in things.of(fields).iter().filter(|&&to| to != place) {
                    let (name, way) = if kind == "truck" {
                        ("drive-truck", atom(&["road", place, to]))
                    } else {
                        ("fly-airplane", atom(&["route", place, to]))
                    };
                    acts.push(moving(name, &[vehicle, place, to], &[way]));
                }
            }
        }
    }
    acts
}

fn driverlog(things: &Things) -> Vec<Act> {
    let mut acts = Vec::new();
    let places = things.of("place");
    for &place in &places {
        for &truck in &things.of("truck") {
            for &package in &things.of("package") {
                loading(&mut acts, ["load-truck", "unload-truck"], [package, truck, place]);
            }
            for &driver in &things.of("driver") {
                let there = atom(&["at", truck, place]);
                let afoot = [atom(&["at", driver, place]), atom(&["empty", truck])];
                let driving = [atom(&["driving", driver, truck])];
                let names = [driver, truck, place];
                let before = [afoot.as_slice(), from_ref(&there)].concat();
                acts.push(act("board-truck", &names, [&before, &driving, &afoot]));
                let before = [driving.as_slice(), &[there]].concat();
                acts.push(act("leave-truck", &names, [&before, &afoot, &driving]));
                for &to in &places {
                    let more = [driving[0].clone(), atom(&["road", place, to])];
                    acts.push(moving("drive-truck", &[truck, place, to, driver], &more));
                }
            }
        }
        for &driver in &things.of("driver") {
            for &to in &places {
                acts.push(moving("walk", &[driver, place, to], &[atom(&["path", place, to])]));
            }
        }
    }
    acts
}

/// Predicates in the order of the domains, which is the order in which states list their atoms.
const PREDICATES: [&str; 10] =
    ["on", "ontable", "clear", "holding", "handempty", "at", "in", "driving", "empty", "road"];

/// How a state prints: the atoms that differ between states, by predicate and objects.
fn label(things: &Things, state: &Atoms, changing: &Atoms) -> String {
    let order = |atom: &&String| {
        let inner = atom.trim_matches(['(', ')']);
        let mut words = inner.split(' ');
        let predicate = words.next().unwrap();
        let predicate = PREDICATES.iter().position(|known| *known == predicate);
        let object = |word: &str| things.0.iter().position(|(name, _)| name == word);
        (predicate, words.map(object).collect::<Vec<_>>())
    };
    let mut shown: Vec<&String> = state.intersection(changing).collect();
    shown.sort_by_key(order);
    let shown: Vec<&str> = shown.into_iter().map(String::as_str).collect();
    format!("{{{}}}", shown.join(", "))
}

/// What an observer sees of an action.
fn seen(observer: &PddlObserver, act: &Act) -> String {
    let looks = |argument: &String| {
        let group = observer.groups.iter().find(|(_, members)| members.contains(argument));
        group.map_or_else(|| argument.clone(), |(name, _)| name.clone())
    };
    match &observer.sensor {
        PddlSensor::Template(template) if template == "{name}" => act.name.to_owned(),
        PddlSensor::Template(template) if template == "{name} {1}" => {
            format!("{} {}", act.name, looks(&act.arguments[0]))
        }
        PddlSensor::Template(template) if template == "{arguments}" => {
            act.arguments.iter().map(looks).collect::<Vec<_>>().join(" ")
        }
        other => panic!("{other:?}"),
    }
}

/// What a document of one of the three domains means.
pub fn table(document: &Pddl) -> Table {
    let problem = document.problem.as_str();
    let things = Things(objects(problem));
    let acts = match problem.split("(:domain ").nth(1).unwrap().split(')').next().unwrap() {
        "blocksworld" => blocksworld(&things),
        "logistics" => logistics(&things),
        "driverlog" => driverlog(&things),
        other => panic!("{other}"),
    };
    let start: Atoms = atoms(problem.split("(:init").nth(1).unwrap()).into_iter().collect();
    let believed = |observer: &PddlObserver| match &observer.initial_belief {
        None => vec![start.clone()],
        Some(PddlBelief::States(states)) => {
            let state = |state: &PddlState| match state {
                PddlState::Atoms(atoms) => atoms.iter().cloned().collect(),
                PddlState::Change { .. } => start.clone(),
            };
            states.iter().map(state).collect::<Vec<Atoms>>()
        }
        Some(other) => panic!("{other:?}"),
    };
    let observers: Vec<(Role, &PddlObserver)> = document.observers.iter().collect();
    let mut states = vec![start.clone()];
    for (_, observer) in &observers {
        for state in believed(observer) {
            if !states.contains(&state) {
                states.push(state);
            }
        }
    }
    let mut next = Vec::new();
    while next.len() < states.len() {
        let here = states[next.len()].clone();
        let row: Vec<Option<usize>> = acts
            .iter()
            .map(|act| {
                let after = act.successor(&here)?;
                Some(states.iter().position(|known| *known == after).unwrap_or_else(|| {
                    states.push(after);
                    states.len() - 1
                }))
            })
            .collect();
        next.push(row);
    }
    assert!(states.len() <= 128, "{} states", states.len());
    let everywhere = states.iter().cloned().reduce(|all, state| &all & &state).unwrap();
    let anywhere = states.iter().cloned().reduce(|all, state| &all | &state).unwrap();
    let changing = &anywhere - &everywhere;
    let position = |state: &Atoms| states.iter().position(|known| known == state).unwrap();
    let goal = |text: &str| {
        let wanted = atoms(text.strip_prefix("(and ").unwrap());
        let holds = |state: &Atoms| wanted.iter().all(|atom| state.contains(atom));
        states.iter().enumerate().filter(|(_, state)| holds(state)).map(|(s, _)| 1 << s).sum()
    };
    let watcher = |(role, observer): &(Role, &PddlObserver)| {
        let mut symbols = Vec::new();
        let row = |act| vec![symbol(&mut symbols, &seen(observer, act)); states.len()];
        let sensor = acts.iter().map(row).collect();
        let belief = believed(observer).iter().fold(0, |set, state| set | 1 << position(state));
        Watcher { role: *role, belief, symbols, sensor }
    };
    Table {
        states: states.iter().map(|state| label(&things, state, &changing)).collect(),
        actions: acts.iter().map(Act::text).collect(),
        start: 0,
        goals: document.goals.iter().map(|g| goal(&g.condition)).collect(),
        goal_names: document.goals.iter().map(|goal| goal.name.clone()).collect(),
        true_goal: document.goals.iter().position(|g| g.name == document.true_goal).unwrap(),
        watchers: observers.iter().map(watcher).collect(),
        next,
    }
}

/// Other sensors and initial beliefs of a few states.
pub fn change(dice: &mut Dice, document: &mut Pddl) {
    let all = objects(document.problem.as_str());
    let table = table(document);
    let fixed: Atoms = atoms(document.problem.as_str().split("(:init").nth(1).unwrap())
        .into_iter()
        .filter(|atom| ["(road", "(route", "(path"].iter().any(|way| atom.starts_with(way)))
        .collect();
    for number in 0..2 {
        let observers = &mut document.observers;
        let observer =
            if number == 0 { &mut observers.adversarial } else { &mut observers.cooperative };
        let sensor = dice.pick(&["{name}", "{name} {1}", "{arguments}"]);
        observer.sensor = PddlSensor::Template(sensor.to_owned());
        let mut members: Vec<String> = all.iter().map(|(name, _)| name.clone()).collect();
        members.retain(|_| dice.percent(50));
        observer.groups = Vec::new();
        if !members.is_empty() {
            let place = dice.below(members.len());
            let rest = members.split_off(place);
            for (name, group) in [("some", members), ("others", rest)] {
                if !group.is_empty() {
                    observer.groups.push((name.to_owned(), group));
                }
            }
        }
        if dice.percent(60) {
            let mut states = vec![PddlState::Change { add: Vec::new(), delete: Vec::new() }];
            for _ in 0..dice.between(1, 4) {
                let state = &table.states[dice.below(table.states.len())];
                let mut listed = atoms(state);
                if dice.percent(50) {
                    listed.extend(fixed.iter().cloned());
                }
                // What always holds is in no label.
                let start = atoms(document.problem.as_str().split("(:init").nth(1).unwrap());
                let always =
                    |atom: &&String| !table.states.iter().any(|label| label.contains(*atom));
                listed.extend(start.iter().filter(always).cloned());
                states.push(PddlState::Atoms(listed));
            }
            observer.initial_belief = Some(PddlBelief::States(states));
        }
    }
}
