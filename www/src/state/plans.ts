// Plans that are no solver's answer on the boards: those of a table, of a link, or of the person who walks.
import type { NextAction, Trace } from "../core.js";
import type { Ending } from "../worker/client.js";
import type { Answer } from "./answer.js";
import type { Boards } from "./boards.js";
import { isMissing } from "./lost.js";
import type { OpenProblem } from "./open-problem.js";
import type { Solving } from "./solving.js";

interface Stores {
  problem: Pick<OpenProblem, "document">;
  boards: Boards;
  answer: Answer;
  solving: Pick<Solving, "ask">;
}

export class Plans {
  constructor(private readonly stores: Stores) {}

  /**
   * Shows another plan than the result's: `title` says whose; `wanted`, whether it is still, once its steps are there.
   * Resolves to why the plan has no such steps, where it has none.
   */
  async show(plan: string[], title: string, wanted = () => true, at: "first" | "end" = "end"): Promise<string | null> {
    const document = this.stores.problem.document.value;
    if (document === null) return null;
    const ending = await this.stores.solving.ask({ kind: "trace", document: document.text, plan });
    if (ending.kind !== "traced") this.fail(ending, () => void this.show(plan, title, wanted, at));
    else if (wanted()) this.stores.boards.showPlan(ending.trace, title, at);
    return ending.kind === "refused" && !isMissing(ending) ? ending.message : null;
  }

  /** Shows what was solved again. */
  showAnswer(): void {
    const { boards, answer } = this.stores;
    boards.showAnswerAgain(answer.trace, (answer.result.value?.outcome.plan ?? null) !== null);
  }

  /** The steps of a plan and what can be done after it; a sentence where the plan has no such steps. */
  async walk(plan: string[]): Promise<{ trace: Trace; next: NextAction[] } | string | null> {
    const document = this.stores.problem.document.value;
    if (document === null) return null;
    const ending = await this.stores.solving.ask({ kind: "walk", document: document.text, plan });
    if (ending.kind === "walked") return ending;
    if (ending.kind === "refused") return ending.message;
    this.fail(ending, null);
    return null;
  }

  private fail(ending: Ending, again: (() => void) | null): void {
    this.stores.answer.fail(ending, isMissing(ending) ? again : null);
  }
}
