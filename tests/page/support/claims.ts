// What the article claims, worked out again by the core. A claim is written where it is made:
//   <b data-claim="survivors price plan=dark of=enemy">4</b>
// A quantity, the figure that it is of, and options. It must be what the text says; with a relation (`A = B`, `A < 3`) the
// relation must hold and the text is free. Several claims are separated by semicolons.
import assert from "node:assert/strict";
import { automaton } from "../../../scripts/learn/automaton.mjs";
import { documentOf, figureNames, planOf, plansOf } from "../../../scripts/learn/figures.mjs";
import { Problem } from "../../../www/pkg/mo_copp.js";
import type { Outcome, SolveOptions, Trace } from "../../../www/src/core.js";
import { said } from "./claims-of-figures.js";
import { replay, solve } from "./core.js";

type Options = Record<string, string>;
type Value = number | string;

const roles = { enemy: "adversarial", friend: "cooperative" } as const;
const roleOf = ({ of = "" }: Options) =>
  of === "enemy" || of === "friend" ? roles[of] : assert.fail(`“${of}” is no observer`);

/** The document of a figure; with `eyes`, both observers have the sensor of that one. */
function documentFor(figure: string, { eyes }: Options): string {
  if (eyes === undefined) return documentOf(figure);
  const document = JSON.parse(documentOf(figure));
  const sensor = document.observers[roleOf({ of: eyes })];
  return JSON.stringify({ ...document, observers: { adversarial: sensor, cooperative: sensor } });
}

const whole = (text: string | undefined) => (text === undefined ? {} : Number(text));

function outcome(figure: string, options: Options, more: Partial<SolveOptions> = {}): Outcome {
  const asked: Record<string, unknown> = { solver: options.solver ?? "exact", ...more };
  for (const name of ["k", "j", "horizon"]) if (options[name] !== undefined) asked[name] = whole(options[name]);
  if (options.encoding !== undefined) asked.encoding = options.encoding;
  return solve(documentFor(figure, options), asked as unknown as SolveOptions).outcome;
}

/** The plan that options name: one of the figure, or a solver's. */
function actions(figure: string, options: Options): string[] {
  if (options.plan !== undefined) return planOf(figure, options.plan);
  return outcome(figure, options).plan ?? assert.fail(`${figure} has no such plan`);
}

const trace = (figure: string, options: Options): Trace => replay(documentOf(figure), actions(figure, options));

function stepOf(figure: string, options: Options) {
  const { steps } = trace(figure, options);
  const step = steps[options.step === undefined ? steps.length - 1 : Number(options.step)];
  return step ?? assert.fail(`${figure} has no step ${options.step}`);
}

const texts = (states: readonly unknown[]) => states.map((state) => JSON.stringify(state)).sort();
const pairs = (figure: string) => outcome(figure, {}, { pairs: true });
const layers = (figure: string, { length }: Options) => automaton(figure, Number(length));
const lastLayer = (figure: string, options: Options) => layers(figure, options).at(-1) ?? assert.fail();

/** How many moves the nearest state of a goal is away: breadth first over the states. */
function distance(figure: string, goal: string): number {
  const document = JSON.parse(documentOf(figure));
  const problem = new Problem(JSON.stringify({ ...document, true_goal: goal }));
  const known = new Set<string>();
  let plans: string[][] = [[]];
  for (let moves = 1; plans.length > 0; moves += 1) {
    const further: string[][] = [];
    for (const plan of plans) {
      for (const { action, state, goal: there } of problem.next(plan)) {
        if (there) return moves;
        if (known.has(JSON.stringify(state))) continue;
        known.add(JSON.stringify(state));
        further.push([...plan, action]);
      }
    }
    plans = further;
  }
  return assert.fail(`${goal} cannot be reached`);
}

