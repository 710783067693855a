// Problem documents for the tests.
import { readFileSync } from "node:fs";

const sensor = {
  adversarial: { north: "vertical", south: "vertical", east: "horizontal", west: "horizontal" },
  cooperative: { north: "north-east", east: "north-east", south: "south-west", west: "south-west" },
};

/** A small open grid with two goals; parts of it can be set otherwise. */
export function grid(change: Record<string, unknown> = {}): string {
  return JSON.stringify({
    format: "gridworld",
    width: 4,
    height: 3,
    walls: [[1, 1]],
    start: [0, 2],
    goals: [
      { name: "G1", cell: [3, 0] },
      { name: "G2", cell: [0, 0] },
    ],
    true_goal: "G1",
    stay: false,
    observers: { adversarial: { sensor: sensor.adversarial }, cooperative: { sensor: sensor.cooperative } },
    ...change,
  });
}

/** So many beliefs that no exact search over plans of every length ends while a test waits: `mo-copp generate gridworld
 * --seed 6 --width 32 --height 32 --goals 6 --walls 150 --belief 300` with the nearest goal as the true one: a plan is found at once, and the proof does not end. */
const endlessDocument = readFileSync(new URL("endless.json", import.meta.url), "utf8");

export const endless = (): string => endlessDocument;

export const explicit: string = JSON.stringify({
  format: "explicit",
  states: ["s0", "s1", "s2"],
  actions: ["a", "b"],
  transitions: [
    ["s0", "a", "s1"],
    ["s0", "b", "s2"],
  ],
  initial_state: "s0",
  goals: [
    { name: "G1", states: ["s1"] },
    { name: "G2", states: ["s2"] },
  ],
  true_goal: "G1",
  observers: {
    adversarial: {
      initial_belief: ["s0"],
      sensor: [
        ["a", "s1", "moved"],
        ["b", "s2", "moved"],
      ],
    },
    cooperative: {
      initial_belief: ["s0"],
      sensor: [
        ["a", "s1", "a"],
        ["b", "s2", "b"],
      ],
    },
  },
});

/**
 * Looks at every belief longer than memory lasts on machines of any speed: in each of a row of states a hundred actions
 * look like one of two signs and do the same, and what a belief holds is which of the last forty signs were the one.
 */
export function laborious(): string {
  const [length, ways] = [40, 100];
  const transitions: [from: string, action: string, to: string][] = [];
  for (let way = 0; way < ways; way += 1) {
    transitions.push(["s0", `x${way}`, "s0"], ["s0", `o${way}`, "s0"], ["s0", `go x${way}`, "s1"]);
    for (let index = 1; index < length; index += 1) {
      transitions.push([`s${index}`, `x${way}`, `s${index + 1}`], [`s${index}`, `o${way}`, `s${index + 1}`]);
    }
  }
  const sensor = transitions.map(([, action, to]) => [action, to, action.includes("x") ? "x" : "o"]);
  const observer = {
    initial_belief: ["s0"],
    sensor: [...new Map(sensor.map((entry) => [String(entry), entry])).values()],
  };
  return JSON.stringify({
    format: "explicit",
    states: Array.from({ length: length + 1 }, (_, index) => `s${index}`),
    actions: [...new Set(transitions.map(([, action]) => action))],
    transitions,
    initial_state: "s0",
    goals: ["s0", "s1", `s${length}`].map((state) => ({ name: `at ${state}`, states: [state] })),
    true_goal: "at s0",
    observers: { adversarial: observer, cooperative: observer },
  });
}

/** The paper's delivery. */
export const figure1: string = delivery([2, 2], 2);

/** Factories A, B, … with so many packages each. */
export function delivery(counts: readonly number[], deliver: number): string {
  const factories = counts.map((count, index) => {
    const name = String.fromCharCode(65 + index);
    return { name, packages: Array.from({ length: count }, (_, pack) => `${name.toLowerCase()}${pack + 1}`) };
  });
  const load = Object.fromEntries(factories.map(({ name }) => [name, `barcode ${name}`]));
  return JSON.stringify({
    format: "delivery",
    factories,
    deliver,
    true_goal: factories
      .flatMap(({ packages }) => packages)
      .slice(0, deliver)
      .join("+"),
    observers: {
      adversarial: { sensor: { load: "package", deliver: "delivery" } },
      cooperative: { sensor: { load, deliver: "delivery" } },
    },
  });
}

/** As many candidate goals as a problem may have, on the largest grid. */
export function manyGoals(count = 1024): string {
  const size = 32;
  const goals = Array.from({ length: count }, (_, index) => ({
    name: `G${index + 1}`,
    cell: [(index * 7 + 5) % size, (Math.floor(index / size) + 11) % size],
  }));
  return grid({ width: size, height: size, walls: [], start: [0, 31], goals, true_goal: "G40" });
}
