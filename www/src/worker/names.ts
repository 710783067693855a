// The name of a worker that is given the core by the page; every other fetches it by itself.
export const WAITING = "mo-copp solver, waiting for the core";