const quantities: Record<string, (figure: string, options: Options) => Value> = {
  ...said,
  // Of a plan, at a step or at its end.
  moves: (figure, options) => actions(figure, options).length,
  extra: (figure, options) => actions(figure, options).length - actions(figure, { plan: options.beyond ?? "" }).length,
  believed: (figure, options) => stepOf(figure, options).beliefs[roleOf(options)].length,
  belief: (figure, options) => texts(stepOf(figure, options).beliefs[roleOf(options)]).join(" "),
  least: (figure, options) => {
    // The start is known to everyone.
    const sizes = trace(figure, options)
      .steps.slice(1)
      .map(({ beliefs }) => beliefs[roleOf(options)].length);
    return Math.min(...sizes);
  },
  inside: (figure, options) =>
    trace(figure, options).steps.every(({ state, beliefs }) =>
      texts(beliefs[roleOf(options)]).includes(JSON.stringify(state)),
    )
      ? "yes"
      : "no",
  shared: (figure, options) => {
    const { adversarial, cooperative } = stepOf(figure, options).beliefs;
    const others = texts(cooperative);
    return texts(adversarial).filter((state) => others.includes(state)).length;
  },
  state: (figure, options) => JSON.stringify(stepOf(figure, options).state),
  survivors: (figure, options) => stepOf(figure, options).goals[roleOf(options)].length,
  names: (figure, options) => [...stepOf(figure, options).goals[roleOf(options)]].sort().join(", "),
  difference: (figure, options) => trace(figure, options).goal_difference,
  colours: (figure, options) =>
    new Set(
      stepOf(figure, options).beliefs[roleOf(options)].map(
        (cell) => (cell as number[]).reduce((sum, part) => sum + part, 0) % 2,
      ),
    ).size,
  // Of a problem.
  goals: (figure) => new Problem(documentOf(figure)).scene().goals.length,
  decoys: (figure) => new Problem(documentOf(figure)).scene().goals.length - 1,
  /** The goal difference where the enemy has learnt nothing, with all goals possible, and the friend all, with one. */
  most: (figure) => {
    const { length } = new Problem(documentOf(figure)).scene().goals;
    return (length - 1) / (length - 1);
  },
  size: (figure) => {
    const { width, height } = JSON.parse(documentOf(figure));
    return `${width} by ${height}`;
  },
  cells: (figure) => {
    const { width, height, walls = [] } = JSON.parse(documentOf(figure));
    return width * height - walls.length;
  },
  symbols: (figure, options) =>
    new Set(Object.values(JSON.parse(documentOf(figure)).observers[roleOf(options)].sensor)).size,
  cameras: (figure, options) => (JSON.parse(documentOf(figure)).observers[roleOf(options)].cameras ?? []).length,
  delivered: (figure) => JSON.parse(documentOf(figure)).deliver,
  factories: (figure) => JSON.parse(documentOf(figure)).factories.length,
  packages: (figure) =>
    JSON.parse(documentOf(figure)).factories.flatMap(({ packages }: { packages: string[] }) => packages).length,
  distance: (figure, { to = "" }) => distance(figure, to),
  // Of all plans.
  best: (figure, options) => {
    const { status, goal_difference: best } = outcome(figure, options);
    assert.equal(status, "optimal");
    return best ?? assert.fail();
  },
  pairs: (figure) => pairs(figure).pairs?.length ?? assert.fail(),
  front: (figure) => pairs(figure).front?.length ?? assert.fail(),
  largest: (figure, options) => Math.max(...(pairs(figure).pairs ?? []).map((pair) => pair[roleOf(options)])),
  dream: (figure) => {
    const found = pairs(figure).pairs ?? [];
    const most = Math.max(...found.map(({ adversarial }) => adversarial));
    const least = Math.min(...found.map(({ cooperative }) => cooperative));
    return found.some(({ adversarial, cooperative }) => adversarial === most && cooperative === least) ? "yes" : "no";
  },
  /** Along the front, the least that a goal less for the friend costs on the enemy's side. */
  slope: (figure) => {
    const front = [...(pairs(figure).front ?? [])].sort((one, other) => one.cooperative - other.cooperative);
    const costs = front.slice(1).map((pair, index) => {
      const before = front[index] ?? assert.fail();
      return (pair.adversarial - before.adversarial) / (pair.cooperative - before.cooperative);
    });
    return Math.min(...costs);
  },
  status: (figure, options) => outcome(figure, options).status,
  variables: (figure, options) => outcome(figure, options).stats.variables ?? assert.fail(),
  rows: (figure, options) => outcome(figure, options).stats.rows ?? assert.fail(),
  delta: (figure, options) => outcome(figure, options).stats.belief_size ?? assert.fail(),
  promise: (figure, { k, j }) => (Number(k) - Number(j)) / (new Problem(documentOf(figure)).scene().goals.length - 1),
  "true-goal-kept": () => (figureNames().every(keepsTrueGoal) ? "yes" : "no"),
  // Of the belief automaton.
  plans: (figure, options) => lastLayer(figure, options).plans,
  layer: (figure, options) => lastLayer(figure, options).nodes.length,
  known: (figure, options) => lastLayer(figure, options).known,
  arrivals: (figure, options) => sum(lastLayer(figure, options).nodes.filter(({ end }) => end)),
  optima: (figure, options) => {
    const ends = lastLayer(figure, options).nodes.filter(({ end }) => end);
    const best = Math.max(...ends.map(({ difference }) => difference));
    return sum(ends.filter(({ difference }) => difference === best));
  },
};

