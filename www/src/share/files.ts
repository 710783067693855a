// Documents as files: opening one, and saving the one that is open.
import type { Playground } from "../state/playground.js";
import { download } from "../view/download.js";

/** No problem that can be drawn is larger; a file by mistake should not stall the page. */
const LARGEST_FILE = 2_000_000;

export async function openFile(playground: Playground, file: File): Promise<boolean> {
  if (file.size > LARGEST_FILE) {
    playground.refuse(`“${file.name}” is too large for a problem document (more than 2 MB).`);
    return false;
  }
  let text: string;
  try {
    text = await file.text();
  } catch {
    playground.refuse(`“${file.name}” could not be read. Is it a file, and still there?`);
    return false;
  }
  return playground.open(text);
}

/** Lets the browser save the document as it is, to be opened again here or with the command line. */
export function saveFile(playground: Playground): void {
  const document_ = playground.document.value;
  if (document_ === null) return;
  download(document_.text, "application/json", `${playground.gallery.current.value?.name ?? "problem"}.json`);
}
