//! The command `mo-copp`: solves, traces, encodes and generates problems.

#[cfg(not(target_arch = "wasm32"))]
mod cli;

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    cli::main()
}

/// The command is for native machines; wasm has the library.
#[cfg(target_arch = "wasm32")]
fn main() {}
