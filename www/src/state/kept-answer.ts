// What is kept of the answers to an exercise: by a link, by a course system, and while another name's question is shown.
import type { Question } from "../core.js";

/** An answer that was checked. What it is worth is never kept: the core says it again. */
export interface CheckedAnswer {
  choices: number[];
  attempts: number;
  hints: number;
}

/** What was tried of one question. */
export interface Tries {
  choices: number[];
  attempts: number;
  hints: number;
  /** The answer that was checked last: others may have been begun since. */
  checked?: CheckedAnswer;
}

export interface KeptAnswer extends Tries {
  /** The name that was given, where one was asked for; empty where the question without one was wanted. */
  name?: string;
  /** What was tried of the questions of other names, by their seeds. */
  others?: (Tries & { seed: number })[];
}

const LONGEST_ANSWER = 1000;
const LONGEST_NAME = 200;
const MOST_OTHERS = 100;
/** What a code can hold. */
const MOST_TRIES = 1_000_000;

/** Reads a kept answer; null where it has another shape. */
export function readAnswer(value: unknown): KeptAnswer | null {
  const tries = readTries(value);
  if (tries === null) return null;
  const { name, others } = value as Record<string, unknown>;
  const read = Array.isArray(others) ? others.slice(0, MOST_OTHERS).flatMap(readOther) : [];
  return {
    ...tries,
    ...(typeof name === "string" && name.length <= LONGEST_NAME ? { name } : {}),
    ...(read.length === 0 ? {} : { others: read }),
  };
}

function readOther(value: unknown): (Tries & { seed: number })[] {
  const tries = readTries(value);
  const seed = (value as { seed?: unknown } | null)?.seed;
  return tries === null || !isCount(seed) ? [] : [{ seed, ...tries }];
}

function readTries(value: unknown): Tries | null {
  const answer = readChecked(value);
  if (answer === null) return null;
  const { checked } = value as { checked?: unknown };
  if (checked === undefined) return answer;
  // A state of before held what the answer was worth, and not which it was: that of the page it is then.
  const judged = readChecked(checked) ?? answer;
  return { ...answer, attempts: Math.max(answer.attempts, judged.attempts), checked: judged };
}

function readChecked(value: unknown): CheckedAnswer | null {
  if (typeof value !== "object" || value === null) return null;
  const { choices, attempts, hints } = value as Record<string, unknown>;
  const fit = Array.isArray(choices) && choices.length <= LONGEST_ANSWER && choices.every(isCount);
  return fit && isCount(attempts) && isCount(hints)
    ? { choices, attempts: Math.min(attempts, MOST_TRIES), hints: Math.min(hints, MOST_TRIES) }
    : null;
}

const isCount = (value: unknown): value is number => Number.isSafeInteger(value) && Number(value) >= 0;

/** Of choices that were kept, those that an answer to a question can be made of. */
export function fitting(choices: readonly number[], { arity, choices: offered }: Question["form"]): number[] {
  const known = choices.filter((choice) => choice < offered.length);
  if (arity === "sequence") return known;
  const different = [...new Set(known)];
  return arity === "one" ? different.slice(0, 1) : different;
}
