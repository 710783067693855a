// The playground's state, all in one place, and what can be done to it. Views read the signals and call the actions.
import { Gallery } from "../gallery/gallery.js";
import { Draft } from "../text/draft.js";
import { Adviser } from "./adviser.js";
import { Comparison } from "./comparison.js";
import { Editing } from "./editing.js";
import { Edits } from "./edits.js";
import { Guess } from "./guess.js";
import { Drafts } from "./numbers.js";
import { Tradeoff } from "./tradeoff.js";
import { Walk } from "./walk.js";
import { Workbench } from "./workbench.js";

export type { Mode, OpenDocument, Result, Status } from "./result.js";

export class Playground extends Edits {
  readonly workbench = new Workbench();
  readonly walker = new Walk(this);
  readonly guess = new Guess(this);
  readonly drafts = new Drafts();
  readonly adviser = new Adviser(this);
  readonly comparison = new Comparison(this);
  readonly tradeoff = new Tradeoff(this);
  readonly editing = new Editing();
  readonly gallery = new Gallery(this);
  readonly draft = new Draft(this);

  /** What is being dragged belongs to the problem that was open. */
  override open(...asked: Parameters<Edits["open"]>): Promise<boolean> {
    this.editing.drag.value = null;
    return super.open(...asked);
  }

  override dispose(): void {
    super.dispose();
    const { walker, guess, adviser, comparison, tradeoff, draft } = this;
    for (const part of [walker, guess, adviser, comparison, tradeoff, draft]) part.dispose();
  }

  protected override leaveGames(): void {
    this.guess.end();
  }
}
