// What a question keeps of its problem while that is open without it: the parts that stay as they are, and the beliefs that
// are not shown until it is answered.

/** Kinds whose answer is a walk: what it does to the observers is shown, unless the exercise hides it. */
const walks: readonly unknown[] = ["walk", "best"];

/** Whether the exercise of a document hides what observers believe. */
export function hidesBeliefs(text: string): boolean {
  const block = blockOf(text);
  if (block === null) return false;
  return Array.isArray(block.hide) ? block.hide.includes("beliefs") : !walks.includes(block.kind);
}

/** Whether the exercise of a document asks for the true goal: its problem has a stand-in for it until it is found. */
export const asksGoal = (text: string): boolean => blockOf(text)?.kind === "guess";

/** The exercise of a document; null where there is none. */
function blockOf(text: string): { kind?: unknown; hide?: unknown } | null {
  try {
    const { exercise } = JSON.parse(text);
    return typeof exercise === "object" ? exercise : null;
  } catch {
    return null;
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
