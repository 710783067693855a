// What an element shows: the whole playground, drawn into the element itself or into its shadow root.
import { computed, effect, signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit";
import { toolbar } from "../edit/toolbar.js";
import type { ExerciseViewStores } from "../exercise/exercise-view.js";
import { wayBack } from "../exercise/way-back.js";
import { galleryMenu } from "../gallery/menu.js";
import { problemBar } from "../gallery/problem-bar.js";
import { held } from "../gesture/held.js";
import { Tour } from "../help/tour.js";
import { Playground } from "../playground/playground.js";
import { exampleDocument } from "../problem/example.js";
import type { ProblemDocument } from "../problem/types.js";
import { Address } from "../share/address.js";
import { copyLink, LinkCopier } from "../share/copy-link.js";
import { DropTarget, dropSign } from "../share/drop.js";
import { pictureButton } from "../share/picture-button.js";
import { restoreText } from "../share/restore.js";
import { keptState, type SharedState } from "../share/shared-state.js";
import { Announcer, announcement } from "../stage/announcement.js";
import { goalList } from "../stage/goal-list.js";
import { legend } from "../stage/legend.js";
import { type StageStores, stage } from "../stage/stage.js";
import { stepper } from "../stage/stepper.js";
import { followSymbols } from "../stage/symbols.js";
import { followRow } from "../steps/follow-row.js";
import { LazyPanel } from "../workbench/lazy-panel.js";
import { type WorkbenchStores, workbench } from "../workbench/workbench.js";
import { choosePlaces } from "../worker/places.js";
import type { Answered } from "../worker/protocol.js";
import { AttributeChanges } from "./attribute-changes.js";
import { AttributeMessage, manners, ofQuestion } from "./attribute-message.js";
import { errorMessage } from "./error-message.js";
import { type FieldTold, Notifier } from "./events.js";
import { FirstUse } from "./first-use.js";
import { Given, type Wanted } from "./given.js";
import { keepInSight } from "./in-sight.js";
import { linkAddressOf } from "./link-address.js";
import { LiveRender } from "./live-render.js";
import { mark } from "./marks.js";
import { Opening } from "./opening.js";
import { opensExample } from "./opens-example.js";
import { PageKeys } from "./page-keys.js";
import { PageQuestion } from "./page-question.js";
import { parsed } from "./parsed.js";
import { Printing } from "./printing.js";
import * as calls from "./script-calls.js";
import {
  documentOf,
  goToStep,
  hiddenParts,
  inline,
  isOwnPage,
  keyReachOf,
  leavesSeed,
  opensAt,
  type Part,
  seedOf,
  settingsAmong,
  settingsOf,
  settle,
} from "./settings.js";
import type { ElementSolveOptions } from "./solve-options.js";
import type { PngOptions, SvgOptions } from "./svg-options.js";
import { followScheme, schemeOf } from "./theme.js";
import { UnderWay } from "./under-way.js";

/** An exercise is drawn by code that other problems do without. */
const exercise = new LazyPanel<ExerciseViewStores>(
  async () => (await import("../exercise/exercise-view.js")).exerciseView,
);

/** The parts that show what observers believe. */
const beliefs: readonly Part[] = ["enemy", "friend", "counts", "goals", "legend"];

/** What the element is told. */
interface Told extends FieldTold {
  /** There is a picture of a problem, or word of why there is none. */
  shown: () => void;
}

export class View {
  readonly playground = new Playground();
  private stopScheme = () => {};
  private readonly question: PageQuestion;
  private readonly address: Address;
  private readonly copier: LinkCopier;
  private readonly drops: DropTarget;
  private readonly announcer: Announcer;
  private readonly keys: PageKeys;
  private readonly firstUse: FirstUse;
  private readonly picture: LiveRender;
  private readonly tour: Tour;
  private readonly printing = new Printing(() => this.picture.now());
  /** What the boards are drawn with, where there is a tour of them and where there is none. They keep what is open by it. */
  private readonly onStage: { toured: StageStores; alone: StageStores };
  /** Rows that got narrower have moved what was in sight. */
  private readonly sizes = new ResizeObserver(() => followSymbols(this.root));
  private readonly notifier: Notifier;
  private readonly message: AttributeMessage;
  private readonly underWay = new UnderWay();
  private readonly opening = new Opening(this.playground);
  private readonly seen: (event: FocusEvent) => void;
  /** Whether the page's address is this playground's. */
  private readonly sharing = signal(false);
  /** What the tabs are drawn with. */
  private readonly onBench: WorkbenchStores;
  private begun = false;
  /** Set while it is out of the page and does not sleep yet. */
  private leaving: ReturnType<typeof setTimeout> | undefined;
  /** The attributes that changed in this turn. */
  private readonly changes: AttributeChanges;
  /** How often they were followed: work that is still under way then knows that other attributes came after. */
  private followed = 0;
  private following = false;
  private readonly given: Given;

  constructor(
    private readonly host: HTMLElement,
    private readonly root: HTMLElement,
    private readonly told: Told,
    first: Wanted,
  ) {
    this.given = new Given(first);
    this.changes = new AttributeChanges(host, (names) => this.followAttributes(names));
    this.question = new PageQuestion(host, this.playground);
    this.address = new Address(this.playground, host.shadowRoot !== null, (state) => this.question.refuses(state));
    this.copier = new LinkCopier(this.address);
    this.drops = new DropTarget(this.playground, () => this.question.refusal);
    this.announcer = new Announcer(this.playground);
    this.keys = new PageKeys(this.playground, root, host.shadowRoot ?? root, () => keyReachOf(host));
    this.firstUse = new FirstUse(host);
    this.picture = new LiveRender(
      root,
      () => this.content(),
      () => this.drawn(),
    );
    this.notifier = new Notifier(this.playground, host, this.question, told);
    this.message = new AttributeMessage(host, this.playground, this.question);
    this.tour = new Tour(root);
    this.onStage = { toured: { ...this.playground, tour: this.tour }, alone: { ...this.playground, tour: null } };
    // Where the page asks a question, a link opens no other.
    const link = { begin: () => linkAddressOf(host), asksName: isOwnPage(host) };
    const links = computed(() => (this.sharing.value && !this.question.asked ? link : null));
    this.onBench = { ...this.playground, links };
    this.seen = keepInSight(root);
  }

  connect(): void {
    const { host } = this;
    clearTimeout(this.leaving);
    this.playground.wake();
    choosePlaces({ worker: host.getAttribute("worker-url"), wasm: host.getAttribute("wasm-url") });
    this.sharing.value = this.host.getAttribute("link") !== "off" && this.address.claim();
    const isLinked = this.sharing.value && location.hash !== "";
    if (this.begun || !opensExample(host, this.given.first, isLinked)) this.playground.solving.prepare();
    // Which playground has the address has the page; among several, each takes what is dropped on itself.
    this.drops.listen(this.sharing.value ? window : this.host);
    this.announcer.listen();
    this.keys.listen();
    this.firstUse.listen();
    this.printing.connect();
    this.stopScheme = followScheme(host, (scheme) => this.playground.exercise.colour(scheme));
    this.sizes.observe(this.root);
    this.root.addEventListener("focusin", this.seen);
    this.picture.connect();
    if (!this.begun) void this.work(() => this.begin().then(() => this.refuse(this.given.first.fault ?? null)));
  }

  disconnect(): void {
    this.picture.disconnect();
    this.root.removeEventListener("focusin", this.seen);
    this.sizes.disconnect();
    this.stopScheme();
    this.address.release();
    this.drops.release();
    this.announcer.release();
    this.keys.release();
    this.firstUse.release();
    this.printing.disconnect();
    // A page that moves it takes it out and puts it back in one turn: then the work goes on.
    clearTimeout(this.leaving);
    this.leaving = setTimeout(() => this.playground.sleep());
  }

  get document(): ProblemDocument | null {
    const { exercise, problem } = this.playground;
    if (this.given.document !== null) return this.given.document as ProblemDocument;
    const asked = exercise.posed.value;
    return asked === null ? structuredClone(problem.document.value?.value ?? null) : JSON.parse(asked.text);
  }

  get state(): SharedState | null {
    return (this.given.state ?? parsed(keptState(this.playground))) as SharedState | null;
  }

  refuse(fault: string | null): void {
    if (fault !== null) this.playground.solving.refuse(fault);
  }

  /** What was asked for before comes to nothing. */
  openDocument(text: string): Promise<void> {
    return this.give({ document: text, state: null }, text, () => this.playground.edits.open(text));
  }

  openState(text: string): Promise<void> {
    const { document } = parsed(text) as Partial<SharedState>;
    return this.give({ document: null, state: text }, document ?? null, () => restoreText(this.playground, text));
  }

  /** Settles once what was asked for is there; of a problem that takes long to solve, once it is open. */
  async settled(): Promise<void> {
    const { answer } = this.playground;
    const ended = this.underWay.ended();
    const stop = effect(() => {
      if (this.opening.isThere && answer.slow.value && answer.status.value === "solving") this.underWay.release();
    });
    await ended;
    stop();
  }

  private work(begin: () => Promise<void>): Promise<void> {
    this.opening.begin();
    return this.underWay.begin(begin());
  }

  private give(pending: Wanted, document: string | null, open: () => Promise<boolean>): Promise<void> {
    return this.work(() => this.take(pending, document, open));
  }

  private async take(pending: Wanted, document: string | null, open: () => Promise<boolean>): Promise<void> {
    this.followed += 1;
    this.followQuestion();
    this.given.begin(pending, document);
    const opened = await open();
    if (!this.given.end(pending, opened)) return;
    this.ended(opened);
    this.message.say(ofQuestion);
    if (opened && this.given.changed.has("step")) goToStep(this.playground, settingsOf(this.host));
    const { again } = this.playground.answer;
    if (!opened && again.value !== null) again.value = () => void this.give(pending, document, open);
  }

  private ended(opened: boolean): void {
    if (opened) this.question.take();
    else this.question.miss();
    this.opening.end(opened);
  }

  /** Whether no answer may be given: the form's field is disabled. */
  disable(isDisabled: boolean): void {
    this.playground.exercise.disabled.value = isDisabled;
  }

  goTo(step: number): void {
    calls.goTo(this.playground, step);
  }

  async solve(options: ElementSolveOptions): Promise<Answered> {
    const { missed } = this.opening;
    if (missed !== null) throw new Error(missed);
    return calls.solve(this.playground, options);
  }

  toSVG(options: SvgOptions): Promise<string> {
    return calls.toSVG(this.playground, options, schemeOf(this.host));
  }

  toPNG(options: PngOptions): Promise<Blob> {
    return calls.toPNG(this.playground, options, schemeOf(this.host));
  }

  /** False where it is not the page that changed it. */
  attributeChanged(name: string): boolean {
    this.picture.request();
    const byPage = this.changes.add(name);
    if (byPage && (name === "src" || name === "problem")) this.given.drop();
    return byPage;
  }

  private followAttributes(names: ReadonlySet<string>): void {
    for (const name of names) this.given.changed.add(name);
    if ([...names].some((name) => !manners.has(name))) {
      void this.settle();
      return;
    }
    if (names.has("step")) this.followStep();
    this.message.say(names);
  }

  private followStep(): void {
    const { given, playground } = this;
    if (!given.isPending || playground.problem.document.value?.text === given.text)
      goToStep(this.playground, settingsOf(this.host));
  }

  private settle(at: "first" | "end" = "end"): Promise<void> {
    return this.work(() => this.takeAttributes(at));
  }

  private async takeAttributes(at: "first" | "end"): Promise<void> {
    this.followed += 1;
    const now = this.followed;
    this.followQuestion();
    this.question.begin();
    const wanted = () => now === this.followed;
    const pending = this.given.join();
    const given = this.given.text;
    const state = this.given.stateText;
    const asked = () => (state === null ? settingsOf(this.host) : settingsAmong(this.host, this.given.changed));
    const settings = given === null ? asked() : { ...asked(), src: null, problem: null };
    const document = given ?? inline(this.host) ?? exampleDocument;
    const settled = await settle(this.playground, settings, document, at, {
      wanted,
      again: () => void this.settle(at),
      read: (text) => this.question.read(text),
      ...(state === null ? {} : { open: () => restoreText(this.playground, state) }),
    });
    if (wanted()) this.ended(settled);
    // What may come the next time is still what was given.
    if (wanted()) this.given.end(pending, settled || this.playground.answer.again.value !== null);
    // The step may have changed meanwhile.
    if (settled) goToStep(this.playground, asked());
    if (wanted()) this.message.sayAll();
  }

  /** What an exercise is asked with. */
  private followQuestion(): void {
    this.playground.exercise.seed = seedOf(this.host);
    this.playground.exercise.anyone = leavesSeed(this.host);
    this.playground.exercise.block = this.host.getAttribute("exercise");
  }

  /** The address goes before the attributes: a link that was followed holds what is wanted. */
  private async begin(): Promise<void> {
    this.begun = true;
    this.followQuestion();
    const { document, state } = this.given.first;
    if (state !== null) {
      const opened = this.openState(state);
      // A state that names no step leaves it to the attribute.
      if ((parsed(state) as Partial<SharedState>).step === undefined) this.given.changed.add("step");
      return opened;
    }
    if (document !== null) {
      this.given.takeFirst();
      return this.settle(opensAt(this.host));
    }
    const opened = await this.openLink();
    if (opened === true || this.followed > 0) return;
    const { answer, solving } = this.playground;
    const [mistake, again] = [answer.error.value, answer.again.value];
    await this.settle(opensAt(this.host));
    if (opened === false && mistake !== null) solving.refuse(mistake, again);
  }

  /** Opens what the address holds, where it is this playground's: false where that cannot be, null where it holds nothing. */
  private async openLink(): Promise<boolean | null> {
    if (!this.sharing.value || location.hash === "") return null;
    const { host, playground } = this;
    const asks = host.hasAttribute("src") || host.hasAttribute("exercise");
    const settings = settingsOf(host);
    const begins = settings.src === null && settings.problem === null ? exampleDocument : null;
    const given = inline(host) ?? (asks ? await documentOf(playground, settings) : null) ?? begins;
    if (this.followed > 0) return null;
    this.question.expect(given);
    const opened = await this.address.read();
    if (opened === true) this.question.arrive();
    return opened;
  }

  private content(): TemplateResult {
    const playground = this.playground;
    const error = playground.answer.error.value;
    const { opening, posed, refused } = playground.exercise;
    const isBare = error !== null && playground.problem.document.value === null && posed.value === null;
    const shown = () => {
      if (opening.value || posed.value !== null) return exercise.panel({ ...playground, onPaper: this.printing.under });
      if (isBare && refused.value) return nothing;
      return html`${wayBack(playground)} ${this.workplace(isBare)}`;
    };
    return html`
      ${errorMessage(playground.answer, isBare)}
      ${shown()} ${dropSign(this.drops)}
    `;
  }

  /** Everything but an exercise; `isBare`: no problem is open, and none is on its way. */
  private workplace(isBare: boolean): TemplateResult {
    const { playground } = this;
    const hidden = new Set([
      ...hiddenParts(this.host.getAttribute("hide")),
      ...(playground.problem.veiled.value ? beliefs : []),
    ]);
    const show = (part: Part, content: () => unknown) => (hidden.has(part) ? nothing : content());
    const link = () => (this.sharing.value ? copyLink(playground, this.copier) : nothing);
    const share = () =>
      hidden.has("share") ? nothing : html`${pictureButton(playground, () => schemeOf(this.host))} ${link()}`;
    // Parts that the tour speaks of may be left out; of several playgrounds the first has it.
    const toured =
      this.sharing.value &&
      !["gallery", "stepper", "workbench", "enemy", "friend", "counts"].some((part) => hidden.has(part));
    const bar = () => held(playground, () => problemBar(playground, isBare ? nothing : share()));
    const menu = () => galleryMenu(playground);
    if (isBare) {
      return html`<div class="sheet-top">${show("gallery", bar)} ${stage(this.onStage.alone, hidden)}</div>
        ${show("gallery", menu)} ${announcement(this.announcer)}`;
    }
    return html`
      <div class="sheet-top">
        ${show("gallery", bar)} ${show("tools", () => toolbar(playground))}
        ${stage(toured ? this.onStage.toured : this.onStage.alone, hidden)}
      </div>
      ${show("stepper", () => stepper(playground))} ${show("legend", () => legend(playground))}
      ${
        hidden.has("workbench") && hidden.has("goals")
          ? nothing
          : html`<div class="below">
              ${show("workbench", () => workbench(this.onBench))}
              ${show("goals", () => html`<section class="card" part="goals" aria-label="Goals">${goalList(playground)}</section>`)}
            </div>`
      }
      ${show("workbench", () => (playground.problem.veiled.value ? nothing : this.printing.content(playground)))}
      ${show("gallery", menu)} ${announcement(this.announcer)} ${this.tour.card()}
    `;
  }

  /** In the next frame the page is laid out anyway; asking where things are before that would do it twice. */
  private follow(): void {
    if (this.following) return;
    this.following = true;
    requestAnimationFrame(() => {
      this.following = false;
      followSymbols(this.root);
      followRow(this.root, this.playground.timeline.step.value);
    });
  }

  private drawn(): void {
    const { answer, exercise, timeline } = this.playground;
    mark(this.host, this.playground);
    if (exercise.posed.value !== null || timeline.trace.value !== null || answer.status.value === "error")
      this.told.shown();
    if (timeline.trace.value !== null) this.printing.prepare();
    this.follow();
    void this.playground.walk.follow();
    this.notifier.notify();
  }
}
