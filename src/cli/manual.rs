//! `mo-copp schema`, `completions` and `manual`: made from the definitions of documents and of arguments.

use clap::CommandFactory;
use mo_copp::solver::OptionsError;

use super::args::{CommandLine, CompletionsArgs, ManualArgs};
use super::error::CliError;
use super::print;

/// Prints the JSON Schema of documents; the exit code.
pub fn schema() -> Result<u8, CliError> {
    let schema = mo_copp::exercise::schema::with_exercises(mo_copp::domain::schema::schema());
    print(&format!("{schema:#}\n"))?;
    Ok(0)
}

/// Prints the completions of a shell; the exit code.
pub fn completions(args: &CompletionsArgs) -> Result<u8, CliError> {
    let mut bytes = Vec::new();
    clap_complete::generate(args.shell, &mut CommandLine::command(), "mo-copp", &mut bytes);
    print(&String::from_utf8_lossy(&bytes))?;
    Ok(0)
}

/// Prints a manual page in roff; the exit code.
pub fn run(args: &ManualArgs) -> Result<u8, CliError> {
    let mut whole = CommandLine::command();
    whole.build();
    let page = match &args.command {
        None => whole,
        Some(name) => match whole.find_subcommand(name) {
            Some(found) => {
                // A page of its own goes by the whole name.
                let full = format!("mo-copp-{}", found.get_name());
                found.clone().name(full)
            }
            None => {
                let known: Vec<&str> =
                    whole.get_subcommands().map(clap::Command::get_name).collect();
                let found = format!("{name:?}");
                return Err(OptionsError::new("command", found, known.join(", ")).into());
            }
        },
    };
    let mut bytes = Vec::new();
    clap_mangen::Man::new(page).render(&mut bytes).map_err(CliError::Output)?;
    print(&String::from_utf8_lossy(&bytes))?;
    Ok(0)
}
