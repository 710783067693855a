//! Arguments that cannot be read, in plain words.

use std::error::Error;
use std::io::Write;
use std::num::{IntErrorKind, ParseIntError};

use clap::Parser;

use super::BAD_INPUT;
use super::args::CommandLine;

/// Reads the arguments; ends the program where they cannot be read, or help is asked for.
pub fn command_line() -> CommandLine {
    CommandLine::try_parse().unwrap_or_else(|error| match no_number(&error) {
        Some(text) => {
            let _ = write!(std::io::stderr(), "{text}");
            std::process::exit(i32::from(BAD_INPUT))
        }
        None => error.exit(),
    })
}

/// The message about an argument that is no number, which names what is expected.
fn no_number(error: &clap::Error) -> Option<String> {
    let source = error.source()?.downcast_ref::<ParseIntError>()?;
    let expected = match source.kind() {
        IntErrorKind::PosOverflow => "expected a smaller number",
        _ => "expected a whole number from 0",
    };
    Some(error.to_string().replace(&source.to_string(), expected))
}
