// The two marks of a goal on the agent's board: a diamond for the enemy, a disc for the friend, filled while the goal is
// possible for them. And the same in words.
import { nothing, svg } from "lit";
import type { GoalView } from "./goal-attributes.js";

/** `apart`: how far the marks stand from the middle. */
export const marks = ({ alive, attributes }: GoalView, apart: number) => svg`
  <path class="mark enemy ${alive.adversarial ? "on" : "off"}" transform="translate(${-apart} 0.29)"
    d="M0 -0.14l0.14 0.14l-0.14 0.14l-0.14-0.14z"></path>
  ${
    attributes.cooperative === nothing
      ? nothing
      : svg`<circle class="mark friend ${alive.cooperative ? "on" : "off"}" cx=${apart} cy="0.29" r="0.115"></circle>`
  }`;

export function goalInWords({ alive, attributes }: GoalView): string {
  if (attributes.cooperative === nothing)
    return alive.adversarial ? "possible for the enemy" : "ruled out by the enemy";
  if (alive.adversarial && alive.cooperative) return "possible for both";
  if (alive.adversarial) return "possible for the enemy only";
  if (alive.cooperative) return "possible for the friend only";
  return "ruled out by both";
}
