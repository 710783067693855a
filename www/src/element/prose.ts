// Links, buttons, fields and numbers in the page's prose that drive a playground and follow it, by attributes alone:
// `data-mo-copp-for` names the playground by its id, `data-mo-copp-set-…` what a click sets (step, plan, problem …), and
// `data-mo-copp-show` what is shown or, in a field, shown and set.
import { differenceText } from "../view/numbers.js";
import { bringIntoView, isSeen } from "./into-view.js";
import { chosenIn, givesWay, isUnchecked, showIn } from "./prose-field.js";

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

/** What is shown as it is asked for. The step is told of once it is there. */
const ofAttributes = [...settable].filter((name) => name !== "step");

/** What names a problem: of these one is open. */
const addresses = ["src", "problem"] as const;
/** What belongs to one problem, and not to the next. */
const ofProblem = [...addresses, "plan", "step"] as const;

/** What each playground told last, wherever in the page it was moved since. */
const told = new WeakMap<HTMLElement, Shown>();

/** The solver that each was asked for last, by the page or by hand. */
const solvers = new WeakMap<HTMLElement, string | null>();
/** The solver where none is named. */
const DEFAULT_SOLVER = "exact";

interface Followed {
  /** Has a playground drawn that waits to be seen. */
  wake: () => void;
  /** Follows an attribute that says so already: since it was set, something else may have been chosen by hand. */
  again: (attribute: string) => void;
}

/** Begins to follow `host`; returns how to stop. Nothing but the page's own words is changed, and those as text. */
export function followInProse(host: HTMLElement, { wake, again }: Followed): () => void {
  const root = host.getRootNode() as Document | ShadowRoot;
  const selector = () => `[${FOR}="${CSS.escape(host.id)}"]`;
  const parts = (): HTMLElement[] => (host.id === "" ? [] : [...root.querySelectorAll<HTMLElement>(selector())]);
  const set = (wanted: readonly [name: string, value: string][]) => {
    for (const name of leftBy(wanted)) host.removeAttribute(name);
    for (const [name, value] of wanted) {
      if (host.getAttribute(name) === value) again(name);
      else host.setAttribute(name, value);
    }
  };
  /** What a field has taken the place of. */
  const before = new WeakMap<Element, string | null>();
  const show = () => {
    for (const part of parts()) write(part, host, told.get(host) ?? null);
  };
  const stepped = (event: Event) => {
    if (event.target !== host) return;
    told.set(host, (event as CustomEvent<Shown>).detail);
    show();
  };
  const solved = (event: Event) => {
    if (event.target !== host) return;
    solvers.set(host, (event as CustomEvent<{ solver: string }>).detail.solver);
    show();
  };
  /** A form sets its fields after it has said that it will. */
  const reset = () => setTimeout(show);
  const clicked = (event: Event) => {
    const part = partOf(event, parts());
    const wanted = part === undefined ? [] : changes(part);
    if (wanted.length === 0 || isForBrowser(event as MouseEvent)) return;
    event.preventDefault();
    set(wanted);
    wake();
    // What was done is to be seen.
    if (!isSeen(host)) bringIntoView(host);
  };
  const typed = (event: Event) => {
    const part = partOf(event, parts());
    const name = part?.getAttribute(SHOW) ?? "";
    if (part === undefined || !settable.has(name)) return;
    const value = chosenIn(part, name);
    if (value !== null) {
      before.set(part, host.getAttribute(name));
      set([[name, value]]);
    } else if (isUnchecked(part) && name !== "step") {
      const earlier = before.get(part) ?? null;
      if (earlier === null) host.removeAttribute(name);
      else host.setAttribute(name, earlier);
    } else return;
    wake();
  };
  /** A field that is left shows what is, and not what could not be. */
  const left = (event: Event) => {
    const part = partOf(event, parts());
    if (part !== undefined && givesWay(part, part.getAttribute(SHOW) ?? "")) write(part, host, told.get(host) ?? null);
  };
  const listeners: [EventTarget, string, (event: Event) => void][] = [
    [host, "mo-copp-step", stepped],
    [host, "mo-copp-outcome", solved],
    [root, "reset", reset],
    [root, "click", clicked],
    [root, "input", typed],
    [root, "change", left],
  ];
  for (const [target, type, listener] of listeners) target.addEventListener(type, listener, type === "reset");
  // Not every change of the status has an event.
  const state = new MutationObserver((records) => {
    if (records.some(({ attributeName }) => attributeName === "solver")) solvers.set(host, host.getAttribute("solver"));
    show();
  });
  state.observe(host, { attributes: true, attributeFilter: ["id", "data-status", "data-gd", ...ofAttributes] });
  // What comes into the prose later.
  const prose = new MutationObserver((records) => {
    if (host.id !== "" && records.some((record) => brings(record, selector()))) show();
  });
  prose.observe(root, { childList: true, subtree: true, attributes: true, attributeFilter: [FOR, SHOW, `${SET}step`] });
  show();
  return () => {
    for (const [target, type, listener] of listeners) target.removeEventListener(type, listener, type === "reset");
    state.disconnect();
    prose.disconnect();
  };
}

