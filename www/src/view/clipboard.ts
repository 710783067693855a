// Putting text on the clipboard.
import { focused } from "../view/surroundings.js";

/** False where the browser does not let the page do so. */
export async function copy(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return copyBySelection(text);
  }
}

/** The old way: it works in pages and frames that may not use the clipboard otherwise. */
function copyBySelection(text: string): boolean {
  const before = focused();
  const field = document.createElement("textarea");
  field.value = text;
  // Out of sight, where nothing scrolls to it.
  Object.assign(field.style, { position: "fixed", inset: "0 auto auto 0", opacity: "0" });
  document.body.append(field);
  field.select();
  const done = document.execCommand("copy");
  field.remove();
  if (before instanceof HTMLElement) before.focus({ preventScroll: true });
  return done;
}
