// Documents as files: opening one, and saving the one that is open.

import type { Gallery } from "../gallery/gallery.js";
import type { Edits } from "../state/edits.js";
import type { OpenProblem } from "../state/open-problem.js";
import type { Solving } from "../state/solving.js";
import { download } from "../view/download.js";

export interface FileStores {
  problem: OpenProblem;
  gallery: Gallery;
  edits: Edits;
  solving: Solving;
}

/** No problem that can be drawn is larger; a file by mistake should not stall the page. */
const LARGEST_FILE = 2_000_000;

export async function openFile(playground: FileStores, file: File): Promise<boolean> {
  if (file.size > LARGEST_FILE) {
    playground.solving.refuse(`“${file.name}” is too large for a problem document (more than 2 MB).`);
    return false;
  }
  let text: string;
  try {
    text = await file.text();
  } catch {
    playground.solving.refuse(`“${file.name}” could not be read. Is it a file, and still there?`);
    return false;
  }
  return playground.edits.open(text);
}

/** Lets the browser save the document as it is, to be opened again here or with the command line. */
export function saveFile(playground: FileStores): void {
  const document_ = playground.problem.document.value;
  if (document_ === null) return;
  download(document_.text, "application/json", `${playground.gallery.current.value?.name ?? "problem"}.json`);
}
