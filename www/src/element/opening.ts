// What was open when the page asked for something, and why what it asked for could not be opened.
import type { Answer } from "../state/answer.js";
import type { OpenProblem } from "../state/open-problem.js";

interface Stores {
  answer: Answer;
  problem: OpenProblem;
}

export class Opening {
  private before: unknown = null;
  private fault: string | null = null;

  constructor(private readonly stores: Stores) {}

  begin(): void {
    this.before = this.stores.problem.document.value;
  }

  end(opened: boolean): void {
    const { answer, problem } = this.stores;
    this.fault = opened || problem.document.value !== this.before ? null : answer.error.peek();
  }

  /** Whether another problem is open since. */
  get isThere(): boolean {
    const { problem } = this.stores;
    return problem.document.value !== this.before && problem.document.value === problem.newest;
  }

  /** Why the problem that was asked for last is not there; null where it is, and once the message about it is closed. */
  get missed(): string | null {
    const { value: said } = this.stores.answer.error;
    return this.fault !== null && said?.includes(this.fault) ? this.fault : null;
  }
}
