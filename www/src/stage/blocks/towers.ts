// What the facts of a blocks world say: towers from the bottom up, and what the hand holds. The predicates are those of
// the competitions' domain: on, ontable or on-table, holding.
import { type Atom, hasPredicate, type PddlScene } from "../pddl/atoms.js";

export interface Towers {
  /** From the bottom up. `grounded`: the lowest block is known to stand on the table. */
  towers: { blocks: string[]; grounded: boolean }[];
  held: string | null;
  /** Whether anything is said of the hand. */
  hand: boolean;
}

export const onTable: readonly string[] = ["ontable", "on-table"];

export const isBlocks = (scene: PddlScene): boolean =>
  hasPredicate(scene, "on", 2) && onTable.some((name) => hasPredicate(scene, name, 1));

/** `order`: the blocks in the document's order, which towers keep by their lowest blocks. */
export function towersOf(atoms: readonly Atom[], order: readonly string[]): Towers {
  const above = new Map<string, string>();
  const resting = new Set<string>();
  const named = new Set<string>();
  const grounded = new Set<string>();
  let held: string | null = null;
  let hand = false;
  for (const { predicate, objects } of atoms) {
    const [block = "", below] = objects;
    if (predicate === "on" && below !== undefined) {
      above.set(below, block);
      resting.add(block);
      named.add(block).add(below);
    } else if (onTable.includes(predicate)) {
      grounded.add(block);
      named.add(block);
    } else if (predicate === "holding") {
      held = block;
      hand = true;
    } else if (predicate === "handempty" || predicate === "hand-empty" || predicate === "arm-empty") {
      hand = true;
    }
  }
  const places = new Map(order.map((name, index) => [name, index]));
  const place = (name: string) => places.get(name) ?? order.length;
  const lowest = [...named].filter((block) => !resting.has(block)).sort((a, b) => place(a) - place(b));
  return {
    towers: lowest.map((block) => ({ blocks: tower(block, above), grounded: grounded.has(block) })),
    held,
    hand,
  };
}

/** A condition may say what no state can: blocks in a ring. Each block is taken once. */
function tower(lowest: string, above: ReadonlyMap<string, string>): string[] {
  const blocks = [lowest];
  for (let next = above.get(lowest); next !== undefined && !blocks.includes(next); next = above.get(next)) {
    blocks.push(next);
  }
  return blocks;
}
