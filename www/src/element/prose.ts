// Links, buttons, fields and numbers in the page's prose that drive a playground and follow it, by attributes alone:
// `data-mo-copp-for` names the playground by its id, `data-mo-copp-set-…` what a click sets (step, plan, problem …), and
// `data-mo-copp-show` what is shown or, in a field, shown and set.

const FOR = "data-mo-copp-for";
const SET = "data-mo-copp-set-";
const SHOW = "data-mo-copp-show";

/** What a click or a field may set: attributes of the element, or the step alone. */
const settable = new Set(["step", "plan", "problem", "src", "solver", "k", "j", "horizon", "theme"]);

interface Shown {
  step: number;
  steps: number;
  action: string | null;
  goals: Record<"adversarial" | "cooperative", string[]>;
  goal_difference: number;
}

/** Begins to follow `host`; returns how to stop. Nothing but the page's own words is changed, and those as text. */
export function followInProse(host: HTMLElement): () => void {
  const root = host.getRootNode() as Document | ShadowRoot;
  let last: Shown | null = null;
  const parts = (): HTMLElement[] =>
    host.id === "" ? [] : [...root.querySelectorAll<HTMLElement>(`[${FOR}="${CSS.escape(host.id)}"]`)];
  const show = () => {
    for (const part of parts()) write(part, host, last);
  };
  const stepped = (event: Event) => {
    if (event.target !== host) return;
    last = (event as CustomEvent<Shown>).detail;
    show();
  };
  const clicked = (event: Event) => {
    const part = partOf(event, parts());
    const wanted = part === undefined ? [] : changes(part);
    if (wanted.length === 0) return;
    event.preventDefault();
    set(host, wanted);
  };
  const typed = (event: Event) => {
    const part = partOf(event, parts());
    const name = part?.getAttribute(SHOW) ?? "";
    if (part instanceof HTMLInputElement && settable.has(name)) set(host, [[name, part.value]]);
  };
  const listeners: [EventTarget, string, (event: Event) => void][] = [
    [host, "mo-copp-step", stepped],
    [host, "mo-copp-outcome", show],
    [root, "click", clicked],
    [root, "input", typed],
  ];
  for (const [target, type, listener] of listeners) target.addEventListener(type, listener);
  return () => {
    for (const [target, type, listener] of listeners) target.removeEventListener(type, listener);
  };
}

const partOf = (event: Event, parts: readonly HTMLElement[]): HTMLElement | undefined =>
  parts.find((part) => event.composedPath().includes(part));

const changes = (part: Element): [name: string, value: string][] =>
  [...part.attributes]
    .filter(({ name }) => name.startsWith(SET) && settable.has(name.slice(SET.length)))
    .map(({ name, value }) => [name.slice(SET.length), value]);

/** An attribute that says so already was left by hand since: the step is asked for again all the same. */
function set(host: HTMLElement, wanted: readonly [name: string, value: string][]): void {
  for (const [name, value] of wanted) {
    if (name === "step" && host.getAttribute("step") === value) {
      void (host as HTMLElement & { goTo(step: number): Promise<void> }).goTo(Number(value));
    } else {
      host.setAttribute(name, value);
    }
  }
}

function write(part: HTMLElement, host: HTMLElement, shown: Shown | null): void {
  const step = part.getAttribute(`${SET}step`);
  if (step !== null) {
    if (shown !== null && Number(step) === shown.step) part.setAttribute("aria-current", "step");
    else part.removeAttribute("aria-current");
  }
  const name = part.getAttribute(SHOW);
  const value = name === null ? null : shownValue(name, host, shown);
  if (value === null) return;
  if (part instanceof HTMLInputElement) {
    if (name === "step" && shown !== null) part.max = String(shown.steps);
    part.value = value;
  } else if (part.textContent !== value) {
    part.textContent = value;
  }
}

function shownValue(name: string, host: HTMLElement, shown: Shown | null): string | null {
  if (name === "status") return host.dataset.status ?? null;
  if (name === "gd") return host.dataset.gd ?? "–";
  if (shown === null) return null;
  switch (name) {
    case "step":
      return String(shown.step);
    case "steps":
      return String(shown.steps);
    case "action":
      return shown.action ?? "–";
    case "adversarial":
    case "cooperative":
      return shown.goals[name].join(", ") || "–";
    case "adversarial-count":
      return String(shown.goals.adversarial.length);
    case "cooperative-count":
      return String(shown.goals.cooperative.length);
    default:
      return null;
  }
}
