// The step, said once in words for those who do not see the boards.
import { html, type TemplateResult } from "lit";
import type { Playground } from "../state/playground.js";
import { called, type Role } from "./observers.js";

export function announcement(playground: Playground): TemplateResult {
  return html`<p class="unseen" aria-live="polite">${sentence(playground)}</p>`;
}

function sentence(playground: Playground): string {
  const scene = playground.scene.value;
  const shown = playground.shown.value;
  if (scene === null || shown === null) return "";
  const part = (role: Role) => {
    const names = shown.goals[role];
    const said = names.length === 0 ? "none" : names.join(", ");
    return `For the ${called[role]} ${names.length} of ${scene.goals.length} goals possible: ${said}.`;
  };
  const move = shown.action === null ? "at the start" : shown.action;
  const where = `Step ${playground.step.value} of ${playground.lastStep.value}: ${move}.`;
  return `${where} ${part("adversarial")} ${part("cooperative")}`;
}
