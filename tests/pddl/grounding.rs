//! Small tasks whose grounding was worked out by hand.

use mo_copp::pddl::{
    ExtraInputs, Grounded, ground, read_condition, read_domain, read_state, read_task,
};

use super::{BLOCKS, THREE_BLOCKS, grounded};

fn facts(grounded: &Grounded) -> Vec<&str> {
    grounded.task.facts().map(|fact| grounded.task.fact_name(fact)).collect()
}

fn actions(grounded: &Grounded) -> Vec<&str> {
    let of = |operator: &mo_copp::task::Operator| grounded.task.action_name(operator.action);
    grounded.task.operators().iter().map(of).collect()
}

#[test]
fn three_blocks() {
    let grounded = grounded(BLOCKS, THREE_BLOCKS);
    // Of the 3 · 3 atoms of `on` those of a block on itself can never hold, since nothing is held
    // and clear at once.
    let expected = [
        "(on a b)",
        "(on a c)",
        "(on b a)",
        "(on b c)",
        "(on c a)",
        "(on c b)",
        "(on-table a)",
        "(on-table b)",
        "(on-table c)",
        "(clear a)",
        "(clear b)",
        "(clear c)",
        "(empty)",
        "(held a)",
        "(held b)",
        "(held c)",
    ];
    assert_eq!(facts(&grounded), expected);
    // 3 to grab, 3 to release, 6 to put, 6 to lift.
    let actions = actions(&grounded);
    assert_eq!(actions.len(), 18);
    assert_eq!(actions[..4], ["(grab a)", "(grab b)", "(grab c)", "(release a)"]);
    assert!(actions.contains(&"(put a b)") && !actions.contains(&"(put a a)"));
    // Where a block is takes two bits or three, whether it is clear one, the hand one.
    assert_eq!(
        (grounded.task.exclusive_groups().len(), grounded.task.initial_state().words().len()),
        (7, 1)
    );
}

#[test]
fn what_never_changes_is_no_fact() {
    let domain = "(define (domain roads) (:predicates (at ?p) (road ?x ?y) (lamp) (closed ?x))
       (:action go :parameters (?x ?y) :precondition (and (at ?x) (road ?x ?y) (lamp) (not (closed ?y)))
        :effect (and (not (at ?x)) (at ?y) (lamp))))";
    let task = "(define (problem p) (:domain roads) (:objects a b c d e)
       (:init (at a) (road a b) (road b c) (road d e) (road c e) (closed e) (lamp))
       (:goal (and (at c) (lamp) (road a b) (not (closed a)))))";
    let grounded = grounded(domain, task);
    // d is never reached and e is closed; the lamp is lit for good.
    assert_eq!(facts(&grounded), ["(at a)", "(at b)", "(at c)"]);
    assert_eq!(actions(&grounded), ["(go a b)", "(go b c)"]);
    assert_eq!(grounded.goal.unwrap().len(), 1);
    assert_eq!(grounded.task.exclusive_groups().len(), 1);
}

#[test]
fn negation_gets_a_fact_where_it_is_asked_for() {
    let domain = "(define (domain lamps) (:predicates (lit ?x) (broken ?x))
       (:action on :parameters (?x) :precondition (and (not (lit ?x)) (not (broken ?x))) :effect (lit ?x))
       (:action off :parameters (?x) :precondition (lit ?x) :effect (not (lit ?x)))
       (:action kick :parameters (?x) :effect (broken ?x)))";
    let task = "(define (problem p) (:domain lamps) (:objects a b)
       (:init (broken b)) (:goal (and (lit a) (not (lit b)) (not (broken a)))))";
    let grounded = grounded(domain, task);
    // (lit b) can never hold, so that its negation needs no fact; (broken a) only comes.
    let expected = ["(lit a)", "(broken a)", "(not (lit a))", "(not (broken a))"];
    assert_eq!(facts(&grounded), expected);
    assert_eq!(actions(&grounded), ["(on a)", "(off a)", "(kick a)", "(kick b)"]);
    let start = grounded.task.facts_of(grounded.task.initial_state().words());
    let start: Vec<_> = start.into_iter().map(|fact| grounded.task.fact_name(fact)).collect();
    assert_eq!(start, ["(not (lit a))", "(not (broken a))"]);
}

#[test]
fn equality_binds_and_parts() {
    let domain = "(define (domain pairs) (:constants k) (:predicates (met ?x ?y) (here ?x))
       (:action same :parameters (?x ?y) :precondition (and (here ?x) (= ?x ?y)) :effect (met ?x ?y))
       (:action other :parameters (?x ?y) :precondition (and (here ?x) (here ?y) (not (= ?x ?y)))
        :effect (met ?x ?y))
       (:action fixed :parameters (?x ?y) :precondition (and (= k ?y) (= ?y ?x)) :effect (met ?y ?x))
       (:action never :parameters (?x) :precondition (not (= ?x ?x)) :effect (here k)))";
    let task = "(define (problem p) (:domain pairs) (:objects a b)
       (:init (here a) (here b)) (:goal (met a a)))";
    let grounded = grounded(domain, task);
    assert_eq!(
        actions(&grounded),
        ["(same a a)", "(same b b)", "(other a b)", "(other b a)", "(fixed k k)"]
    );
}

#[test]
fn a_type_wider_than_the_predicate_holds_for_the_objects_that_fit() {
    let domain = "(define (domain zoo) (:types cat dog - animal)
       (:predicates (purrs ?c - cat) (fed ?a - animal))
       (:action listen :parameters (?a - animal) :precondition (purrs ?a) :effect (fed ?a))
       (:action feed :parameters (?a - (either cat dog)) :effect (fed ?a)))";
    let task =
        "(define (problem p) (:domain zoo) (:objects tom - cat rex - dog x - (either cat dog))
       (:init (purrs tom) (purrs x)) (:goal (fed rex)))";
    let grounded = grounded(domain, task);
    assert_eq!(
        actions(&grounded),
        ["(listen tom)", "(listen x)", "(feed tom)", "(feed rex)", "(feed x)"]
    );
}

