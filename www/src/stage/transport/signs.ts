// Small signs of what moves: a truck, an airplane, a driver, a package.
import { html, svg, type TemplateResult } from "lit";
import type { Sign } from "./world.js";

const shapes = {
  truck: svg`<path d="M1 4h8.5v6.5H1zM10.2 6h2.6l2.2 2.4v2.1h-4.8z"></path><circle cx="4" cy="11.6" r="1.5"></circle><circle cx="12" cy="11.6" r="1.5"></circle>`,
  plane: svg`<path d="M15 8c0-.8-1-1.2-2-1.2H9.6L6.4 1.6H4.9l1.5 5.2H3.2L2 5.2H.9L1.7 8l-.8 2.8H2l1.2-1.6h3.2l-1.5 5.2h1.5l3.2-5.2H13c1 0 2-.4 2-1.2z"></path>`,
  driver: svg`<circle cx="8" cy="4.6" r="2.9"></circle><path d="M2.6 14.5c0-3.6 2.2-5.6 5.4-5.6s5.4 2 5.4 5.6z"></path>`,
  package: svg`<path class="parcel" d="M2 4h12v9.5H2z"></path><path class="tape" d="M8 4v9.5M2 7h12"></path>`,
};

export const signOfThing = (sign: Sign): TemplateResult =>
  html`<svg class="icon thing ${sign}" viewBox="0 0 16 16" aria-hidden="true">${shapes[sign]}</svg>`;
