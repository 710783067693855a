// The problem of a question in words: what the picture shows, and what the observers are told of each action.
import { html, type TemplateResult } from "lit";
import type { Question } from "../core.js";
import { cellText } from "../problem/cells.js";
import { called } from "../view/observers.js";

interface Grid {
  width: number;
  height: number;
  walls?: number[][];
  start: unknown;
  goals: { name: string; cell: number[] }[];
  true_goal: string;
  observers: Record<"adversarial" | "cooperative", Watcher>;
}

interface Watcher {
  initial_belief?: unknown[];
  cameras?: number[][];
  sensor: Record<string, string>;
}

export function problemInWords({ document, kind }: Question): TemplateResult {
  const isGrid = (document as { format?: string }).format === "gridworld";
  return html`<details><summary>The problem in words</summary>${
    isGrid ? gridInWords(document as Grid, kind) : inJson(document, kind)
  }</details>`;
}

const cells = (list: readonly number[][]): string => list.map(cellText).join("; ");

function gridInWords(grid: Grid, kind: string): TemplateResult {
  const { width, height, walls = [], start, goals, true_goal, observers } = grid;
  return html`<ul>
    <li>${width} columns from the left, ${height} rows from the top, both counted from 0.</li>
    ${walls.length === 0 ? "" : html`<li>Walls: ${cells(walls)}.</li>`}
    <li>Start: ${cellText(start as number[])}.</li>
    <li>Goals: ${goals.map(({ name, cell }) => `${name} at ${cellText(cell)}`).join("; ")}.</li>
    ${kind === "guess" ? "" : html`<li>The true goal: ${true_goal}.</li>`}
    ${(["adversarial", "cooperative"] as const).map((role) => html`<li>${watcherText(role, observers[role])}</li>`)}
  </ul>`;
}

function watcherText(role: "adversarial" | "cooperative", { sensor, cameras = [], initial_belief }: Watcher): string {
  const told = Object.entries(sensor).map(([action, symbol]) => `“${symbol}” for ${action}`);
  const who = `The ${called[role]}`;
  const watched =
    cameras.length === 0 ? "" : ` Its cameras: ${cells(cameras)}; there it is told the very cell instead.`;
  const begins =
    initial_belief === undefined
      ? "knows the start"
      : `believes at first that the start is one of: ${cells(initial_belief as number[][])}`;
  return `${who} ${begins}. It is told ${told.join(", ")}.${watched}`;
}

function inJson(document: object, kind: string): TemplateResult {
  const { true_goal, ...rest } = document as { true_goal?: string };
  const shown = kind === "guess" ? rest : { ...rest, true_goal };
  return html`<pre tabindex="0">${JSON.stringify(shown, null, 2)}</pre>`;
}
