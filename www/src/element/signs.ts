// Events that tell that somebody is at work in the playground.

export const signs = ["pointerdown", "keydown", "click", "drop"] as const;
