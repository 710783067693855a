// A playground's state: its stores, each given those that it works with. Views are given those that they show.
import { signal } from "@preact/signals-core";
import { Gallery } from "../gallery/gallery.js";
import { Adviser } from "../state/adviser.js";
import { Answer } from "../state/answer.js";
import { Boards } from "../state/boards.js";
import { Comparison } from "../state/comparison.js";
import { Editing } from "../state/editing.js";
import { Edits } from "../state/edits.js";
import { Exercise } from "../state/exercise.js";
import { ExerciseDraft } from "../state/exercise-draft.js";
import { emptyForm, type Form } from "../state/form.js";
import { Guess } from "../state/guess.js";
import { Drafts } from "../state/numbers.js";
import { OpenProblem } from "../state/open-problem.js";
import { Pictures } from "../state/pictures.js";
import { Plans } from "../state/plans.js";
import { Solving } from "../state/solving.js";
import { Timeline } from "../state/timeline.js";
import { Tradeoff } from "../state/tradeoff.js";
import { Walk } from "../state/walk.js";
import { Why } from "../state/why.js";
import { Workbench } from "../state/workbench.js";
import { Draft } from "../text/draft.js";
import { Copier } from "../view/copier.js";

export class Playground {
  readonly workbench = new Workbench();
  readonly problem = new OpenProblem();
  readonly answer = new Answer();
  readonly timeline = new Timeline();
  readonly boards = new Boards(this);
  readonly form = signal<Form>(emptyForm);
  readonly drafts = new Drafts();
  readonly editing = new Editing();
  readonly exercise = new Exercise();
  readonly exerciseDraft = new ExerciseDraft(this);
  readonly solving = new Solving(this);
  readonly edits = new Edits(this);
  readonly plans = new Plans(this);
  readonly pictures = new Pictures(this);
  readonly why = new Why(this);
  readonly walk = new Walk(this);
  readonly guess = new Guess(this);
  readonly adviser = new Adviser(this);
  readonly comparison = new Comparison(this);
  readonly tradeoff = new Tradeoff(this);
  readonly gallery = new Gallery(this);
  readonly draft = new Draft(this);
  readonly command = new Copier();

  /** It is out of the page: it has no worker, and what is under way waits. */
  sleep(): void {
    this.timeline.pause();
    for (const part of this.atWork) part.sleep();
  }

  /** It is back: what was under way goes on. */
  wake(): void {
    for (const part of this.atWork) part.wake();
  }

  private get atWork() {
    const { solving, answer, pictures, why, walk, guess, adviser, comparison, tradeoff, draft } = this;
    const { exercise, exerciseDraft } = this;
    return [
      ...[solving, answer, exercise, exerciseDraft, pictures, why],
      ...[walk, guess, adviser, comparison, tradeoff, draft],
    ];
  }
}
