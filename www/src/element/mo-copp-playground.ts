// <mo-copp-playground>: the whole playground as one element. It renders into the document itself, so that a course
// page's styles and checks reach its parts by the stable attributes.
import { html, nothing, type TemplateResult } from "lit";
import { shortcut } from "../edit/shortcuts.js";
import { toolbar } from "../edit/toolbar.js";
import { exampleDocument } from "../problem/example.js";
import { announcement } from "../stage/announcement.js";
import { goalList } from "../stage/goal-list.js";
import { legend } from "../stage/legend.js";
import { stage } from "../stage/stage.js";
import { stepper } from "../stage/stepper.js";
import { followSymbols } from "../stage/symbols.js";
import { Playground } from "../state/playground.js";
import { workbench } from "../workbench/workbench.js";
import { SolverClient } from "../worker/client.js";
import { SignalElement } from "./signal-element.js";

export class MoCoppPlayground extends SignalElement {
  private readonly playground = new Playground(new SolverClient());
  private readonly shortcuts = (event: KeyboardEvent) => shortcut(this.playground, event);

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  protected override firstUpdated(): void {
    void this.playground.open(exampleDocument);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    document.addEventListener("keydown", this.shortcuts);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    document.removeEventListener("keydown", this.shortcuts);
    this.playground.dispose();
  }

  protected override render(): TemplateResult {
    const playground = this.playground;
    const error = playground.error.value;
    return html`
      <div class="error" role="alert">${error === null ? nothing : html`<p>${error}</p>`}</div>
      ${toolbar(playground)} ${stage(playground)} ${stepper(playground)} ${legend(playground)}
      <div class="below">
        ${workbench(playground)}
        <section class="card" aria-label="Goals">${goalList(playground)}</section>
      </div>
      ${announcement(playground)}
    `;
  }

  protected override updated(): void {
    const { status, timeline, difference } = this.playground;
    this.dataset.status = status.value;
    this.dataset.step = String(timeline.step.value);
    if (difference.value === null) delete this.dataset.gd;
    else this.dataset.gd = String(difference.value);
    followSymbols(this);
    void this.playground.walker.follow();
  }
}
