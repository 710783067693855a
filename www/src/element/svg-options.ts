// What a page's script asks of a picture, in its own words, and what the core is asked then.
import type { PictureOptions } from "../core.js";
import type { Scheme } from "./theme.js";

/** Without any: all boards of the step shown, with captions, in the playground's own colours. */
export interface SvgOptions extends Omit<PictureOptions, "animate"> {
  /** All steps of what is shown, one after another, without end, each for `milliseconds`. */
  walk?: boolean;
}

/** A PNG shows one step. */
export type PngOptions = Omit<SvgOptions, "walk" | "milliseconds">;

const known: Record<keyof SvgOptions, true> = {
  ...{ step: true, walk: true, milliseconds: true, board: true, captions: true },
  ...{ theme: true, true_goal: true, ended: true, numbers: true },
};

/** A page's script may hand over anything: what is no plain data stays behind, and the core says what does not fit. */
export function pictureOptions(options: SvgOptions, theme: Scheme): PictureOptions {
  if (typeof options !== "object" || options === null || Array.isArray(options))
    throw new Error(`“${options}” can’t be used as options; expected an object, as { walk: true }.`);
  const { walk, ...others } = options;
  const unknown = Object.entries(others).find(([name, value]) => value !== undefined && !Object.hasOwn(known, name));
  if (unknown !== undefined)
    throw new Error(`“${unknown[0]}” is no option of a picture; expected ${Object.keys(known).join(", ")}.`);
  if (walk !== undefined && typeof walk !== "boolean")
    throw new Error(`“${walk}” can’t be used for walk; expected true or false.`);
  return JSON.parse(JSON.stringify({ theme, ...others, animate: walk }));
}
