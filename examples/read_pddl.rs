//! Reads PDDL: a domain and a task become a ground task, which the baseline planner solves.
//!
//! `cargo run --example read_pddl`

use std::error::Error;
use std::sync::Arc;

use mo_copp::limits::Limits;
use mo_copp::pddl::{ExtraInputs, ground, read_domain, read_task};
use mo_copp::solver::ClassicalRun;

const DOMAIN: &str = "
(define (domain ferry)
  (:requirements :strips :typing)
  (:types shore car)
  (:predicates (ferry-at ?s - shore) (car-at ?c - car ?s - shore) (aboard ?c - car) (empty))
  (:action sail
    :parameters (?from ?to - shore)
    :precondition (ferry-at ?from)
    :effect (and (ferry-at ?to) (not (ferry-at ?from))))
  (:action board
    :parameters (?c - car ?s - shore)
    :precondition (and (ferry-at ?s) (car-at ?c ?s) (empty))
    :effect (and (aboard ?c) (not (car-at ?c ?s)) (not (empty))))
  (:action land
    :parameters (?c - car ?s - shore)
    :precondition (and (ferry-at ?s) (aboard ?c))
    :effect (and (car-at ?c ?s) (empty) (not (aboard ?c)))))";

const TASK: &str = "
(define (problem two-cars)
  (:domain ferry)
  (:objects west east - shore red blue - car)
  (:init (ferry-at west) (empty) (car-at red west) (car-at blue west))
  (:goal (and (car-at red east) (car-at blue east))))";

fn main() -> Result<(), Box<dyn Error>> {
    let domain = read_domain(DOMAIN)?;
    let definition = read_task(&domain, TASK)?;
    let task = Arc::new(ground(&domain, &definition, &ExtraInputs::default())?.task);
    println!("{} facts, {} operators", task.fact_count(), task.operators().len());

    let mut run = ClassicalRun::new(Arc::clone(&task), Limits::default());
    while !run.advance(1000) {
        eprintln!("{} expansions", run.stats().expansions);
    }
    let outcome = run.outcome()?;
    let plan = outcome.plan.ok_or("no plan")?;
    for name in plan.names(&task) {
        println!("{name}");
    }
    println!("{}: {} actions", outcome.status.name(), plan.len());
    Ok(())
}
