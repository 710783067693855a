// A grid of cells to choose from, walked through by the arrow keys.
import { html, nothing, type TemplateResult } from "lit";
import type { Question, State } from "../core.js";
import { cellText } from "../problem/cells.js";
import { times } from "../problem/times.js";
import type { Exercise } from "../state/exercise.js";
import { type Floor, floorOf, signs } from "./floor.js";

type Cell = [column: number, row: number];

export const isCell = (state: State): state is Cell =>
  Array.isArray(state) && state.length === 2 && typeof state[0] === "number";

const legends = {
  camera: "The cell of the camera",
  wall: "The cell of the wall",
  start: "The cell of the start",
  state: "Cells where the agent can be",
};

/** By how much each key goes on, in columns and rows. */
const ways: Record<string, Cell> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export function cellGrid(exercise: Exercise, question: Question): TemplateResult {
  const cells = question.form.choices as Cell[];
  const floor = floorOf(question.document);
  const width = floor?.width ?? Math.max(...cells.map(([column]) => column)) + 1;
  const height = floor?.height ?? Math.max(...cells.map(([, row]) => row)) + 1;
  const at = new Map(cells.map((cell, index) => [String(cell), index]));
  const rows = times(height, (row) => row);
  const columns = times(width, (column) => column);
  return html`<fieldset class="choices">
    <legend>${legends[question.place ?? "state"]}</legend>
    <div class="cells" .style=${`grid-template-columns: 1.6rem repeat(${width}, minmax(1.6rem, 1fr))`} role="group"
      aria-label=${legends[question.place ?? "state"]} @keydown=${keys(exercise, at, cells)}>
      ${edge("")} ${columns.map(edge)}
      ${rows.map((row) => [edge(row), ...columns.map((column) => cellButton(exercise, [column, row], at, floor?.marks.get(`${column},${row}`) ?? []))])}
    </div>
    ${meaning(floor)}
  </fieldset>`;
}

/** What the signs in the cells mean; goals have their names. */
function meaning(floor: Floor | null): TemplateResult | typeof nothing {
  const words = new Map([...(floor?.marks.values() ?? [])].flat().map(({ sign, word }) => [sign, word]));
  const meant = Object.values(signs).flatMap((sign) => (words.has(sign) ? [`${sign} ${words.get(sign)}`] : []));
  return meant.length === 0 ? nothing : html`<p class="signs" aria-hidden="true">${meant.join(" · ")}</p>`;
}

/** A column's or a row's number, as cells are named in what is said of an answer; each cell's own name has both. */
const edge = (number: number | ""): TemplateResult => html`<span class="edge" aria-hidden="true">${number}</span>`;

function cellButton(
  exercise: Exercise,
  cell: Cell,
  at: ReadonlyMap<string, number>,
  marks: readonly { sign: string; word: string }[],
): TemplateResult {
  const index = at.get(String(cell));
  const sign = marks.map((mark) => mark.sign).join(" ");
  const isWall = marks.some(({ word }) => word === "wall");
  if (index === undefined)
    return html`<span class=${isWall ? "cell wall" : "cell"} aria-hidden="true">${isWall ? "" : sign}</span>`;
  const name = [cellText(cell), ...marks.map(({ word }) => word)].join(", ");
  return html`<button type="button" class=${isWall ? "cell wall" : "cell"} data-choice=${String(cell)} aria-label=${name}
    aria-pressed=${String(exercise.choices.value.includes(index))} tabindex=${exercise.cursor.value === index ? 0 : -1}
    @focus=${() => {
      exercise.cursor.value = index;
    }} @click=${() => exercise.choose(index)}>${sign}</button>`;
}

function keys(exercise: Exercise, at: ReadonlyMap<string, number>, cells: readonly Cell[]) {
  return (event: KeyboardEvent) => {
    const way = ways[event.key];
    let cell = cells[exercise.cursor.value];
    if (way === undefined || cell === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const group = event.currentTarget as HTMLElement;
    // Past cells that are no choice.
    for (let steps = 0; steps < 64; steps += 1) {
      cell = [cell[0] + way[0], cell[1] + way[1]];
      if (!at.has(String(cell))) continue;
      group.querySelector<HTMLElement>(`[data-choice="${cell}"]`)?.focus();
      return;
    }
  };
}
