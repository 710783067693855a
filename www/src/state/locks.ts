// What a question keeps of its problem while that is open without it: the parts that stay as they are, and the beliefs that
// are not shown until it is answered.

/** Kinds whose answer is a walk: what it does to the observers is shown, unless the exercise hides it. */
const walks: readonly unknown[] = ["walk", "best"];

/** Whether the exercise of a document hides what observers believe. */
export function hidesBeliefs(text: string): boolean {
  try {
    const { kind, hide } = JSON.parse(text).exercise;
    return Array.isArray(hide) ? hide.includes("beliefs") : !walks.includes(kind);
  } catch {
    return false;
  }
}

/** Whether the exercise of a document asks for the true goal: its problem has a stand-in for it until it is found. */
export function asksGoal(text: string): boolean {
  try {
    return JSON.parse(text).exercise.kind === "guess";
  } catch {
    return false;
  }
}

/** How a part of a document is called. */
export const partName = (key: string): string => key.replaceAll("_", " ");

/** Why a part stays as it is. */
export const lockedText = (keys: readonly string[]): string => {
  const names = keys.map(partName);
  const last = names.pop() ?? "";
  const all = names.length === 0 ? last : `${names.join(", ")} and ${last}`;
  const several = names.length > 0 || last.endsWith("s");
  return `Locked by the exercise: ${all} ${several ? "stay as they are" : "stays as it is"}.`;
};
