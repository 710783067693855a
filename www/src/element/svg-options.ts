// What a page's script asks of a picture, in its own words, and what the core is asked then.
import type { PictureOptions } from "../core.js";
import type { Scheme } from "./theme.js";

/** Without any: all boards of the step shown, with captions, in the playground's own colours. */
export interface SvgOptions extends Omit<PictureOptions, "animate"> {
  /** All steps of what is shown, one after another, without end. */
  walk?: boolean;
}

/** A page's script may hand over anything: what is no plain data stays behind, and the core says what does not fit. */
export function pictureOptions({ walk, ...options }: SvgOptions, theme: Scheme): PictureOptions {
  return JSON.parse(JSON.stringify({ theme, ...options, animate: walk }));
}
