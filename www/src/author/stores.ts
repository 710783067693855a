// What the form that makes an exercise shows and changes.
import type { RestoreStores } from "../share/restore.js";
import type { ExerciseDraft } from "../state/exercise-draft.js";

export interface AuthorPanelStores extends RestoreStores {
  exerciseDraft: ExerciseDraft;
}
