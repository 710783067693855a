// Keys that work wherever in the playground the focus is, as long as nothing there has keys of its own: ← → Home End
// Space walk through the steps, ? opens the help, and undo and redo edit. By `keys` they work where nothing on the page
// has the focus and the playground is in sight, too ("page"), in the playground alone ("focus"), or not at all ("off"). A key that was handled here
// never reaches the page, but for what listens in the capture phase: only the part that has the focus knows its keys.
import { shortcut } from "../gesture/shortcuts.js";
import { openHelp } from "../help/help.js";
import type { Playground } from "../playground/playground.js";
import { inField } from "../view/typing.js";
import { isInReach } from "./in-reach.js";

export const keyReaches = ["page", "focus", "off"] as const;
export type KeyReach = (typeof keyReaches)[number];

/** The playgrounds of the page, in the order in which they came: the first has the keys when no other has the focus. */
const listening: PageKeys[] = [];

/** The keys, by their codes, whose press the page did not hear of: it hears of nothing more until they are released. */
const unheard = new Set<string>();

const own = `dialog, [role=tab], [role=slider], [role=application], [role=grid], [role=listbox], [role=radio]`;

export class PageKeys {
  constructor(
    private readonly playground: Playground,
    /** What the playground is drawn into. */
    private readonly root: HTMLElement,
    /** Where its keys are heard: its shadow root, in which its dialogs stand beside what is drawn; without one, what it is drawn into. */
    private readonly scope: ShadowRoot | HTMLElement,
    private readonly reach: () => KeyReach,
  ) {}

  listen(): void {
    this.scope.addEventListener("keydown", notYetHeard, { capture: true });
    this.scope.addEventListener("keydown", this.pressed);
    if (listening.length === 0) {
      window.addEventListener("keydown", pressedOutside, { capture: true });
      for (const type of ["keypress", "keyup"]) window.addEventListener(type, rest, { capture: true });
    }
    listening.push(this);
  }

  release(): void {
    this.scope.removeEventListener("keydown", notYetHeard, { capture: true });
    this.scope.removeEventListener("keydown", this.pressed);
    listening.splice(listening.indexOf(this), 1);
    if (listening.length > 0) return;
    window.removeEventListener("keydown", pressedOutside, { capture: true });
    for (const type of ["keypress", "keyup"]) window.removeEventListener(type, rest, { capture: true });
  }

  /** Whether keys without a target on the page are for this playground: what they do is in sight. */
  get hasPage(): boolean {
    return this.reach() === "page" && isInReach(this.root);
  }

  get dragging(): boolean {
    return this.playground.editing.drag.value !== null;
  }

  contains(event: Event): boolean {
    return event.composedPath().includes(this.scope);
  }

  /** Whether a dialog of this playground's own is open above the page. */
  modal(): boolean {
    return this.scope instanceof ShadowRoot && this.scope.querySelector("dialog:modal") !== null;
  }

  /** Does what a key is for; it then is handled. */
  take(event: KeyboardEvent, on: Element): void {
    shortcut(this.playground, event);
    if (event.defaultPrevented || event.altKey || event.ctrlKey || event.metaKey || inField(event)) return;
    if (event.key === "?") {
      event.preventDefault();
      void openHelp(undefined, this.root);
    } else if (!event.shiftKey && on.closest(own) === null && this.walk(event.key, on)) {
      event.preventDefault();
    }
  }

  /** True where the key was one of those that walk through the steps. */
  private walk(key: string, on: Element): boolean {
    const { timeline, boards } = this.playground;
    if (key === " ") {
      if (on.closest("button, a, summary, [role=button]") !== null) return false;
      if (timeline.playing.value) timeline.pause();
      else timeline.play();
      return true;
    }
    // Arrows walk while the person is the agent.
    if (boards.mode.value === "walk" && key.startsWith("Arrow")) return false;
    const target: Record<string, number> = {
      Home: 0,
      End: timeline.lastStep.value,
      ArrowLeft: timeline.step.value - 1,
      ArrowRight: timeline.step.value + 1,
    };
    const step = target[key];
    if (step === undefined) return false;
    timeline.goTo(step);
    return true;
  }

  private readonly pressed = (event: Event) => {
    if (!(event instanceof KeyboardEvent)) return;
    const on = placeOf(event);
    const behind = on.closest("dialog") !== null;
    if (!event.defaultPrevented && !behind && this.reach() !== "off") this.take(event, on);
    if (event.defaultPrevented || isNative(event, on)) event.stopPropagation();
    else unheard.delete(event.code);
  };
}

/** What is stopped inside of the playground, the page does not hear of either. */
const notYetHeard = (event: Event) => {
  if (event instanceof KeyboardEvent) unheard.add(event.code);
};

const placeOf = (event: Event): Element => {
  const [target] = event.composedPath();
  return target instanceof Element ? target : document.body;
};

/** Keys that the browser itself uses there, and no page should use beside it. */
function isNative(event: KeyboardEvent, on: Element): boolean {
  if (event.key === "Tab") return false;
  if (on.closest("dialog") !== null) return true;
  if (event.key === "Escape") return false;
  return inField(event) || ([" ", "Enter"].includes(event.key) && on.closest("button, a, summary") !== null);
}

/** Of keys pressed outside of every playground, those that are for the first that takes them come before the page's. */
function pressedOutside(event: KeyboardEvent): void {
  unheard.delete(event.code);
  if (listening.some((keys) => keys.contains(event))) return;
  const on = placeOf(event);
  const nowhere = (on === document.body || on === document.documentElement) && !isWritten(on);
  if (listening.some((keys) => keys.modal())) {
    // In a dialog, too, the focus may be on nothing.
    if (nowhere) keepFromPage(event);
    return;
  }
  if (event.defaultPrevented) return;
  const dragging = listening.find((keys) => keys.dragging);
  // Beside a link or a button the help may be asked for; what else has the focus may be where text is typed.
  const isFree = nowhere || (event.key === "?" && on.matches("a[href], button, summary"));
  if (dragging === undefined && (!isFree || hasPopover())) return;
  const taker = dragging ?? listening.find((keys) => keys.hasPage);
  if (taker === undefined) return;
  taker.take(event, on);
  if (event.defaultPrevented) keepFromPage(event);
}

/** Whether the page itself is being written in. */
const isWritten = (on: Element): boolean =>
  document.designMode === "on" || (on instanceof HTMLElement && on.isContentEditable);

/** Whether something of the page stands above it for a moment, as a menu. */
function hasPopover(): boolean {
  try {
    return document.querySelector(":popover-open") !== null;
  } catch {
    // A browser that knows none.
    return false;
  }
}

function keepFromPage(event: KeyboardEvent): void {
  unheard.add(event.code);
  event.stopPropagation();
}

function rest(event: Event): void {
  if (!(event instanceof KeyboardEvent) || !unheard.has(event.code)) return;
  event.stopPropagation();
  if (event.type === "keyup") unheard.delete(event.code);
}
