//! The command `mo-copp`.

fn main() {}
