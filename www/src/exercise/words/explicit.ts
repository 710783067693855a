// A problem that lists its states in words.
import { counted } from "../../view/numbers.js";
import { type Role, roles } from "../../view/observers.js";
import { type InWords, listed, toldText, trueGoalText, who } from "./sensor.js";

type Transition = [from: string, action: string, to: string];

export interface ExplicitWords {
  format: "explicit";
  states: string[];
  actions: string[];
  transitions: Transition[];
  initial_state: string;
  goals: { name: string; states: string[] }[];
  true_goal?: string;
  observers: Record<Role, { initial_belief?: string[]; sensor: Transition[] }>;
}

/** More transitions are a list to look things up in. */
const MOST = 30;

export function explicitInWords(document: ExplicitWords): InWords {
  const { states, actions, transitions, initial_state, goals, true_goal, observers } = document;
  const steps = transitions.map(([from, action, to]) => `in ${from}, ${action} leads to ${to}`);
  const few = steps.length <= MOST;
  return {
    sentences: [
      `${counted(states.length, "state")}, ${counted(actions.length, "action")}. The agent begins in ${initial_state}.`,
      ...(few ? [`What can be done: ${steps.join("; ")}.`] : []),
      ...goals.map((goal) =>
        goal.states.length === 0
          ? `The goal ${goal.name} holds in no state.`
          : `The goal ${goal.name} holds in ${listed(goal.states)}.`,
      ),
      ...trueGoalText(true_goal),
    ],
    texts: few ? [] : [{ title: "What can be done", text: steps.join("\n") }],
    told: {
      sentences: roles.flatMap((role) => watcherTexts(role, observers[role], few)),
      texts: few ? [] : roles.map((role) => ({ title: `${who(role)} is told`, text: table(observers[role].sensor) })),
    },
  };
}

const table = (sensor: readonly Transition[]): string =>
  sensor.map(([action, to, symbol]) => `“${symbol}” for ${action} into ${to}`).join("\n");

function watcherTexts(
  role: Role,
  { initial_belief, sensor }: ExplicitWords["observers"][Role],
  few: boolean,
): string[] {
  const begins =
    initial_belief === undefined || initial_belief.length === 1
      ? `${who(role)} knows the first state`
      : `At first ${who(role).toLowerCase()} does not know the first state: it may be ${listed(initial_belief, "or")}`;
  const told = toldText(sensor.map(([action, to, symbol]) => [`${action} into ${to}`, symbol]));
  return [`${begins}.`, ...(few ? [`${who(role)} is told ${told}.`] : [])];
}
