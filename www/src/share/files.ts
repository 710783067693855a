// Documents as files: opening one, and saving the one that is open.

import type { Gallery } from "../gallery/gallery.js";
import { LARGEST_DOCUMENT, LARGEST_IN_WORDS } from "../problem/limits.js";
import type { Answer } from "../state/answer.js";
import type { Edits } from "../state/edits.js";
import type { OpenProblem } from "../state/open-problem.js";
import type { Solving } from "../state/solving.js";
import { download } from "../view/download.js";
import type { Fault } from "../worker/protocol.js";
import { inFile } from "./fault-words.js";

/** Where a text that the core refuses can be put right. */
interface TextEditor {
  faultOf(text: string): Promise<Fault | null>;
  present(text: string): void;
}

export interface FileStores {
  answer: Answer;
  draft: TextEditor;
  problem: OpenProblem;
  gallery: Gallery;
  edits: Edits;
  solving: Solving;
}

export async function openFile(playground: FileStores, file: File): Promise<boolean> {
  if (file.size > LARGEST_DOCUMENT) {
    playground.solving.refuse(`“${file.name}” is too large for a problem document (more than ${LARGEST_IN_WORDS}).`);
    return false;
  }
  let text: string;
  try {
    text = await file.text();
  } catch {
    playground.solving.refuse(`“${file.name}” could not be read. Is it a file, and still there?`);
    return false;
  }
  if (await playground.edits.open(text)) return true;
  const { answer, draft } = playground;
  const fault = await draft.faultOf(text);
  if (fault !== null && answer.error.peek() === fault.message) {
    answer.error.value = inFile(file.name, text, fault);
    draft.present(text);
  }
  return false;
}

/** Lets the browser save the document as it is, to be opened again here or with the command line. */
export function saveFile(playground: FileStores): void {
  const document_ = playground.problem.document.value;
  if (document_ === null) return;
  download(document_.text, "application/json", `${playground.gallery.fileName.value}.json`);
}
