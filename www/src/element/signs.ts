// Events of use: a playground that has had one of them is at work.

export const signs = ["pointerdown", "keydown", "click", "drop"] as const;
