// <mo-copp-playground>: the whole playground as one element. It renders into the document itself, so that a course
// page's styles and checks reach its parts by the stable attributes. docs/embedding.md lists attributes and events.
import { html, nothing, type TemplateResult } from "lit";
import { toolbar } from "../edit/toolbar.js";
import { galleryMenu } from "../gallery/menu.js";
import { problemBar } from "../gallery/problem-bar.js";
import { held } from "../gesture/held.js";
import { shortcut } from "../gesture/shortcuts.js";
import { Playground } from "../playground/playground.js";
import { exampleDocument } from "../problem/example.js";
import { Address } from "../share/address.js";
import { copyLink, LinkCopier } from "../share/copy-link.js";
import { DropTarget, dropSign } from "../share/drop.js";
import { Announcer, announcement } from "../stage/announcement.js";
import { goalList } from "../stage/goal-list.js";
import { legend } from "../stage/legend.js";
import { stage } from "../stage/stage.js";
import { stepper } from "../stage/stepper.js";
import { followSymbols } from "../stage/symbols.js";
import { followRow } from "../steps/follow-row.js";
import { cross } from "../view/icons.js";
import { workbench } from "../workbench/workbench.js";
import { Notifier } from "./events.js";
import { keepInSight } from "./in-sight.js";
import { PageKeys } from "./page-keys.js";
import { goToStep, hiddenParts, mistakes, type Part, settingNames, settingsOf, settle } from "./settings.js";
import { SignalElement } from "./signal-element.js";

export class MoCoppPlayground extends SignalElement {
  static override get observedAttributes(): string[] {
    return [...SignalElement.observedAttributes, ...settingNames, "hide", "link"];
  }