#[test]
fn goals_that_can_never_hold() {
    for goal in [
        "(on a a)",
        "(and (on a b) (on b b))",
        "(and (held a) (empty))",
        "(and (on a b) (on a c))",
        "(and (empty) (not (empty)))",
        "(= a b)",
    ] {
        let task = THREE_BLOCKS.replace("(and (on a b) (on b c))", goal);
        let grounded = grounded(BLOCKS, &task);
        assert_eq!(grounded.goal, None, "{goal}");
        let start = grounded.task.initial_state().words();
        assert!(!grounded.task.satisfies(start, grounded.task.goal()), "{goal}");
    }
    for goal in ["()", "(not (on a a))", "(and (= a a) (not (= a b)))"] {
        let task = THREE_BLOCKS.replace("(and (on a b) (on b c))", goal);
        assert_eq!(grounded(BLOCKS, &task).goal, Some(Vec::new()), "{goal}");
    }
}

#[test]
fn further_states_and_conditions() {
    let domain = "(define (domain roads) (:predicates (at ?p) (road ?x ?y))
       (:action go :parameters (?x ?y) :precondition (and (at ?x) (road ?x ?y))
        :effect (and (not (at ?x)) (at ?y))))";
    let task = "(define (problem p) (:domain roads) (:objects a b c d)
       (:init (at a) (road a b) (road c d)) (:goal (at b)))";
    let domain = read_domain(domain).unwrap();
    let task = read_task(&domain, task).unwrap();
    let alone = ground(&domain, &task, &ExtraInputs::default()).unwrap();
    assert_eq!(actions(&alone), ["(go a b)"]);
    let more = ExtraInputs {
        // In the second the road from a is not known to be there.
        states: vec![
            read_state(&domain, &task, "(at c) (road a b) (road c d)").unwrap(),
            read_state(&domain, &task, "(at a) (road c d)").unwrap(),
        ],
        conditions: vec![
            read_condition(&domain, &task, "(at d)").unwrap(),
            read_condition(&domain, &task, "(and (road c d) (not (at c)))").unwrap(),
            read_condition(&domain, &task, "(road d c)").unwrap(),
        ],
    };
    let all = ground(&domain, &task, &more).unwrap();
    // The last one stands for the road from d to c.
    let expected = ["(at a)", "(at b)", "(at c)", "(at d)", "(road a b)", "(not (at c))"];
    assert_eq!(facts(&all)[..6], expected);
    assert_eq!(all.never.map(|fact| facts(&all)[fact.index()]), facts(&all).get(6).copied());
    assert_eq!(actions(&all), ["(go a b)", "(go c d)"]);
    assert_eq!(all.task.exclusive_groups().len(), 4);
    let meanings: Vec<_> = all.conditions.iter().map(|c| c.as_ref().map(Vec::len)).collect();
    assert_eq!(meanings, [Some(1), Some(1), None]);
    let mut found = Vec::new();
    all.task.applicable(all.states[1].words(), &mut found);
    assert!(found.is_empty());
}

#[test]
fn no_parameters_and_nothing_to_do() {
    let domain = "(define (domain d) (:predicates (p) (q)) (:action a :effect (p)) (:action b :precondition (q)))";
    let grounded = grounded(domain, "(define (problem p) (:domain d) (:goal (p)))");
    assert_eq!((facts(&grounded), actions(&grounded)), (vec!["(p)"], vec!["(a)"]));
}

#[test]
fn limits_are_named() {
    let predicates = "(:predicates (p ?x ?y ?z))";
    let action = "(:action a :parameters (?x ?y ?z) :effect (p ?x ?y ?z))";
    let domain = read_domain(&format!("(define (domain d) {predicates} {action})")).unwrap();
    let objects: String = (0..150).map(|number| format!(" o{number}")).collect();
    let task =
        format!("(define (problem p) (:domain d) (:objects {objects}) (:goal (p o0 o0 o0)))");
    let task = read_task(&domain, &task).unwrap();
    let error = ground(&domain, &task, &ExtraInputs::default()).map(|_| ()).unwrap_err();
    assert_eq!(error.to_string(), "grounding limit reached: 1000000 operators");
    // Much to try and nothing to find.
    let many: String = (0..8).map(|number| format!(" ?x{number}")).collect();
    let chain: String = (0..7).map(|n| format!(" (p ?x{n} ?x{})", n + 1)).collect();
    let domain = format!(
        "(define (domain d) (:predicates (p ?x ?y) (q ?x ?y))
          (:action a :parameters ({many}) :precondition (and {chain} (q ?x7 ?x0)) :effect (q ?x0 ?x1)))"
    );
    let domain = read_domain(&domain).unwrap();
    let objects: String = (0..60).map(|number| format!(" o{number}")).collect();
    let pairs: String = (0..3600).map(|n| format!(" (p o{} o{})", n % 60, n / 60)).collect();
    let extra: String = (0..60).map(|n| format!(" (q o{n} o{n})")).collect();
    let task = format!(
        "(define (problem p) (:domain d) (:objects {objects}) (:init {pairs} {extra}) (:goal (q o0 o1)))"
    );
    let task = read_task(&domain, &task).unwrap();
    let error = ground(&domain, &task, &ExtraInputs::default()).map(|_| ()).unwrap_err();
    assert!(error.to_string().starts_with("grounding limit reached: "), "{error}");
}
