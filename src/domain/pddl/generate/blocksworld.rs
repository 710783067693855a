//! Draws random Blocksworld problems.

use super::{Draft, MAX_BELIEF, below, distinct, halves};
use crate::domain::generate::{Drawn, GenerateError, draw, in_range, random};
use crate::domain::pddl::Pddl;

/// The size of a random Blocksworld problem. The default is the paper's: 5 blocks and 5 candidate
/// goals, each a tower of all blocks, which with 5 blocks has 4 facts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BlocksworldShape {
    /// Blocks, named a, b, c, ….
    pub blocks: u32,
    /// Candidate goals.
    pub goals: u32,
    /// States in each initial belief, at most: 1 is the initial state alone. Of more, each observer
    /// has from 1 to this many drawn for itself.
    pub belief: u32,
}

impl Default for BlocksworldShape {
    fn default() -> Self {
        Self { blocks: 5, goals: 5, belief: 1 }
    }
}

impl BlocksworldShape {
    /// Draws stacks of blocks and towers to build of them. No goal holds at the start.
    ///
    /// # Errors
    ///
    /// The numbers make no sense together.
    ///
    /// ```
    /// use mo_copp::domain::pddl::generate::BlocksworldShape;
    /// let drawn = BlocksworldShape::default().generate(7)?;
    /// assert_eq!(drawn.document.goals.len(), 5);
    /// # Ok::<(), mo_copp::domain::generate::GenerateError>(())
    /// ```
    pub fn generate(self, seed: u64) -> Result<Drawn<Pddl>, GenerateError> {
        in_range("blocks", self.blocks, 3..=26)?;
        // Of three blocks there are six towers, one of which may stand already.
        let towers = (1..=self.blocks.min(6)).product::<u32>() - 1;
        in_range("goals", self.goals, 2..=towers)?;
        in_range("belief", self.belief, 1..=MAX_BELIEF)?;
        let mut random = random(seed);
        let names: Vec<String> = ('a'..='z').take(self.blocks as usize).map(String::from).collect();
        // Blocks in random order, each on a random stack or on the table.
        let mut stacks: Vec<Vec<String>> = Vec::new();
        for block in draw(&mut random, &mut names.clone(), names.len()) {
            let place = below(&mut random, stacks.len() + 1);
            if place == stacks.len() {
                stacks.push(Vec::new());
            }
            stacks[place].push(block);
        }
        let tower = || vec![draw(&mut random, &mut names.clone(), names.len())];
        let towers = distinct(self.goals, vec![stacks.clone()], tower);
        let on = |stack: &[String]| -> Vec<String> {
            stack.windows(2).map(|pair| format!("(on {} {})", pair[1], pair[0])).collect()
        };
        let line = |stack: &Vec<String>| {
            let (bottom, top) = (&stack[0], &stack[stack.len() - 1]);
            let facts = [vec![format!("(ontable {bottom})")], on(stack)].concat();
            format!("{} (clear {top})", facts.join(" "))
        };
        let document = Draft {
            domain: "blocksworld",
            text: include_str!("blocksworld.pddl"),
            seed,
            objects: vec![format!("{} - block", names.join(" "))],
            init: std::iter::once("(handempty)".to_owned())
                .chain(stacks.iter().map(line))
                .collect(),
            goals: towers.iter().map(|tower| on(&tower[0])).collect(),
            groups: halves(&names),
        };
        Ok(Drawn { document: document.document(self.belief, &mut random), redraws: 0 })
    }
}
