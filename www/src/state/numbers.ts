// The numbers that are asked of a solver: which can be chosen in the scene shown, and where one begins.
import { signal } from "@preact/signals-core";
import type { Scene } from "../core.js";
import type { Form } from "./form.js";

export type NumberName = "k" | "j" | "horizon" | "horizonStep";

export interface Range {
  least: number;
  most: number;
  /** What a step up or down from nothing leads to. */
  first: number;
}

/** The core takes more moves; no plan that a person would ask for here has so many. */
const MOST_MOVES = 1000;

/** `moves` is the length of the plan shown. */
export function range(name: NumberName, scene: Scene, moves: number): Range {
  const goals = scene.goals.length;
  switch (name) {
    case "k":
      return { least: 1, most: goals, first: Math.min(2, goals) };
    case "j":
      return { least: 1, most: goals, first: goals - 1 };
    case "horizon":
      return { least: 0, most: MOST_MOVES, first: moves };
    case "horizonStep":
      return { least: 1, most: 100, first: 2 };
  }
}

/** The number that a text says, or nothing where it says none in the range. */
export function numberIn(text: string, { least, most }: Range): number | undefined {
  if (!/^\s*\d{1,6}\s*$/.test(text)) return undefined;
  const value = Number(text);
  return value >= least && value <= most ? value : undefined;
}

/**
 * What a step up or down leads to: "" leaves the number open; nothing where there is no such step. Without a bound, k
 * asks for less than any number and j for more.
 */
export function stepped(
  name: NumberName,
  value: number | null,
  change: 1 | -1,
  { least, most, first }: Range,
): number | "" | undefined {
  const open = { k: -1, j: 1, horizon: 0, horizonStep: -1 }[name];
  if (value === null) return change === open ? undefined : first;
  const next = value + change;
  if (next >= least && next <= most) return next;
  return change === open ? "" : undefined;
}

/** The bounds that no longer fit a scene with fewer goals, brought back into its range; nothing where all fit. */
export function fitted(form: Form, scene: Scene): Partial<Form> | null {
  const goals = scene.goals.length;
  const change: Partial<Form> = {};
  if (Number(form.k) > goals) change.k = String(goals);
  if (Number(form.j) > goals) change.j = "";
  return Object.keys(change).length === 0 ? null : change;
}

/** What stands in the fields while it can't be used: a field is not emptied under somebody's fingers. */
export class Drafts {
  readonly texts = signal<{ [name in NumberName]?: string }>({});

  keep(name: NumberName, text: string): void {
    this.texts.value = { ...this.texts.value, [name]: text };
  }

  drop(name: NumberName): void {
    if (this.texts.value[name] === undefined) return;
    const { [name]: _, ...others } = this.texts.value;
    this.texts.value = others;
  }
}
