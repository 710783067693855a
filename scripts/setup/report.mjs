// One line for each thing that set-up looks at, and the error it stops with.

export function say(thing, what) {
  console.log(`  ${thing.padEnd(14)} ${what}`);
}

/** Something is missing that set-up can't get by itself; `remedy` is what the person can type. */
export class SetupError extends Error {
  constructor(problem, remedy) {
    super(problem);
    this.name = "SetupError";
    this.remedy = remedy;
  }
}
