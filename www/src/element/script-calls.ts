// What a page's script has a playground do: go to a step, solve, draw. Each says in a sentence what can't be used.
import type { Playground } from "../playground/playground.js";
import { optionsOf } from "../state/form.js";
import { fitted } from "../state/numbers.js";
import { CLOSED } from "../state/solving.js";
import type { Answered } from "../worker/protocol.js";
import { CHANGED, OVERTAKEN } from "./asked.js";
import { changeOf, type ElementSolveOptions } from "./solve-options.js";
import { type PngOptions, pictureOptions, type SvgOptions } from "./svg-options.js";
import type { Scheme } from "./theme.js";

/** Why a playground that shows a question does nothing else: the problem that was open before it is out of sight. */
const ASKED =
  "A question is shown, without steps, solvers and best values: only where its lock allows, its problem is opened without it.";

function withoutQuestion({ exercise }: Playground): void {
  if (exercise.posed.value !== null) throw new Error(ASKED);
}

/** A script may hand over anything. */
export function goTo(playground: Playground, step: unknown): void {
  withoutQuestion(playground);
  const { timeline } = playground;
  const wanted = Number(String(step).trim() || Number.NaN);
  if (Number.isNaN(wanted) || (Number.isFinite(wanted) && !Number.isInteger(wanted)) || wanted < 0)
    throw new Error(`“${step}” is no step; expected a whole number from 0 to ${timeline.lastStep.value}.`);
  timeline.goTo(wanted);
}

/** Options that can't be used leave the form as it was: the next ones are asked for on their own. */
export async function solve(playground: Playground, options: ElementSolveOptions): Promise<Answered> {
  withoutQuestion(playground);
  const { answer, form, problem, solving } = playground;
  const asked = problem.newest;
  if (asked?.closed) throw new Error(CLOSED);
  const before = form.value;
  const change = changeOf(options);
  const wanted = optionsOf({ ...before, ...change });
  if (typeof wanted === "string") throw new Error(wanted);
  const scene = problem.scene.value;
  const misfit = `These options do not fit the problem: k and j go from 1 to ${scene?.goals.length}.`;
  if (scene !== null && fitted({ ...before, ...change }, scene) !== null) throw new Error(misfit);
  solving.edit(change);
  const now = form.value;
  const ending = await solving.solve();
  if (ending?.kind === "solved") return ending.outcome;
  if (ending?.kind === "stale") throw new Error(problem.newest === asked ? OVERTAKEN : CHANGED);
  const { value: error } = answer.error;
  if (error === null) throw new Error(misfit);
  if (form.value === now) form.value = before;
  throw new Error(error);
}

/** `scheme`: the colours, where the options name none. */
export async function toSVG(playground: Playground, options: SvgOptions, scheme: Scheme): Promise<string> {
  withoutQuestion(playground);
  return playground.pictures.draw(pictureOptions(options, scheme));
}

export async function toPNG(playground: Playground, options: PngOptions, scheme: Scheme): Promise<Blob> {
  withoutQuestion(playground);
  const asked = pictureOptions(options, scheme);
  if (asked.animate) throw new Error("A PNG shows one step; expected no walk. All steps are for toSVG.");
  const [{ png }, svg] = await Promise.all([import("../share/png.js"), playground.pictures.draw(asked)]);
  return png(svg);
}
