// Styles for shadow roots: one sheet for all roots of a document, made by script, which no content policy forbids.
import { keepProperties } from "./own-properties.js";

/** A sheet is its document's alone. */
const sheets = new WeakMap<Document, Map<string, CSSStyleSheet>>();
/** The styles of each root, in the order in which they go before each other. */
const adopted = new WeakMap<ShadowRoot, Map<string, string>>();

export function adopt(root: ShadowRoot, name: string, text: string): void {
  const styles = adopted.get(root) ?? new Map<string, string>();
  adopted.set(root, styles);
  if (styles.has(name)) return;
  styles.set(name, text);
  take(root, name, text);
}

/** A root that has moved into another document has left its sheets behind. */
export function adoptAgain(root: ShadowRoot): void {
  for (const [name, text] of adopted.get(root) ?? []) take(root, name, text);
}

function take(root: ShadowRoot, name: string, text: string): void {
  keepProperties(root.ownerDocument, text);
  const sheet = sheetOf(root.ownerDocument, name, text);
  if (sheet === null || !("adoptedStyleSheets" in root)) {
    write(root, name, text);
  } else if (!root.adoptedStyleSheets.includes(sheet)) {
    root.adoptedStyleSheets = [...root.adoptedStyleSheets, sheet];
  }
}

/** Null for a document without a window, and for browsers that make no sheets. */
function sheetOf(document: Document, name: string, text: string): CSSStyleSheet | null {
  const known = sheets.get(document) ?? new Map<string, CSSStyleSheet>();
  sheets.set(document, known);
  const found = known.get(name);
  if (found !== undefined) return found;
  const { CSSStyleSheet: Sheet } = (document.defaultView ?? {}) as { CSSStyleSheet?: typeof CSSStyleSheet };
  if (Sheet?.prototype.replaceSync === undefined) return null;
  const sheet = new Sheet();
  sheet.replaceSync(text);
  known.set(name, sheet);
  return sheet;
}

/** As an element, which moves with its root. */
function write(root: ShadowRoot, name: string, text: string): void {
  const written = [...root.children].filter((child) => child instanceof HTMLStyleElement);
  if (written.some(({ dataset }) => dataset.name === name)) return;
  const style = document.createElement("style");
  style.dataset.name = name;
  style.textContent = text;
  const last = written.at(-1);
  if (last === undefined) root.prepend(style);
  else last.after(style);
}
