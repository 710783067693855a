// What the form that makes an exercise shows and changes.
import type { ReadonlySignal } from "@preact/signals-core";
import type { RestoreStores } from "../share/restore.js";
import type { ExerciseDraft } from "../state/exercise-draft.js";

export interface AuthorPanelStores extends RestoreStores {
  exerciseDraft: ExerciseDraft;
  /** What a link begins with, and whether it asks for a name where the question varies; null where no link opens a document here. */
  links: ReadonlySignal<{ begin: () => string; asksName: boolean } | null>;
}
