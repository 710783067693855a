// A problem as a very small picture, drawn from its document.
import { html, svg, type TemplateResult } from "lit";
import type {
  BoxPushingDocument,
  Cell,
  DeliveryDocument,
  GridworldDocument,
  ProblemDocument,
  RecyclingRobotDocument,
} from "../problem/types.js";
import { starPath } from "../view/icons.js";
import { pictogram } from "./pictogram.js";

export function thumbnail(document: ProblemDocument): TemplateResult {
  if (document.format === "gridworld") return grid(document);
  if (document.format === "delivery") return delivery(document);
  if (document.format === "box-pushing" || document.format === "recycling-robot") return floor(document);
  return pictogram(document);
}

const square = ([column, row]: Cell) => `M${column} ${row}h1v1h-1z`;

function grid({ width, height, walls = [], start, goals, true_goal, observers }: GridworldDocument): TemplateResult {
  const size = Math.max(width, height);
  const box = `${(width - size) / 2} ${(height - size) / 2} ${size} ${size}`;
  // On a large grid a goal of one cell would be a speck.
  const radius = Math.max(0.42, size / 20);
  const cameras = [...(observers.adversarial.cameras ?? []), ...(observers.cooperative.cameras ?? [])];
  return html`<svg class="thumbnail" viewBox=${box} aria-hidden="true">${svg`
    <rect class="ground" width=${width} height=${height} rx=${size / 24}></rect>
    <path class="watched" d=${cameras.map(square).join("")}></path>
    <path class="dark" d=${walls.map(square).join("")}></path>
    <circle class="dark" cx=${start[0] + 0.5} cy=${start[1] + 0.5} r=${radius * 0.8}></circle>
    ${goals.map(({ name, cell }) => goal(cell, radius, name === true_goal))}`}</svg>`;
}

/** Like a grid, with what the robot moves as a square. */
function floor(document: BoxPushingDocument | RecyclingRobotDocument): TemplateResult {
  const { width, height, walls = [], start, goals, true_goal } = document;
  const size = Math.max(width, height);
  const moved = "box" in start ? start.box : start.can;
  const radius = Math.max(0.42, size / 20);
  return html`<svg class="thumbnail" viewBox="${(width - size) / 2} ${(height - size) / 2} ${size} ${size}" aria-hidden="true">${svg`
    <rect class="ground" width=${width} height=${height} rx=${size / 24}></rect>
    <path class="dark" d=${walls.map(square).join("")}></path>
    <circle class="dark" cx=${start.robot[0] + 0.5} cy=${start.robot[1] + 0.5} r=${radius * 0.8}></circle>
    ${moved === "held" ? "" : svg`<rect class="parcel" x=${moved[0] + 0.15} y=${moved[1] + 0.15} width="0.7" height="0.7" rx="0.1"></rect>`}
    ${goals.map(({ name, cell }) => goal(cell, radius, name === true_goal))}`}</svg>`;
}

const goal = ([column, row]: Cell, radius: number, isTrue: boolean) =>
  isTrue
    ? svg`<path class="star" transform="translate(${column + 0.5} ${row + 0.5}) scale(${radius * 1.5})" d=${starPath}></path>`
    : svg`<circle class="goal" cx=${column + 0.5} cy=${row + 0.5} r=${radius}></circle>`;

/** One column for each factory: its packages on top of its roof; those of the true goal are stars. */
function delivery({ factories, true_goal }: DeliveryDocument): TemplateResult {
  const most = Math.max(1, ...factories.map(({ packages }) => packages.length));
  const size = Math.max(factories.length * 3, most * 2 + 2, 6);
  const chosen = new Set(true_goal.split("+"));
  const left = (size - factories.length * 3) / 2;
  return html`<svg class="thumbnail" viewBox="0 0 ${size} ${size}" aria-hidden="true">${svg`
    <rect class="ground" width=${size} height=${size} rx=${size / 24}></rect>
    ${factories.map(({ packages }, column) => {
      const x = left + column * 3 + 0.5;
      return svg`<rect class="dark" x=${x} y=${size - 2} width="2" height="2"></rect>
        ${packages.map((name, row) =>
          chosen.has(name)
            ? svg`<path class="star" transform="translate(${x + 1} ${size - 3 - row * 2}) scale(0.95)" d=${starPath}></path>`
            : svg`<circle class="goal" cx=${x + 1} cy=${size - 3 - row * 2} r="0.7"></circle>`,
        )}`;
    })}
  `}</svg>`;
}
