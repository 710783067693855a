// The two marks of a goal on the agent's board: a diamond for the enemy, a disc for the friend, filled while the goal is
// possible for them, struck through when it is ruled out. And the same in words.
import { nothing, svg } from "lit";
import { named } from "../view/names.js";
import type { GoalView, Standing } from "./goal-attributes.js";

/** How a goal or its mark looks, by what an observer holds of it. */
export const looks: Record<Standing, string> = { possible: "alive", "not now": "open", "ruled out": "dead" };

const filled: Record<Standing, string> = { possible: "on", "not now": "off", "ruled out": "off out" };

const strike = (standing: Standing, x: number) =>
  standing === "ruled out"
    ? svg`<line class="strike" x1=${x - 0.13} y1="0.42" x2=${x + 0.13} y2="0.16"></line>`
    : nothing;

/** `apart`: how far the marks stand from the middle. */
export const marks = ({ standing, attributes }: GoalView, apart: number) =>
  attributes.adversarial === nothing
    ? nothing
    : svg`
  <path class="mark enemy ${filled[standing.adversarial]}" transform="translate(${-apart} 0.29)"
    d="M0 -0.14l0.14 0.14l-0.14 0.14l-0.14-0.14z"></path>${strike(standing.adversarial, -apart)}
  ${
    attributes.cooperative === nothing
      ? nothing
      : svg`<circle class="mark friend ${filled[standing.cooperative]}" cx=${apart} cy="0.29" r="0.115"></circle>${strike(standing.cooperative, apart)}`
  }`;

/** The name of a goal, and what is held of it where that is told. */
export function goalTold(goal: GoalView): string {
  const words = goalInWords(goal);
  return `${named(goal.name)}${goal.isTrue ? " (true goal)" : ""}${words === "" ? "" : `: ${words}`}`;
}

/** Empty where it is not told. */
export function goalInWords({ standing: { adversarial, cooperative }, attributes }: GoalView): string {
  if (attributes.adversarial === nothing) return "";
  if (attributes.cooperative === nothing) return `${adversarial} for the enemy`;
  if (adversarial === cooperative) return `${adversarial} for both`;
  return `${adversarial} for the enemy, ${cooperative} for the friend`;
}
