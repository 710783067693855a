// Texts that a page's script gave.

/** What a text says as JSON; null where it is none. */
export function parsed(text: string | null): unknown {
  try {
    return text === null ? null : JSON.parse(text);
  } catch {
    return null;
  }
}

/** The properties that hold more than text. */
const expected = {
  document: "a problem document, as an object or as its text (JSON)",
  state: "what state has held (an object with the text of a document)",
};

/** What a script gave as JSON, or a sentence on why that cannot be. A text is a document's as it is. */
export function textOf(property: keyof typeof expected, value: unknown): { text: string } | { fault: string } {
  const refused = (found: string) => ({
    fault: `${found} can’t be used for the property ${property}; expected ${expected[property]}.`,
  });
  if (typeof value === "function" || typeof value === "symbol") return refused(`A ${typeof value}`);
  if (typeof value === "bigint") return refused("A BigInt");
  if (property === "document" && typeof value === "string") return { text: value };
  try {
    const text: string | undefined = JSON.stringify(value);
    if (text !== undefined) return { text };
  } catch {
    // It holds itself, or what JSON has no word for.
  }
  return refused("An object that is no JSON (as one that holds itself, or a BigInt)");
}
