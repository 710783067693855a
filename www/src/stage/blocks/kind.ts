// The blocks world: how its states, facts and goals are shown.
import type { State } from "../../core.js";
import { atomOf, atomsOf, type PddlScene } from "../pddl/atoms.js";
import type { StateKind } from "../states/kind.js";
import { towersPicture } from "./picture.js";
import { onTable, type Towers, towersOf } from "./towers.js";

export { isBlocks } from "./towers.js";

export function blocksKind(scene: PddlScene): StateKind {
  const order = scene.objects.map(({ name }) => name);
  const of = (state: State) => towersOf(atomsOf(state), order);
  // All pictures of a problem keep one scale, as far as that leaves the blocks readable.
  const room = { columns: Math.min(order.length, 5), rows: Math.min(order.length, 5), hand: true };
  const little = { columns: 3, rows: Math.min(order.length, 4), hand: false };
  return {
    atOnce: order.length > 12 ? 1 : 6,
    picture: (state, small) => towersPicture(of(state), small ? little : room),
    described: (state) => told(of(state)),
    words,
    goals: (index) =>
      towersPicture(towersOf((scene.goals[index]?.facts ?? []).map(atomOf), order), {
        columns: 1,
        rows: 1,
        hand: false,
      }),
    goal: (index) => goalText(scene, index),
  };
}

function words(fact: string): string {
  const { predicate, objects } = atomOf(fact);
  const [first = "", second] = objects;
  if (predicate === "on" && second !== undefined) return `${first} is on ${second}`;
  if (onTable.includes(predicate)) return `${first} is on the table`;
  if (predicate === "clear") return `nothing is on ${first}`;
  if (predicate === "holding") return `the hand holds ${first}`;
  if (objects.length === 0 && predicate.includes("empty")) return "the hand is empty";
  return [predicate, ...objects].join(" ");
}

function told({ towers, held, hand }: Towers): string {
  const piles = towers.map(({ blocks }) =>
    blocks.length === 1 ? `${blocks[0]} alone` : [...blocks].reverse().join(" on "),
  );
  const holds = held === null ? (hand ? ["the hand is empty"] : []) : [`the hand holds ${held}`];
  return [...piles, ...holds].join("; ");
}

/** What is a negation, or always true, is in the condition alone. */
function goalText({ goals }: PddlScene, index: number): string {
  const goal = goals[index];
  if (goal === undefined) return "";
  return goal.facts.length === 0 || goal.condition.includes("(not ")
    ? goal.condition
    : goal.facts.map(words).join(", ");
}
