// What the form that makes an exercise shows and changes.
import type { Edits } from "../state/edits.js";
import type { ExerciseDraft } from "../state/exercise-draft.js";
import type { OpenProblem } from "../state/open-problem.js";
import type { Timeline } from "../state/timeline.js";

export interface AuthorPanelStores {
  exerciseDraft: ExerciseDraft;
  problem: OpenProblem;
  timeline: Timeline;
  edits: Edits;
}
