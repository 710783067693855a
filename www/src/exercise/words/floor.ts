// Problems on a floor in words: gridworld, box pushing, the recycling robot.
import type { State } from "../../core.js";
import { cellText } from "../../problem/cells.js";
import type { FloorDocument, Role } from "../../problem/types.js";
import { roles } from "../../view/observers.js";
import { placeText, stateText } from "../state-text.js";
import { type InWords, listed, type Sentence, toldText, trueGoalText, who } from "./sensor.js";

type Parts = Record<string, unknown>;

interface Watcher {
  initial_belief?: readonly unknown[];
  cameras?: readonly (readonly number[])[];
  sensor: Record<string, string>;
}

const cells = (list: readonly (readonly number[])[]): string => list.map(cellText).join("; ");

/** What a goal is about. */
const inGoal: Record<FloorDocument["format"], string> = {
  gridworld: "Goals, each a cell for the agent",
  "box-pushing": "Goals, each a cell for the box",
  "recycling-robot": "Goals, each a cell for the can: there is a bin",
};

export function floorInWords(document: FloorDocument): InWords {
  const { width, height, walls = [], goals, true_goal, observers } = document;
  const sentences = [
    `${width} columns from the left, ${height} rows from the top, both counted from 0.`,
    ...(walls.length === 0 ? [] : [`Walls: ${cells(walls)}.`]),
    ...startOf(document),
    `${inGoal[document.format]}: ${goals.map(({ name, cell }) => `${name} at ${cellText(cell)}`).join("; ")}.`,
    ...trueGoalText(true_goal),
  ];
  return {
    sentences,
    told: { sentences: roles.flatMap((role) => watcherText(role, observers[role], document.start)) },
  };
}

function startOf(document: FloorDocument): string[] {
  if (document.format === "gridworld") return [`Start: ${cellText(document.start)}.`];
  if (document.format === "box-pushing") {
    const { robot, facing, box } = document.start;
    return [`The robot begins at ${cellText(robot)} and faces ${facing}.`, `The box begins at ${cellText(box)}.`];
  }
  const { robot, battery, can } = document.start;
  const full = document.battery_levels - 1;
  return [
    `The robot begins at ${cellText(robot)} with battery ${battery} of ${full}; a move takes one.`,
    can === "held" ? "The robot holds the can at first." : `The can begins at ${cellText(can)}.`,
    `The charger: ${cellText(document.charger)}.`,
  ];
}

function watcherText(role: Role, { sensor, cameras = [], initial_belief }: Watcher, start: unknown): Sentence[] {
  const watched =
    cameras.length === 0 ? "" : ` Its cameras: ${cells(cameras)}; there it is told the very cell instead.`;
  const told = `${who(role)} is told ${toldText(Object.entries(sensor))}.${watched}`;
  return [beliefText(who(role), initial_belief ?? [], start), told];
}

/** What is not known where a part of the start is doubtful. */
const doubted: Record<string, string> = {
  robot: "where the robot is",
  facing: "which way the robot faces",
  box: "where the box is",
  battery: "how full the battery is",
  can: "where the can is",
};

/** A first belief: what is doubtful of the start, where that is one part, else the states one by one. */
function beliefText(watcher: string, states: readonly unknown[], start: unknown): Sentence {
  const doubts = (what: string, each: readonly string[]): Sentence =>
    each.some((one) => one.includes(","))
      ? { said: `At first ${watcher.toLowerCase()} does not know ${what}. It may be any of these:`, each }
      : `At first ${watcher.toLowerCase()} does not know ${what}: it may be ${listed(each, "or")}.`;
  const knows = `${watcher} knows the start.`;
  if (Array.isArray(start)) {
    const [only, ...more] = states as number[][];
    return only === undefined || more.length === 0 ? knows : doubts("the start", [only, ...more].map(cellText));
  }
  const parts = Object.keys(start as Parts).filter((key) =>
    states.some((state) => JSON.stringify((state as Parts)[key]) !== JSON.stringify((start as Parts)[key])),
  );
  const [part] = parts;
  if (part === undefined) return knows;
  if (parts.length > 1)
    return doubts(
      "how all begins",
      states.map((state) => stateText(state as State)),
    );
  return doubts(
    doubted[part] ?? part,
    states.map((state) => placeText((state as Parts)[part])),
  );
}
