// Opens the help. Its text is loaded when somebody asks for it; one dialog serves the whole page.
import type { Term } from "./terms.js";

export async function openHelp(term?: Term): Promise<void> {
  const { showHelp } = await import("./help-dialog.js");
  showHelp(term);
}
