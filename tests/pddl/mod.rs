//! The PDDL reader and the grounder.

// Texts put together piece by piece, and long tables of mistakes: shorter code for it reads worse.
#![allow(clippy::format_collect, clippy::format_push_string, clippy::too_many_lines)]

mod adl;
mod blow_up;
mod exclusive;
mod fuzz;
mod grounding;
pub mod ipc;
mod manners;
mod oracle;
mod pyperplan;
mod reading;

use mo_copp::pddl::{ExtraInputs, Grounded, ground, read_domain, read_task};

/// Reads and grounds two texts.
pub fn grounded(domain: &str, task: &str) -> Grounded {
    let domain = read_domain(domain).unwrap();
    let task = read_task(&domain, task).unwrap();
    ground(&domain, &task, &ExtraInputs::default()).unwrap()
}

/// Blocksworld with four actions, in our own words.
pub const BLOCKS: &str = "
; towers of blocks, moved by one hand
(define (domain towers)
  (:requirements :strips :typing)
  (:types block)
  (:predicates (on ?upper ?lower - block) (on-table ?b - block) (clear ?b - block)
               (empty) (held ?b - block))
  (:action grab :parameters (?b - block)
    :precondition (and (clear ?b) (on-table ?b) (empty))
    :effect (and (held ?b) (not (clear ?b)) (not (on-table ?b)) (not (empty))))
  (:action release :parameters (?b - block)
    :precondition (held ?b)
    :effect (and (not (held ?b)) (clear ?b) (on-table ?b) (empty)))
  (:action put :parameters (?b ?below - block)
    :precondition (and (held ?b) (clear ?below))
    :effect (and (not (held ?b)) (not (clear ?below)) (clear ?b) (on ?b ?below) (empty)))
  (:action lift :parameters (?b ?below - block)
    :precondition (and (on ?b ?below) (clear ?b) (empty))
    :effect (and (held ?b) (clear ?below) (not (on ?b ?below)) (not (clear ?b)) (not (empty)))))";

/// Three blocks on the table to be stacked.
pub const THREE_BLOCKS: &str = "
(define (problem three) (:domain towers)
  (:objects a b c - block)
  (:init (on-table a) (on-table b) (on-table c) (clear a) (clear b) (clear c) (empty))
  (:goal (and (on a b) (on b c))))";
