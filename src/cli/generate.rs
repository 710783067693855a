//! `mo-copp generate`: prints a random document.

use mo_copp::domain::delivery::DeliveryShape;
use mo_copp::domain::generate::{Domain, Drawn};
use mo_copp::domain::gridworld::GridworldShape;
use mo_copp::domain::pddl::generate::{BlocksworldShape, DriverlogShape, LogisticsShape};
use mo_copp::solver::OptionsError;

use super::args::GenerateArgs;
use super::error::CliError;
use super::print;

/// Prints a document; the exit code.
pub fn run(args: &GenerateArgs) -> Result<u8, CliError> {
    let drawn = match args.domain {
        Domain::Gridworld => gridworld(args)?,
        Domain::Delivery => delivery(args)?,
        Domain::Blocksworld => blocksworld(args)?,
        Domain::Logistics => logistics(args)?,
        Domain::Driverlog => driverlog(args)?,
    };
    print(&(drawn.document.to_json() + "\n"))?;
    if drawn.redraws > 0 {
        eprintln!(
            "mo-copp: note: {} problems without a way to the goal were drawn before this one",
            drawn.redraws
        );
    }
    Ok(0)
}

/// Sizes of another domain than the one asked for are a mistake.
fn refuse(domain: &str, given: &[(&'static str, Option<u32>)]) -> Result<(), CliError> {
    match given.iter().find(|(_, value)| value.is_some()) {
        None => Ok(()),
        Some((option, value)) => Err(OptionsError {
            option,
            found: value.unwrap_or_default().to_string(),
            expected: format!("nothing, since a {domain} has no such size"),
        }
        .into()),
    }
}

fn gridworld(args: &GenerateArgs) -> Result<Drawn, CliError> {
    refuse(
        "gridworld",
        &[
            ("factories", args.factories),
            ("packages", args.packages),
            ("deliver", args.deliver),
            ("blocks", args.blocks),
        ],
    )?;
    let default = GridworldShape::default();
    let width = args.width.unwrap_or(default.width);
    let height = args.height.unwrap_or(default.height);
    let walls = args.walls.unwrap_or(default.walls);
    // A small grid has room for a smaller belief.
    let room = width.saturating_mul(height).saturating_sub(walls).max(1);
    let shape = GridworldShape {
        width,
        height,
        walls,
        goals: args.goals.unwrap_or(default.goals),
        belief: args.belief.unwrap_or(default.belief.min(room)),
    };
    Ok(shape.generate(args.seed)?.any())
}

fn delivery(args: &GenerateArgs) -> Result<Drawn, CliError> {
    refuse(
        "delivery",
        &[
            ("width", args.width),
            ("height", args.height),
            ("goals", args.goals),
            ("walls", args.walls),
            ("belief", args.belief),
            ("blocks", args.blocks),
        ],
    )?;
    let default = DeliveryShape::default();
    let packages = args.packages.unwrap_or(default.packages);
    let shape = DeliveryShape {
        factories: args.factories.unwrap_or(default.factories.min(packages).max(1)),
        packages,
        deliver: args.deliver.unwrap_or(default.deliver),
    };
    Ok(shape.generate(args.seed)?.any())
}

/// Sizes that none of the domains in PDDL has.
fn refuse_cells(domain: &str, args: &GenerateArgs) -> Result<(), CliError> {
    let cells = [
        ("width", args.width),
        ("height", args.height),
        ("walls", args.walls),
        ("belief", args.belief),
        ("factories", args.factories),
        ("deliver", args.deliver),
    ];
    refuse(domain, &cells)
}

fn blocksworld(args: &GenerateArgs) -> Result<Drawn, CliError> {
    refuse_cells("blocksworld", args)?;
    refuse("blocksworld", &[("packages", args.packages)])?;
    let default = BlocksworldShape::default();
    let shape = BlocksworldShape {
        blocks: args.blocks.unwrap_or(default.blocks),
        goals: args.goals.unwrap_or(default.goals),
    };
    Ok(shape.generate(args.seed)?.any())
}

fn logistics(args: &GenerateArgs) -> Result<Drawn, CliError> {
    refuse_cells("logistics", args)?;
    refuse("logistics", &[("blocks", args.blocks)])?;
    let default = LogisticsShape::default();
    let packages = args.packages.unwrap_or(default.packages);
    let shape = LogisticsShape {
        packages,
        facts: default.facts.min(packages),
        goals: args.goals.unwrap_or(default.goals),
        ..default
    };
    Ok(shape.generate(args.seed)?.any())
}

fn driverlog(args: &GenerateArgs) -> Result<Drawn, CliError> {
    refuse_cells("driverlog", args)?;
    refuse("driverlog", &[("blocks", args.blocks)])?;
    let default = DriverlogShape::default();
    let shape = DriverlogShape {
        packages: args.packages.unwrap_or(default.packages),
        goals: args.goals.unwrap_or(default.goals),
        ..default
    };
    Ok(shape.generate(args.seed)?.any())
}
