//! Times the solvers: `cargo bench`.
//!
//! Each line is one kind of work on one or many problems drawn by seed. Every problem is solved
//! several times in a row and its median counts; of these the line gives the median and the worst.
//! `cargo bench -- NAME` runs the lines whose name holds NAME. Machines differ: compare lines of one
//! run.
#![allow(clippy::expect_used, clippy::print_stdout)]

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::{Duration, Instant};

use mo_copp::domain::generate::Domain;
use mo_copp::domain::gridworld::GridworldShape;
use mo_copp::problem::Problem;
use mo_copp::solver::remedy::RemedyRun;
use mo_copp::solver::{Encoding, Horizon, Options, Outcome, Solver, Status, solve};

fn grid(shape: GridworldShape, seed: u64) -> Arc<Problem> {
    let document = shape.generate(seed).expect("a shape that can be drawn").document;
    Arc::new(document.problem().expect("a drawn document is well-formed"))
}

fn answer(problem: &Arc<Problem>, options: &Options) -> Outcome {
    let outcome = solve(Arc::clone(problem), options.clone(), |_| ControlFlow::Continue(()));
    outcome.expect("a solver does not break down")
}

fn median(mut times: Vec<Duration>) -> Duration {
    times.sort_unstable();
    times[times.len() / 2]
}

/// Times each problem `repeats` times; the line printed, unless the filter leaves it out.
fn line(name: &str, target: &str, repeats: usize, work: &[(Arc<Problem>, Options)]) {
    let filter = std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    if filter.is_some_and(|filter| !name.contains(&filter)) {
        return;
    }
    let mut times = Vec::new();
    let mut statuses: Vec<(&str, usize)> = Vec::new();
    for (problem, options) in work {
        let mut runs = Vec::new();
        let mut outcome = None;
        for _ in 0..repeats {
            let begin = Instant::now();
            outcome = Some(answer(problem, options));
            runs.push(begin.elapsed());
        }
        times.push(median(runs));
        let status = outcome.expect("at least one run").status.name();
        match statuses.iter_mut().find(|(known, _)| *known == status) {
            Some((_, count)) => *count += 1,
            None => statuses.push((status, 1)),
        }
    }
    let worst = times.iter().max().copied().unwrap_or_default();
    let statuses: Vec<String> = statuses.iter().map(|(s, n)| format!("{n} {s}")).collect();
    println!(
        "{name:34} {:>11.3} ms {:>11.3} ms   {target:32} {}",
        median(times).as_secs_f64() * 1e3,
        worst.as_secs_f64() * 1e3,
        statuses.join(", ")
    );
}

fn options(solver: Solver, horizon: Horizon) -> Options {
    Options::new(solver).with_horizon(horizon)
}

/// The first `count` problems that have a plan at one of two horizons, with that horizon.
fn at_horizon(
    shape: GridworldShape,
    count: usize,
    horizons: [usize; 2],
) -> Vec<(Arc<Problem>, usize)> {
    let mut found = Vec::new();
    for seed in 0.. {
        if found.len() == count {
            break;
        }
        let problem = grid(shape, seed);
        let fits = |steps: &usize| {
            let exact = options(Solver::Exact, Horizon::Steps(*steps));
            answer(&problem, &exact).status == Status::Optimal
        };
        if let Some(steps) = horizons.into_iter().find(fits) {
            found.push((problem, steps));
        }
    }
    found
}

/// The length of a shortest plan for the true goal.
fn shortest(problem: &Arc<Problem>) -> usize {
    let none = options(Solver::Exact, Horizon::Steps(0));
    let mut run = RemedyRun::new(Arc::clone(problem), none).expect("options that fit");
    while !run.advance(1000).expect("the search does not break down") {}
    let advice = run.outcome().expect("remedies do");
    advice.shortest.expect("drawn problems can be solved")
}

/// What the page's editor makes at its largest: walls on up to a fifth of the cells, the start alone
/// or eleven cells believed possible.
fn largest() -> Vec<Arc<Problem>> {
    let mut problems = Vec::new();
    for belief in [1, 11] {
        for walls in [0, 50, 100, 150, 200] {
            let paper = GridworldShape::default();
            let shape = GridworldShape { width: 32, height: 32, walls, belief, ..paper };
            problems.extend((0..10).map(|seed| grid(shape, seed)));
        }
    }
    problems
}

