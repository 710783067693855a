// The shapes of what a page may say to a frame. Everything else is null: a page says many things to its frames.

/** Larger than any problem that can be drawn. */
const LARGEST = 2_000_000;

export type Command =
  | { command: "step"; step: number }
  | { command: "theme"; theme: "light" | "dark" | "auto" }
  | { command: "document"; document: string }
  | { command: "state"; state: object };

export const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

export function readCommand(data: Record<string, unknown>, type: string, version: number): Command | null {
  if (data.type !== type || data.version !== version) return null;
  const { command, step, theme, document, state } = data;
  if (command === "step") {
    return typeof step === "number" && Number.isInteger(step) && step >= 0 ? { command, step } : null;
  }
  if (command === "theme") return theme === "light" || theme === "dark" || theme === "auto" ? { command, theme } : null;
  if (command === "document") {
    const text = typeof document === "string" ? document : written(document);
    return isDocument(text) && text.length <= LARGEST ? { command, document: text } : null;
  }
  return command === "state" && isState(state) ? { command, state } : null;
}

/** What a course system kept of the last time: the answer to the `SPLICE.getState` of this `message_id`. A first visit's may be empty. */
export function isSpliceState(data: Record<string, unknown>, asked: string): data is { state: object } {
  const { subject, message_id = asked, state } = data;
  return subject === "SPLICE.getState.response" && message_id === asked && isState(state);
}

const isState = (value: unknown): value is object =>
  isObject(value) && written(value) !== null && isDocument(value.document);

/** A problem document's text; whether the problem is right the core says. */
function isDocument(text: unknown): text is string {
  if (typeof text !== "string") return false;
  try {
    const value: unknown = JSON.parse(text);
    return isObject(value) && typeof value.format === "string";
  } catch {
    return false;
  }
}

/** Messages may hold what no JSON does. */
function written(value: unknown): string | null {
  try {
    return JSON.stringify(value) ?? null;
  } catch {
    return null;
  }
}
