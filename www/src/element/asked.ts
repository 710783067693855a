// How often a page asked for another problem, or for another answer, by properties and attributes: a question that waits
// is about what was asked for before it.

/** Why a question has no answer of its own. */
export const OVERTAKEN = "Another question took the place of this one before it was answered.";
export const CHANGED = "The problem was changed before this question was answered.";

export interface Asked {
  problems: number;
  questions: number;
}

/** Attributes that say which problem is open. */
const ofProblem: readonly string[] = ["src", "problem", "exercise", "seed", "student"];

/** Attributes that say how it is solved. */
const ofQuestion: readonly string[] = ["solver", "k", "j", "horizon"];

/** The page has set an attribute, or taken it away. */
export function count(asked: Asked, attribute: string): void {
  if (ofProblem.includes(attribute)) asked.problems += 1;
  if (ofQuestion.includes(attribute)) asked.questions += 1;
}

/** What took the place of the question that came after `before`; null where nothing did. */
export function overtakenBy(before: Asked, now: Asked): string | null {
  if (now.problems !== before.problems) return CHANGED;
  if (now.questions !== before.questions) return OVERTAKEN;
  return null;
}