const brings = ({ type, addedNodes }: MutationRecord, selector: string): boolean =>
  type === "attributes" ||
  [...addedNodes].some(
    (node) => node instanceof Element && (node.matches(selector) || node.querySelector(selector) !== null),
  );

/** A click that opens a link elsewhere: in another tab or window, or as a file. */
const isForBrowser = ({ ctrlKey, metaKey, shiftKey, altKey }: MouseEvent): boolean =>
  ctrlKey || metaKey || shiftKey || altKey;

/** The innermost: a label may hold a field. */
const partOf = (event: Event, parts: readonly HTMLElement[]): HTMLElement | undefined =>
  event
    .composedPath()
    .map((at) => parts.find((part) => part === at))
    .find((part) => part !== undefined);

const changes = (part: Element): [name: string, value: string][] =>
  [...part.attributes]
    .filter(({ name }) => name.startsWith(SET) && settable.has(name.slice(SET.length)))
    .map(({ name, value }) => [name.slice(SET.length), value]);

/** What was set before and is none of another problem: of `src` and `problem` the last one counts. */
function leftBy(wanted: readonly [name: string, value: string][]): string[] {
  const names = wanted.map(([name]) => name);
  return names.some((name) => isOneOf(addresses, name)) ? ofProblem.filter((name) => !names.includes(name)) : [];
}

const isOneOf = (names: readonly string[], name: string): boolean => names.includes(name);

function write(part: HTMLElement, host: HTMLElement, shown: Shown | null): void {
  const step = part.getAttribute(`${SET}step`);
  if (step !== null) {
    if (shown !== null && Number(step) === shown.step && isOfSame(part, host))
      part.setAttribute("aria-current", "step");
    else part.removeAttribute("aria-current");
  }
  const name = part.getAttribute(SHOW);
  const value = name === null ? null : shownValue(name, host, shown);
  if (value !== null) showIn(part, value, name === "step" ? (shown?.steps ?? null) : null);
}

/** Whether a link is to what the playground shows, and not to another plan or problem, or to one that did not come. */
function isOfSame(part: Element, host: HTMLElement): boolean {
  const [src, problem, plan] = ["src", "problem", "plan"].map((name) => part.getAttribute(SET + name));
  const names = src !== null || problem !== null;
  if (!names && plan === null) return true;
  if (host.dataset.status === "error" || host.dataset.status === "solving") return false;
  const asked = {
    src: host.getAttribute("src"),
    problem: host.getAttribute("problem"),
    plan: host.getAttribute("plan"),
  };
  // A link to a problem without a plan leads to its best one.
  if (plan !== asked.plan) return false;
  if (!names) return true;
  return src === null ? asked.src === null && problem === asked.problem : src === asked.src;
}

function shownValue(name: string, host: HTMLElement, shown: Shown | null): string | null {
  if (name === "status") return host.dataset.status ?? null;
  if (name === "theme") return host.getAttribute(name) ?? "auto";
  if (name === "solver") return solvers.get(host) ?? host.getAttribute(name) ?? DEFAULT_SOLVER;
  if (isOneOf(ofAttributes, name)) return host.getAttribute(name);
  if (shown === null) return null;
  switch (name) {
    case "gd":
      return host.dataset.gd === undefined ? "–" : differenceText(Number(host.dataset.gd));
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