const sum = (nodes: readonly { plans: number }[]) => nodes.reduce((total, { plans }) => total + plans, 0);

/** Whether each plan of a figure that leads to the true goal leaves it possible for both. */
function keepsTrueGoal(figure: string): boolean {
  const { true_goal: goal } = JSON.parse(documentOf(figure));
  return Object.keys(plansOf(figure)).every((plan) => {
    const { goals } = stepOf(figure, { plan });
    return goals.adversarial.includes(goal) && goals.cooperative.includes(goal);
  });
}

/** A quantity of a claim, or a plain value. */
function evaluated(text: string): Value {
  const [name = "", ...rest] = text.trim().split(/\s+/);
  const quantity = quantities[name];
  if (quantity === undefined) return /^-?[\d.]+$/.test(name) ? Number(name) : name;
  const options = Object.fromEntries(rest.filter((part) => part.includes("=")).map((part) => part.split("=")));
  return quantity(rest.find((part) => !part.includes("=")) ?? "", options);
}

const relations: Record<string, (one: Value, other: Value) => boolean> = {
  "=": (one, other) => one === other,
  "!=": (one, other) => one !== other,
  ">": (one, other) => one > other,
  "<": (one, other) => one < other,
  ">=": (one, other) => one >= other,
};

export const numberWords = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"];

/** With number words as numbers. */
const inFigures = (text: string) =>
  text
    .replaceAll(/\s+/g, " ")
    .trim()
    .replaceAll(/[A-Za-z]+/g, (word) => {
      const number = numberWords.indexOf(word.toLowerCase());
      return number > 0 ? String(number) : word;
    })
    .replaceAll(/(\d),(\d{3})/g, "$1$2");

/** The numbers of a text; fractions are one number. */
const numbersOf = (text: string): number[] =>
  [...inFigures(text).matchAll(/(\d+)\/(\d+)|\d+(?:\.\d+)?/g)].map(([all, above, below]) =>
    above === undefined ? Number(all) : Number(above) / Number(below),
  );

const near = (one: number, other: number) => Math.abs(one - other) < 1e-9;

/** Fails where the text does not say what the core finds. */
export function assertClaim(claim: string, text: string): void {
  for (const part of claim.split(";")) {
    const [, left, relation, right] = /^(.*?) (=|!=|>=|>|<) (.*)$/.exec(part) ?? [];
    if (left !== undefined && relation !== undefined && right !== undefined) {
      const [one, other] = [evaluated(left), evaluated(right)];
      assert(relations[relation]?.(one, other), `${part}: ${one}, ${other}`);
      continue;
    }
    const value = evaluated(part);
    if (typeof value === "string") {
      assert.equal(inFigures(text), value, part);
      continue;
    }
    const said = numbersOf(text);
    assert(
      said.some((number) => near(number, value)),
      `${part}: the text says ${said}, the core ${value}`,
    );
    const named = [...part.matchAll(/=(\d+)/g)].map(([, number]) => Number(number));
    const strange = said.filter((number) => !near(number, value) && !named.includes(number));
    assert.deepEqual(strange, [], `${part}: “${text}”`);
  }
}
