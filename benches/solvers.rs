//! Benchmarks of the solvers.

fn main() {}
