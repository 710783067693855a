// The shapes of what a page may say to a frame. Everything else is null: a page says many things to its frames.

/** Larger than any problem that can be drawn. */
const LARGEST = 2_000_000;

export type Command =
  | { command: "step"; step: number }
  | { command: "theme"; theme: "light" | "dark" | "auto" }
  | { command: "document"; document: string | object }
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
    const fits = typeof document === "string" ? document.length <= LARGEST : isObject(document);
    return fits ? { command, document: document as string | object } : null;
  }
  return command === "state" && isObject(state) ? { command, state } : null;
}

/** What a course system kept of the last time: the answer to `SPLICE.getState`. */
export const isSpliceState = (data: Record<string, unknown>): data is { state: object } =>
  data.subject === "SPLICE.getState.response" && isObject(data.state);
