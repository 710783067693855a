//! Facts that exclude each other, by domain.

use mo_copp::task::Fact;

use super::grounded;

/// The groups of more than one fact, and how many facts are in none.
fn groups(domain: &str, task: &str) -> (Vec<Vec<String>>, usize) {
    let grounded = grounded(domain, task);
    let task = &grounded.task;
    let names = |group: Vec<Fact>| {
        group.into_iter().map(|fact| task.fact_name(fact).to_owned()).collect::<Vec<_>>()
    };
    let groups: Vec<Vec<String>> = task.exclusive_groups().into_iter().map(names).collect();
    let alone = groups.iter().filter(|group| group.len() == 1).count();
    (groups.into_iter().filter(|group| group.len() > 1).collect(), alone)
}

/// Parcels in vans, on foot of one predicate for where a van and a parcel are.
const PARCELS: &str = "(define (domain parcels) (:types van parcel - thing place)
  (:predicates (at ?t - thing ?p - place) (in ?p - parcel ?v - van) (parked ?v - van))
  (:action load :parameters (?p - parcel ?v - van ?x - place)
   :precondition (and (at ?p ?x) (at ?v ?x)) :effect (and (not (at ?p ?x)) (in ?p ?v)))
  (:action unload :parameters (?p - parcel ?v - van ?x - place)
   :precondition (and (in ?p ?v) (at ?v ?x)) :effect (and (not (in ?p ?v)) (at ?p ?x)))
  (:action drive :parameters (?v - van ?x ?y - place)
   :precondition (and (at ?v ?x)) :effect (and (not (at ?v ?x)) (at ?v ?y) (not (parked ?v))))
  (:action park :parameters (?v - van) :effect (parked ?v)))";

const PARCEL_TASK: &str = "(define (problem p) (:domain parcels)
  (:objects v - van p - parcel x y - place) (:init (at v x) (at p y)) (:goal (at p x)))";

#[test]
fn a_parcel_is_in_one_place_or_one_van() {
    let (groups, alone) = groups(PARCELS, PARCEL_TASK);
    let expected = [vec!["(at p x)", "(at p y)", "(in p v)"], vec!["(at v x)", "(at v y)"]];
    assert_eq!(groups, expected);
    assert_eq!(alone, 1);
}

#[test]
fn what_begins_in_two_places_is_in_no_group() {
    let task = PARCEL_TASK.replace("(at v x)", "(at v x) (at v y)");
    let (groups, alone) = groups(PARCELS, &task);
    assert_eq!(groups, [["(at p x)", "(at p y)", "(in p v)"]]);
    assert_eq!(alone, 3);
}

#[test]
fn an_action_that_copies_keeps_none() {
    let domain = PARCELS.replace(
        "(:action park",
        "(:action copy :parameters (?p - parcel ?x ?y - place)
       :precondition (at ?p ?x) :effect (at ?p ?y)) (:action park",
    );
    // Candidates are of predicates, whatever the types: that a van is in one place goes unseen too.
    let (groups, alone) = groups(&domain, PARCEL_TASK);
    assert_eq!((groups, alone), (Vec::new(), 6));
}

#[test]
fn two_parameters_that_may_be_the_same() {
    // Both parcels change places: with one parcel for both, it would be in two.
    let domain = PARCELS.replace(
        "(:action park",
        "(:action swap :parameters (?p ?q - parcel ?x ?y - place)
       :precondition (and (at ?p ?x) (at ?q ?y))
       :effect (and (not (at ?p ?x)) (not (at ?q ?y)) (at ?p ?y) (at ?q ?x))) (:action park",
    );
    // With p = q the parcel must be in both places: never applicable, and left out.
    let found = grounded(&domain, PARCEL_TASK);
    let names: Vec<&str> = (0..found.task.action_count())
        .filter_map(|n| found.task.operators().get(n))
        .map(|operator| found.task.action_name(operator.action))
        .collect();
    assert!(names.contains(&"(swap p p x x)") && !names.contains(&"(swap p p x y)"), "{names:?}");
    assert_eq!(groups(&domain, PARCEL_TASK).0.len(), 2);
    // Where the second parcel's place is not asked for, it is another matter.
    let domain = domain.replace("(and (at ?p ?x) (at ?q ?y))", "(at ?p ?x)");
    assert!(groups(&domain, PARCEL_TASK).0.is_empty());
}
