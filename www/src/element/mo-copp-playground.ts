// <mo-copp-playground>: the whole playground as one element. It renders into the document itself, so that a course
// page's styles and checks reach its parts by the stable attributes.
import { html, nothing, type TemplateResult } from "lit";
import { exampleDocument } from "../state/example.js";
import { Playground } from "../state/playground.js";
import { announcement } from "../view/announcement.js";
import { boards } from "../view/boards.js";
import { documentForm } from "../view/document-form.js";
import { goalDifference } from "../view/goal-difference.js";
import { goalList } from "../view/goal-list.js";
import { legend } from "../view/legend.js";
import { solverForm } from "../view/solver-form.js";
import { stepper } from "../view/stepper.js";
import { SolverClient } from "../worker/client.js";
import { SignalElement } from "./signal-element.js";

export class MoCoppPlayground extends SignalElement {
  private readonly playground = new Playground(new SolverClient());

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  protected override firstUpdated(): void {
    void this.playground.open(exampleDocument);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.playground.dispose();
  }

  protected override render(): TemplateResult {
    const playground = this.playground;
    const error = playground.error.value;
    return html`
      <div class="error" role="alert">${error === null ? nothing : html`<p>${error}</p>`}</div>
      ${boards(playground)} ${goalDifference(playground)} ${stepper(playground)} ${legend(playground)}
      <div class="below">
        <section class="card" aria-label="Goals">${goalList(playground)}</section>
        <section class="card" aria-label="Plan">${solverForm(playground)}</section>
      </div>
      ${documentForm(playground)} ${announcement(playground)}
    `;
  }

  protected override updated(): void {
    const { status, step, result } = this.playground;
    this.dataset.status = status.value;
    this.dataset.step = String(step.value);
    const difference = result.value?.outcome.goal_difference ?? null;
    if (difference === null) delete this.dataset.gd;
    else this.dataset.gd = String(difference);
  }
}
