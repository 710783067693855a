// The attributes of the element that are followed live. No code but their names: the element's script stays small.
import type { settingNames } from "./settings.js";

type Setting = (typeof settingNames)[number];

const settings: Record<Setting, true> = {
  src: true,
  problem: true,
  plan: true,
  step: true,
  solver: true,
  k: true,
  j: true,
  horizon: true,
};

/** How the playground behaves in its page. */
const manners = ["hide", "link", "theme", "keys"] as const;

/** What an exercise is asked with. */
const questions = ["exercise", "seed", "student"] as const;

export const followed: readonly string[] = [...Object.keys(settings), ...manners, ...questions];
