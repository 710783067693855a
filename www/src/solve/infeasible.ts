// Why there is no plan.
import { html, type TemplateResult } from "lit";
import type { Playground, Result } from "../state/playground.js";
import { counted } from "../view/numbers.js";

export function infeasible(_playground: Playground, { options }: Result): TemplateResult {
  const { horizon, k, j } = options;
  const length = typeof horizon === "number" ? `No plan of exactly ${counted(horizon, "move")}` : "No plan";
  const wishes = [
    ...(k === undefined ? [] : [`keeps at least ${counted(k, "goal")} possible for the enemy`]),
    ...(j === undefined ? [] : [`leaves at most ${counted(j, "goal")} to the friend`]),
  ];
  return html`<p>It is proved: ${length} reaches the true goal${wishes.length === 0 ? "" : ` and ${wishes.join(" and ")}`}.</p>`;
}
