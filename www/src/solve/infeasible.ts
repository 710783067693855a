// Why there is no plan, and the nearest changes that allow one.
import { html, nothing, type TemplateResult } from "lit";
import type { Advice } from "../core.js";
import type { Adviser } from "../state/adviser.js";
import type { Result } from "../state/answer.js";
import type { Solving } from "../state/solving.js";
import { counted, differenceText } from "../view/numbers.js";

export interface InfeasibleStores {
  adviser: Adviser;
  solving: Solving;
}

type Remedy = Advice["remedies"][number];

export function infeasible(playground: InfeasibleStores, result: Result): TemplateResult {
  const advice = playground.adviser.advice.value;
  const remedies = advice?.remedies ?? [];
  return html`<div class="why" role="status">
    <p>${advice === null ? asked(result) : reason(result, advice)}</p>
    ${
      remedies.length === 0
        ? advice?.reason === "bounds" && advice.complete
          ? html`<p>No change of one of these numbers alone would do.</p>`
          : nothing
        : html`<p>What would do${advice?.complete ? "" : ", as far as was looked"}:</p>
            <ul class="remedies">${remedies.map(
              (remedy) => html`<li>
                <button type="button" @click=${() => playground.solving.edit({ [remedy.change]: String(remedy.value) })}>
                  ${offer(remedy, result)}</button>
                <small>goal difference up to ${differenceText(remedy.goal_difference)}</small></li>`,
            )}</ul>`
    }
  </div>`;
}

function reason(result: Result, { reason: why, shortest }: Advice): string {
  const { horizon } = result.options;
  if (why === "unreachable") return "The true goal cannot be reached from the start, however long the plan.";
  if (why === "length" && typeof horizon === "number" && shortest !== null) {
    return horizon < shortest
      ? `The true goal is ${counted(shortest, "move")} away: no plan is shorter.`
      : `Plans reach the true goal, the shortest in ${counted(shortest, "move")}, but none in exactly ${horizon}.`;
  }
  return asked(result);
}

/** What was asked for and cannot be had. */
function asked({ options: { horizon, k, j } }: Result): string {
  const length = typeof horizon === "number" ? `No plan of exactly ${counted(horizon, "move")}` : "No plan";
  const wishes = [
    ...(k === undefined ? [] : [`keeps at least ${counted(k, "goal")} possible for the enemy`]),
    ...(j === undefined ? [] : [`leaves at most ${counted(j, "goal")} to the friend`]),
  ];
  return `${length} reaches the true goal${wishes.length === 0 ? "" : ` and ${wishes.join(" and ")}`}: that is proved.`;
}

function offer({ change, value }: Remedy, { options }: Result): string {
  switch (change) {
    case "horizon":
      return `${value > Number(options.horizon) ? "A longer plan" : "A shorter plan"}: ${counted(value, "move")}`;
    case "k":
      return `A smaller k: ${counted(value, "goal")} for the enemy`;
    case "j":
      return `A larger j: ${counted(value, "goal")} for the friend`;
  }
}
