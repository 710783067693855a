//! `mo-copp generate`: prints a random document.

use mo_copp::domain::box_pushing::BoxPushingShape;
use mo_copp::domain::delivery::DeliveryShape;
use mo_copp::domain::generate::{Domain, Drawn};
use mo_copp::domain::gridworld::GridworldShape;
use mo_copp::domain::pddl::generate::{BlocksworldShape, DriverlogShape, LogisticsShape};
use mo_copp::domain::recycling_robot::RecyclingRobotShape;
use mo_copp::solver::OptionsError;

use super::args::GenerateArgs;
use super::error::CliError;
use super::{note, print};

/// Prints a document; the exit code.
pub fn run(args: &GenerateArgs) -> Result<u8, CliError> {
    let drawn = match args.domain {
        Domain::Gridworld => gridworld(args)?,
        Domain::BoxPushing => box_pushing(args)?,
        Domain::RecyclingRobot => recycling_robot(args)?,
        Domain::Delivery => delivery(args)?,
        Domain::Blocksworld => blocksworld(args)?,
        Domain::Logistics => logistics(args)?,
        Domain::Driverlog => driverlog(args)?,
    };
    print(&(drawn.document.to_json() + "\n"))?;
    if drawn.redraws > 0 {
        let before = match drawn.redraws {
            1 => "1 problem without a plan was".to_owned(),
            count => format!("{count} problems without a plan were"),
        };
        note(&format!("note: {before} drawn before this one"));
    }
    Ok(0)
}

/// The sizes of every domain with cells.
const OF_GRIDS: [&str; 5] = ["width", "height", "goals", "walls", "belief"];

/// Sizes of another domain than the one asked for are a mistake.
fn allow(args: &GenerateArgs, sizes: &[&str]) -> Result<(), CliError> {
    let given = [
        ("width", args.width),
        ("height", args.height),
        ("goals", args.goals),
        ("walls", args.walls),
        ("belief", args.belief),
        ("battery-levels", args.battery_levels),
        ("factories", args.factories),
        ("packages", args.packages),
        ("deliver", args.deliver),
        ("blocks", args.blocks),
    ];
    let other = |&(option, value): &(&'static str, Option<u32>)| {
        value.filter(|_| !sizes.contains(&option)).map(|value| (option, value))
    };
    match given.iter().find_map(other) {
        None => Ok(()),
        Some((option, value)) => {
            let expected = format!("nothing, since {} has no such size", args.domain.name());
            Err(OptionsError::new(option, value.to_string(), expected).into())
        }
    }
}

fn gridworld(args: &GenerateArgs) -> Result<Drawn, CliError> {
    allow(args, &OF_GRIDS)?;
    let default = GridworldShape::default();
    let width = args.width.unwrap_or(default.width);
    let height = args.height.unwrap_or(default.height);
    let walls = args.walls.unwrap_or(default.walls);
    let shape = GridworldShape {
        width,
        height,
        walls,
        goals: args.goals.unwrap_or(default.goals),
        belief: args.belief.unwrap_or(default.belief.min(room(width, height, walls))),
    };
    Ok(shape.generate(args.seed)?.any())
}

/// How many cells are free, or 1 where the numbers make no sense: a small grid has room for a
/// smaller belief.
fn room(width: u32, height: u32, walls: u32) -> u32 {
    width.saturating_mul(height).saturating_sub(walls).max(1)
}

fn box_pushing(args: &GenerateArgs) -> Result<Drawn, CliError> {
    allow(args, &OF_GRIDS)?;
    let default = BoxPushingShape::default();
    let shape = BoxPushingShape {
        width: args.width.unwrap_or(default.width),
        height: args.height.unwrap_or(default.height),
        walls: args.walls.unwrap_or(default.walls),
        goals: args.goals.unwrap_or(default.goals),
        belief: args.belief.unwrap_or(default.belief),
    };
    Ok(shape.generate(args.seed)?.any())
}

fn recycling_robot(args: &GenerateArgs) -> Result<Drawn, CliError> {
    allow(args, &[&OF_GRIDS[..], &["battery-levels"]].concat())?;
    let default = RecyclingRobotShape::default();
    let width = args.width.unwrap_or(default.width);
    let height = args.height.unwrap_or(default.height);
    let walls = args.walls.unwrap_or(default.walls);
    let shape = RecyclingRobotShape {
        width,
        height,
        walls,
        goals: args.goals.unwrap_or(default.goals),
        belief: args.belief.unwrap_or(default.belief.min(room(width, height, walls))),
        battery_levels: args.battery_levels.unwrap_or(default.battery_levels),
    };
    Ok(shape.generate(args.seed)?.any())
}

fn delivery(args: &GenerateArgs) -> Result<Drawn, CliError> {
    allow(args, &["factories", "packages", "deliver"])?;
    let default = DeliveryShape::default();
    let packages = args.packages.unwrap_or(default.packages);
    let shape = DeliveryShape {
        factories: args.factories.unwrap_or(default.factories.min(packages).max(1)),
        packages,
        deliver: args.deliver.unwrap_or(default.deliver),
    };
    Ok(shape.generate(args.seed)?.any())
}

fn blocksworld(args: &GenerateArgs) -> Result<Drawn, CliError> {
    allow(args, &["blocks", "goals", "belief"])?;
    let default = BlocksworldShape::default();
    let shape = BlocksworldShape {
        blocks: args.blocks.unwrap_or(default.blocks),
        goals: args.goals.unwrap_or(default.goals),
        belief: args.belief.unwrap_or(default.belief),
    };
    Ok(shape.generate(args.seed)?.any())
}

fn logistics(args: &GenerateArgs) -> Result<Drawn, CliError> {
    allow(args, &["packages", "goals", "belief"])?;
    let default = LogisticsShape::default();
    let packages = args.packages.unwrap_or(default.packages);
    let shape = LogisticsShape {
        packages,
        facts: default.facts.min(packages),
        goals: args.goals.unwrap_or(default.goals),
        belief: args.belief.unwrap_or(default.belief),
        ..default
    };
    Ok(shape.generate(args.seed)?.any())
}

fn driverlog(args: &GenerateArgs) -> Result<Drawn, CliError> {
    allow(args, &["packages", "goals", "belief"])?;
    let default = DriverlogShape::default();
    let shape = DriverlogShape {
        packages: args.packages.unwrap_or(default.packages),
        goals: args.goals.unwrap_or(default.goals),
        belief: args.belief.unwrap_or(default.belief),
        ..default
    };
    Ok(shape.generate(args.seed)?.any())
}