  private readonly playground = new Playground();
  private readonly shortcuts = (event: KeyboardEvent) => {
    if (this.keys.areFor(event)) shortcut(this.playground, event);
  };
  private readonly address = new Address(this.playground);
  private readonly copier = new LinkCopier(this.address);
  private readonly drops = new DropTarget(this.playground);
  private readonly announcer = new Announcer(this.playground);
  private readonly keys = new PageKeys(this.playground, this);
  /** Rows that got narrower have moved what was in sight. */
  private readonly sizes = new ResizeObserver(() => followSymbols(this));
  private readonly notifier = new Notifier(this.playground, this);
  /** Whether the page's address is this playground's. */
  private sharing = false;
  private readonly seen = keepInSight(this);
  private begun = false;
  /** The attributes that changed in this turn. */
  private readonly changed = new Set<string>();
  /** How often they were followed: whoever is still at it then knows that others came after. */
  private followed = 0;
  private following = false;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.playground.solving.prepare();
    this.sharing = this.getAttribute("link") !== "off" && this.address.claim();
    // Who has the address has the page; among several, each takes what is dropped on itself.
    this.drops.listen(this.sharing ? window : this);
    this.announcer.listen();
    this.keys.listen();
    this.sizes.observe(this);
    document.addEventListener("keydown", this.shortcuts);
    this.addEventListener("focusin", this.seen);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    document.removeEventListener("keydown", this.shortcuts);
    this.removeEventListener("focusin", this.seen);
    this.sizes.disconnect();
    this.address.release();
    this.drops.release();
    this.announcer.release();
    this.keys.release();
    this.playground.dispose();
  }

  override attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    super.attributeChangedCallback(name, before, after);
    if (!this.begun || before === after) return;
    this.requestUpdate();
    if (name === "link") return;
    // A page that changes several means all of them at once.
    if (this.changed.size === 0) queueMicrotask(() => this.followAttributes());
    this.changed.add(name);
  }

  private followAttributes(): void {
    const names = new Set(this.changed);
    this.changed.clear();
    if ([...names].some((name) => name !== "step" && name !== "hide")) {
      void this.settle();
      return;
    }
    if (names.has("step")) goToStep(this.playground, settingsOf(this));
    this.sayMistakes(names);
  }

  private async settle(): Promise<void> {
    this.followed += 1;
    const now = this.followed;
    const wanted = () => now === this.followed;
    const settled = await settle(this.playground, settingsOf(this), exampleDocument, wanted);
    // The step may have changed meanwhile.
    if (settled) goToStep(this.playground, settingsOf(this));
    if (wanted()) this.sayMistakes(new Set([...settingNames, "hide"]));
  }

  /** Beside what else could not be used. */
  private sayMistakes(names: ReadonlySet<string>): void {
    const found = mistakes(this, names);
    if (found.length === 0) return;
    const said = this.playground.answer.error.peek();
    const others = said === null || found.some((mistake) => said.includes(mistake)) ? [] : [said];
    this.playground.solving.refuse([...others, ...found].join(" "));
  }

  protected override firstUpdated(): void {
    void this.begin();
  }

  /** The address goes before the attributes: whoever followed a link wants what it holds. */
  private async begin(): Promise<void> {
    this.begun = true;
    const opened = this.sharing ? await this.address.read() : null;
    if (opened === true || this.followed > 0) return;
    const { playground } = this;
    const mistake = playground.answer.error.value;
    await this.settle();
    if (opened === false && mistake !== null) playground.solving.refuse(mistake);
  }

  /** What could not be opened or solved for want of a solver is asked for again. */
  private async retry(): Promise<void> {
    const { problem, solving } = this.playground;
    const open = problem.document.peek();
    if (open !== null) solving.follow(open);
    else if (!this.sharing || (await this.address.read()) !== true) await this.settle();
  }

  protected override render(): TemplateResult {
    const playground = this.playground;
    const error = playground.answer.error.value;
    const hidden = hiddenParts(this.getAttribute("hide"));
    const show = (part: Part, content: () => unknown) => (hidden.has(part) ? nothing : content());
    const link = () => (this.sharing && !hidden.has("share") ? copyLink(playground, this.copier) : nothing);
    return html`
      <div class="error">
        <div role="alert">${error === null ? nothing : html`<p>${error}</p>`}</div>
        ${
          error !== null && playground.answer.unstarted.value
            ? html`<p class="retry"><button type="button" class="small" @click=${() => void this.retry()}>Try again</button></p>`
            : nothing
        }
        ${
          error === null
            ? nothing
            : html`<button type="button" class="sign" aria-label="Close the message" title="Close the message"
                @click=${() => playground.answer.dismiss()}>${cross}</button>`
        }
      </div>
      ${show("gallery", () => held(playground, () => problemBar(playground, link())))} ${show("tools", () => toolbar(playground))}
      ${stage(playground)}
      ${show("stepper", () => stepper(playground))} ${show("legend", () => legend(playground))}
      ${
        hidden.has("workbench") && hidden.has("goals")
          ? nothing
          : html`<div class="below">
              ${show("workbench", () => workbench(playground))}
              ${show("goals", () => html`<section class="card" aria-label="Goals">${goalList(playground)}</section>`)}
            </div>`
      }
      ${show("gallery", () => galleryMenu(playground))} ${dropSign(this.drops)} ${announcement(this.announcer)}
    `;
  }

  /** In the next frame the page is laid out anyway; asking where things are before that would do it twice. */
  private follow(): void {
    if (this.following) return;
    this.following = true;
    requestAnimationFrame(() => {
      this.following = false;
      followSymbols(this);
      followRow(this, this.playground.timeline.step.value);
    });
  }

  protected override updated(): void {
    const { answer, timeline, boards } = this.playground;
    this.dataset.status = answer.status.value;
    this.dataset.step = String(timeline.step.value);
    if (boards.difference.value === null) delete this.dataset.gd;
    else this.dataset.gd = String(boards.difference.value);
    this.follow();
    void this.playground.walk.follow();
    this.notifier.notify();
  }
}
