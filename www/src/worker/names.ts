// What workers are known by.

/** Shown by the browser's tools. */
export const NAME = "mo-copp solver";

/** The first word of a worker: the element works with the worker of its own version alone. */
export const VERSION = "0.1.0";