fn main() {
    println!("{:34} {:>14} {:>14}   {:32} outcomes", "work", "median", "worst", "to reach");
    let paper = GridworldShape::default();
    let small = GridworldShape { width: 4, height: 4, belief: 4, ..paper };
    let large = GridworldShape { width: 64, height: 64, ..paper };

    let eight = at_horizon(paper, 30, [12, 14]);
    let with = |problems: &[(Arc<Problem>, usize)], make: &dyn Fn(usize) -> Options| {
        problems
            .iter()
            .map(|(problem, steps)| (Arc::clone(problem), make(*steps)))
            .collect::<Vec<_>>()
    };
    let exact = with(&eight, &|steps| options(Solver::Exact, Horizon::Steps(steps)));
    line("exact, 8x8, T = 12 or 14", "1 ms", 21, &exact);
    let any = with(&eight, &|_| options(Solver::Exact, Horizon::Any));
    line("exact, 8x8, all horizons", "5 ms", 21, &any);
    let pairs = with(&eight, &|_| options(Solver::Exact, Horizon::Any).with_pairs(true));
    line("exact, 8x8, all horizons and pairs", "-", 21, &pairs);
    let one = at_horizon(large, 1, [96, 98]);
    let exact = with(&one, &|steps| options(Solver::Exact, Horizon::Steps(steps)));
    line("exact, 64x64, T = 96 or 98", "1 s", 5, &exact);

    let largest: Vec<_> =
        largest().into_iter().map(|p| (Arc::clone(&p), shortest(&p) + 2)).collect();
    let limited = |horizon| {
        let mut exact = options(Solver::Exact, horizon);
        exact.limits.expansions = 30_000;
        exact
    };
    let any = with(&largest, &|_| limited(Horizon::Any));
    line("exact, 32x32, all horizons", "100 ms in wasm", 3, &any);
    let exact = with(&largest, &|steps| limited(Horizon::Steps(steps)));
    line("exact, 32x32, T = shortest + 2", "100 ms in wasm", 3, &exact);

    let flow = with(&eight, &|steps| options(Solver::Ip, Horizon::Steps(steps)));
    line("belief-flow, 8x8, T = 12 or 14", "median 0.1 s, worst 1 s", 3, &flow);
    let four = at_horizon(small, 10, [6, 8]);
    let encoded = with(&four, &|steps| {
        options(Solver::Ip, Horizon::Steps(steps)).with_encoding(Encoding::Paper)
    });
    line("paper, 4x4, T = 6", "median 1 s", 1, &encoded);

    let search = with(&eight, &|_| {
        let mut search = options(Solver::Search, Horizon::Auto);
        (search.bounds.at_least, search.bounds.at_most) = (Some(2), Some(2));
        search
    });
    line("search, 8x8, k = 2, j = 2", "median 10 ms, no plan in 1 s", 5, &search);
    let strict = with(&eight, &|_| {
        let mut search = options(Solver::Search, Horizon::Auto);
        (search.bounds.at_least, search.bounds.at_most) = (Some(3), Some(1));
        search
    });
    line("search, 8x8, k = 3, j = 1", "no plan in 1 s", 5, &strict);
    let baseline = with(&eight, &|_| options(Solver::Baseline, Horizon::Auto));
    line("baseline, 8x8", "-", 21, &baseline);

    experiments();
}

/// What the paper's experiments ask, on the problems of seeds 1 to 30 of each domain.
fn experiments() {
    let drawn = |name: &str| {
        let domain = Domain::named(name).expect("a domain of the paper");
        let problem = |seed| {
            let document = domain.draw(seed).expect("the default size can be drawn").document;
            Arc::new(document.problem().expect("a drawn document is well-formed"))
        };
        (1..=30).map(problem).collect::<Vec<_>>()
    };
    let bounded = |problem: &Arc<Problem>, most: usize| {
        let mut search = options(Solver::Satisficing, Horizon::Any);
        (search.bounds.at_least, search.bounds.at_most) = (Some(most), Some(most));
        (Arc::clone(problem), search)
    };
    let (mut flow, mut search) = (Vec::new(), Vec::new());
    for (name, steps) in [("gridworld", 12), ("box-pushing", 12), ("recycling-robot", 10)] {
        for problem in drawn(name) {
            let asked = options(Solver::Ip, Horizon::Steps(steps)).with_horizon_step(2);
            search.push(bounded(&problem, 2));
            flow.push((problem, asked));
        }
    }
    line("belief-flow, 3 small domains", "median 0.1 s, worst 5 s", 1, &flow);
    line("satisficing, 3 small domains, k = j = 2", "median 50 ms", 1, &search);
    let boxes: Vec<_> = drawn("box-pushing")
        .into_iter()
        .map(|problem| (problem, options(Solver::Exact, Horizon::Any)))
        .collect();
    line("exact, box-pushing, all horizons", "proved", 1, &boxes);
    for name in ["blocksworld", "logistics", "driverlog"] {
        let problems = drawn(name);
        let search: Vec<_> = problems.iter().map(|problem| bounded(problem, 3)).collect();
        line(&format!("satisficing, {name}, k = j = 3"), "median 1 s, worst 60 s", 1, &search);
        if name == "blocksworld" {
            let twelve = options(Solver::Exact, Horizon::Steps(12));
            let exact: Vec<_> =
                problems.into_iter().map(|problem| (problem, twelve.clone())).collect();
            line("exact, blocksworld, T = 12", "worst 10 s", 1, &exact);
        }
    }
}
