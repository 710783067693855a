// Signs for problems that a small picture cannot show: towers, a truck, or states with ways between them.
import { html, svg, type TemplateResult } from "lit";
import type { ProblemDocument } from "../problem/types.js";

const signs = {
  towers: svg`<path class="parcel" d="M1 5.2h1.8V7H1zM1 3.2h1.8V5H1zM1 1.2h1.8V3H1zM5.2 5.2H7V7H5.2z"></path>
    <path class="graph" d="M0.4 7.3h7.2"></path>`,
  truck: svg`<path class="dark" d="M0.6 2.2h4v3.2h-4zM4.9 3.1h1.4l1.1 1.2v1.1H4.9z"></path>
    <circle class="goal" cx="2" cy="5.9" r="0.8"></circle><circle class="goal" cx="5.9" cy="5.9" r="0.8"></circle>`,
  graph: svg`<path class="graph" d="M1.5 4L6.5 1.5M1.5 4L6.5 6.5"></path>
    <circle class="dark" cx="1.5" cy="4" r="1"></circle>
    <circle class="goal" cx="6.5" cy="1.5" r="1"></circle><circle class="goal" cx="6.5" cy="6.5" r="1"></circle>`,
};

export const pictogram = (document: ProblemDocument): TemplateResult =>
  html`<svg class="thumbnail" viewBox="0 0 8 8" aria-hidden="true">${signs[signOf(document)]}</svg>`;

/** By the predicates of its domain. */
function signOf(document: ProblemDocument): keyof typeof signs {
  if (document.format !== "pddl") return "graph";
  const text = String(document.domain).toLowerCase();
  if (/\(on\s/.test(text) && /\(on-?table\s/.test(text)) return "towers";
  return /\(at\s/.test(text) && /\(in\s/.test(text) ? "truck" : "graph";
}
