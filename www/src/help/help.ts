// Opens the help. Its text is loaded when somebody asks for it; one dialog serves the whole page, or a
// whole shadow root.
import type { Term } from "./terms.js";

/** `part`: a part of the playground that the help is for. */
export async function openHelp(term: Term | undefined, part: Element): Promise<void> {
  const { showHelp } = await import("./help-dialog.js");
  showHelp(term, part);
}
