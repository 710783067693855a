// Keys that work wherever the focus is, as long as nothing there has keys of its own: ← → Home End Space walk through
// the steps, and ? opens the help.
import { openHelp } from "../help/help.js";
import type { Playground } from "../playground/playground.js";
import { inField } from "../view/typing.js";

/** The playgrounds of the page, in the order in which they came: the first has the keys when no other has the focus. */
const listening: PageKeys[] = [];

export class PageKeys {
  constructor(
    private readonly playground: Playground,
    private readonly element: HTMLElement,
  ) {}

  listen(): void {
    if (listening.length === 0) window.addEventListener("keydown", pressedKey);
    listening.push(this);
  }

  release(): void {
    listening.splice(listening.indexOf(this), 1);
    if (listening.length === 0) window.removeEventListener("keydown", pressedKey);
  }

  contains(target: Node): boolean {
    return this.element.contains(target);
  }

  /** Whether a key pressed is this playground's: it has the focus, or nothing has it and this is the first. */
  areFor(event: KeyboardEvent): boolean {
    return takerOf(placeOf(event)) === this;
  }

  /** True where the key was one of these. */
  take(key: string, on: Element): boolean {
    const { timeline, boards } = this.playground;
    if (key === " ") {
      if (on.closest("button, a, summary, [role=button]") !== null) return false;
      if (timeline.playing.value) timeline.pause();
      else timeline.play();
      return true;
    }
    // Arrows walk while somebody is the agent.
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
}

const others = `dialog, [role=tab], [role=slider], [role=application], [role=grid], [role=listbox], [role=radio]`;

const placeOf = ({ target }: Event): Element => (target instanceof Element ? target : document.body);

function takerOf(on: Element): PageKeys | undefined {
  const outside = on === document.body || on === document.documentElement;
  return listening.find((keys) => keys.contains(on)) ?? (outside ? listening[0] : undefined);
}

function pressedKey(event: KeyboardEvent): void {
  if (event.defaultPrevented || event.altKey || event.ctrlKey || event.metaKey) return;
  const on = placeOf(event);
  if (event.key === "?") {
    if (inField(event)) return;
    event.preventDefault();
    void openHelp();
    return;
  }
  if (
    event.shiftKey ||
    inField(event) ||
    on.closest(others) !== null ||
    document.querySelector("dialog:modal") !== null
  )
    return;
  if (takerOf(on)?.take(event.key, on)) event.preventDefault();
}
