// What a page's script has a playground do: go to a step, solve, draw. Each says in a sentence what can't be used.
import type { Playground } from "../playground/playground.js";
import { optionsOf } from "../state/form.js";
import { fitted } from "../state/numbers.js";
import { CLOSED } from "../state/solving.js";
import type { Answered } from "../worker/protocol.js";
import { changeOf, type ElementSolveOptions } from "./solve-options.js";
import { type PngOptions, pictureOptions, type SvgOptions } from "./svg-options.js";
import type { Scheme } from "./theme.js";

/** A script may hand over anything. */
export function goTo({ timeline }: Playground, step: unknown): void {
  const wanted = Number(String(step).trim() || Number.NaN);
  if (Number.isNaN(wanted) || (Number.isFinite(wanted) && !Number.isInteger(wanted)))
    throw new Error(`“${step}” is no step; expected a whole number from 0 to ${timeline.lastStep.value}.`);
  timeline.goTo(wanted);
}

/** Options that can't be used leave the form as it was: the next ones are asked for on their own. */
export async function solve(playground: Playground, options: ElementSolveOptions): Promise<Answered> {
  const { answer, form, problem, solving } = playground;
  if (problem.newest?.closed) throw new Error(CLOSED);
  const before = form.value;
  const change = changeOf(options);
  const asked = optionsOf({ ...before, ...change });
  if (typeof asked === "string") throw new Error(asked);
  const scene = problem.scene.value;
  const misfit = `These options do not fit the problem: k and j go from 1 to ${scene?.goals.length}.`;
  if (scene !== null && fitted({ ...before, ...change }, scene) !== null) throw new Error(misfit);
  solving.edit(change);
  const now = form.value;
  await solving.solve();
  const { error, result } = answer;
  if (error.value !== null) {
    if (form.value === now) form.value = before;
    throw new Error(error.value);
  }
  const { options: answered, outcome } = result.value ?? {};
  if (outcome === undefined) throw new Error("Something else was asked for meanwhile.");
  if (JSON.stringify(answered) !== JSON.stringify(asked)) throw new Error(misfit);
  return outcome;
}

/** `scheme`: the colours, where the options name none. */
export function toSVG({ pictures }: Playground, options: SvgOptions, scheme: Scheme): Promise<string> {
  return pictures.draw(pictureOptions(options, scheme));
}

export async function toPNG(playground: Playground, options: PngOptions, scheme: Scheme): Promise<Blob> {
  const asked = pictureOptions(options, scheme);
  if (asked.animate) throw new Error("A PNG shows one step; expected no walk. All steps are for toSVG.");
  const [{ png }, svg] = await Promise.all([import("../share/png.js"), playground.pictures.draw(asked)]);
  return png(svg);
}
