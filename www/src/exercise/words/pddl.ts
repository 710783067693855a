// A problem in PDDL in words: what holds at first, the goals, who begins with which doubt, and what observers are told.
// Actions and objects stand in its own texts.
import { type Role, roles } from "../../view/observers.js";
import { atomsOfInit } from "./pddl-init.js";
import { type InWords, listed, type Sentence, trueGoalText, who } from "./sensor.js";

interface Rule {
  operator: string;
  result?: string;
  symbol: string;
}

type Sensor = string | Rule[] | { table: [string, string][]; otherwise?: Sensor };
type Change = string[] | { add?: string[]; delete?: string[] };

interface Watcher {
  groups?: Record<string, string[]>;
  initial_belief?: Change[] | { reachable: string };
  sensor: Sensor;
}

export interface PddlWords {
  format: "pddl";
  domain: string | string[];
  problem: string | string[];
  goals: { name: string; condition: string }[];
  true_goal?: string;
  observers: Record<Role, Watcher>;
}

const textOf = (lines: string | string[]): string => (typeof lines === "string" ? lines : lines.join("\n"));

export function pddlInWords({ domain, problem, goals, true_goal, observers }: PddlWords): InWords {
  const init = atomsOfInit(textOf(problem));
  return {
    sentences: [
      `At first these hold, and nothing else: ${init.length === 0 ? "nothing" : init.join(", ")}.`,
      ...goals.map(({ name, condition }) => `The goal ${name}: ${condition}.`),
      ...trueGoalText(true_goal),
    ],
    texts: [
      { title: "The actions, in PDDL", text: textOf(domain) },
      { title: "The objects and the first state, in PDDL", text: textOf(problem) },
    ],
    told: { sentences: roles.flatMap((role) => watcherTexts(role, observers[role])) },
  };
}

function watcherTexts(role: Role, { groups = {}, initial_belief, sensor }: Watcher): Sentence[] {
  const alike = Object.entries(groups).map(([name, objects]) => `${listed(objects)} (read as ${name})`);
  return [
    beginsText(who(role), initial_belief),
    ...(alike.length === 0
      ? []
      : [`To ${role === "adversarial" ? "the enemy" : "the friend"} these look alike: ${alike.join("; ")}.`]),
    `${who(role)} is told ${sensorText(sensor)}.`,
  ];
}

function beginsText(watcher: string, belief: Watcher["initial_belief"]): Sentence {
  if (belief === undefined || (Array.isArray(belief) && belief.length === 1))
    return `${watcher} knows the first state.`;
  const doubts = `At first ${watcher.toLowerCase()} does not know the first state. It may be`;
  if ("reachable" in belief)
    return `${doubts} any state that can be reached and in which this holds: ${belief.reachable}.`;
  return { said: `${doubts} any of these:`, each: belief.map(stateText) };
}

function stateText(state: Change): string {
  if (Array.isArray(state)) return state.join(", ");
  const { add = [], delete: without = [] } = state;
  if (add.length + without.length === 0) return "the first state as it is";
  const changes = [...add.map((atom) => `with ${atom}`), ...without.map((atom) => `without ${atom}`)];
  return `the first state ${changes.join(" ")}`;
}

function sensorText(sensor: Sensor): string {
  if (typeof sensor === "string") return `of every action ${templateText(sensor)}`;
  if (Array.isArray(sensor)) {
    const rules = sensor.map(({ operator, result, symbol }) => {
      const after = result === undefined ? "" : ` after which ${result} holds`;
      return `of ${operator === "*" ? "every other action" : operator}${after}: ${templateText(symbol)}`;
    });
    return `what the first of these that fits says: ${rules.join("; ")}`;
  }
  const rows = sensor.table.map(([operator, symbol]) => `“${symbol}” for ${operator}`);
  const rest = sensor.otherwise === undefined ? "" : `; otherwise ${sensorText(sensor.otherwise)}`;
  return `${rows.join("; ")}${rest}`;
}

const ordinals = ["first", "second", "third", "fourth", "fifth"];

/** What a template leaves of an action. */
function templateText(template: string): string {
  if (!/[{}]/.test(template)) return `“${template}”`;
  if (template === "{name}") return "its name alone";
  if (template === "{name} {arguments}") return "its name and all of its objects";
  const simple = /^\{name\}((?: \{\d+\})+)$/.exec(template)?.[1];
  const places = (simple?.match(/\d+/g) ?? []).map((digits) => ordinals[Number(digits) - 1]);
  if (simple !== undefined && places.every((place) => place !== undefined))
    return `its name and its ${listed(places as string[])} object${places.length === 1 ? "" : "s"}`;
  return `“${template}”, where {name} is its name and a number the object at that place`;
}
