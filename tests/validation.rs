//! What the Rust API refuses, with the words it does it with: options, problems, tasks, sensors.

use std::sync::Arc;

use mo_copp::domain::Delivery;
use mo_copp::problem::Role::{self, Adversarial, Cooperative};
use mo_copp::problem::{Goal, Observer, Problem, StateNaming};
use mo_copp::sensor::SensorBuilder;
use mo_copp::solver::{Bounds, Horizon, Options, Run, Solver, Watched};
use mo_copp::task::{OperatorId, Task, TaskBuilder};

fn refused(change: impl Fn(&mut Options)) -> String {
    let problem = Arc::new(Delivery::figure_1().problem().unwrap());
    let mut options = Options::new(Solver::Exact);
    change(&mut options);
    let by_check = options.check(&problem).unwrap_err().to_string();
    // A run refuses what the check refuses.
    assert_eq!(Run::new(problem, options).map(|_| ()).unwrap_err().to_string(), by_check);
    by_check
}

#[test]
fn options() {
    let bound = "expected a whole number from 1 to 6, the number of goals";
    assert_eq!(refused(|o| o.bounds.at_least = Some(0)), format!("k: found 0, {bound}"));
    assert_eq!(refused(|o| o.bounds.at_least = Some(7)), format!("k: found 7, {bound}"));
    assert_eq!(refused(|o| o.bounds.at_most = Some(0)), format!("j: found 0, {bound}"));
    assert_eq!(refused(|o| o.bounds.at_most = Some(7)), format!("j: found 7, {bound}"));
    let steps = "expected a whole number from 0 to 10000";
    let long = Horizon::Steps(10_001);
    assert_eq!(refused(|o| o.horizon = long), format!("horizon: found 10001, {steps}"));
    assert_eq!(refused(|o| o.horizon_step = 10_001), format!("horizon step: found 10001, {steps}"));
    assert_eq!(
        refused(|o| o.horizon_limit = 20_000),
        format!("horizon limit: found 20000, {steps}")
    );
    let any = refused(|o| (o.solver, o.horizon) = (Solver::Ip, Horizon::Any));
    assert_eq!(
        any,
        "horizon: found any, expected a number of steps for the integer program; the exact solver takes any"
    );
    let pairs = refused(|o| (o.solver, o.pairs) = (Solver::Search, true));
    assert_eq!(pairs, "pairs: found the solver search, expected the solver exact");
}

#[test]
fn goals_and_observers_that_do_not_exist() {
    let watched = |observer, goal| vec![Watched { observer, goal }];
    let required = |required| {
        move |o: &mut Options| {
            o.bounds = Bounds::default().with_required(required);
        }
    };
    let goal = "expected the position of a goal, 0 to 5";
    let observer = "expected the position of an observer, 0 to 1";
    for solver in Solver::ALL {
        let found = refused(|o| {
            o.solver = solver;
            required(watched(0, 6))(o);
        });
        assert_eq!(found, format!("require: found 6, {goal}"));
    }
    let found = refused(|o| required(watched(2, 0))(o));
    assert_eq!(found, format!("require: found 2, {observer}"));
    let found = refused(|o| o.bounds.forbidden = watched(usize::MAX, 0));
    assert_eq!(found, format!("forbid: found {}, {observer}", usize::MAX));
}

/// One operator from `here` to `there`, named `go`.
fn task() -> Task {
    let mut task = TaskBuilder::default();
    let (here, there) = (task.fact("here"), task.fact("there"));
    task.operator("go", &[here], &[there], &[here]);
    task.build(&[here], &[there]).unwrap()
}

fn observer(task: &Task, name: &str, role: Role) -> Observer {
    let mut sensor = SensorBuilder::new(task);
    sensor.always(OperatorId::of(task, 0).unwrap(), "something");
    Observer {
        name: name.to_owned(),
        role,
        sensor: Arc::new(sensor.build(task).unwrap()),
        initial_belief: vec![task.initial_state().clone()].into(),
    }
}

/// The true goal (to be there) and others, by their names; the message of what is refused.
fn made(goals: &[&str], true_goal: usize, change: impl Fn(&mut Vec<Observer>)) -> String {
    let task = task();
    let goal = |name: &&str| {
        let condition = if **name == *"there" { task.goal().to_vec() } else { Vec::new() };
        Goal { name: (*name).to_owned(), condition }
    };
    let goals = goals.iter().map(goal).collect();
    let mut observers =
        vec![observer(&task, "enemy", Adversarial), observer(&task, "friend", Cooperative)];
    change(&mut observers);
    let made = Problem::new(task, goals, true_goal, observers, StateNaming::Facts);
    made.map_or_else(|error| error.to_string(), |_| "no error".to_owned())
}

#[test]
fn problems() {
    let nothing = |_: &mut Vec<Observer>| ();
    assert_eq!(made(&["there", "anywhere"], 0, nothing), "no error");
    assert_eq!(made(&["there"], 0, nothing), "found 1 candidate goals, expected 2 to 1024");
    assert_eq!(made(&["there", "there"], 0, nothing), "goal there is named twice");
    let true_goal = "the true goal is not a candidate goal with the condition of the task's goal";
    assert_eq!(made(&["there", "anywhere"], 1, nothing), true_goal);
    assert_eq!(made(&["there", "anywhere"], 2, nothing), true_goal);
    let goals = ["there", "anywhere"];
    assert_eq!(
        made(&goals, 0, |o| drop(o.pop())),
        "there is no cooperative observer, expected at least one"
    );
    assert_eq!(
        made(&goals, 0, |o| drop(o.remove(0))),
        "there is no adversarial observer, expected at least one"
    );
    assert_eq!(
        made(&goals, 0, |o| o[1].name = "enemy".to_owned()),
        "observer enemy is named twice"
    );
    assert_eq!(
        made(&goals, 0, |o| o[1].initial_belief = Vec::new().into()),
        "the initial belief of observer friend lacks the initial state"
    );
}

#[test]
fn sensors() {
    let task = task();
    let error = SensorBuilder::new(&task).build(&task).unwrap_err();
    assert_eq!(error.to_string(), "the sensor gives no symbol for action go");
    // Cases alone do not cover every state.
    let mut sensor = SensorBuilder::new(&task);
    let here: Vec<_> = task.facts().take(1).collect();
    sensor.when(OperatorId::of(&task, 0).unwrap(), &here, "seen");
    assert!(sensor.build(&task).is_err());
    assert_eq!(OperatorId::of(&task, 1), None);
}
