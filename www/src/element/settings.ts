// What a page asks of a playground by the element's attributes.

import type { Playground } from "../playground/playground.js";
import { inFile } from "../share/fault-words.js";
import { emptyForm, type Form, solverNames } from "../state/form.js";
import { fitted } from "../state/numbers.js";
import { brief } from "../view/names.js";
import type { Seed } from "../worker/protocol.js";
import { isOn, isStep, no, propertiesAlone, settingNames } from "./attributes.js";
import { fetched } from "./fetched.js";
import { type KeyReach, keyReaches } from "./page-keys.js";
import { themes } from "./theme.js";

/** The document in the element itself: `<script type="application/json">`. */
export const inline = (host: Element): string | null =>
  host.querySelector(":scope > script[type='application/json']")?.textContent ?? null;

/** The parts that can be left out, by `hide`. */
export const parts = [
  "gallery",
  "share",
  "tools",
  "stepper",
  "legend",
  "workbench",
  "goals",
  "enemy",
  "friend",
  "counts",
] as const;
export type Part = (typeof parts)[number];

export interface Settings {
  /** The address of a document, relative to the page. */
  src: string | null;
  /** A problem of the gallery. */
  problem: string | null;
  /** The title of one of the gallery's plans, or actions separated by commas. */
  plan: string | null;
  step: string | null;
  solver: string | null;
  k: string | null;
  j: string | null;
  horizon: string | null;
}

export function settingsOf(element: Element): Settings {
  return Object.fromEntries(settingNames.map((name) => [name, element.getAttribute(name)])) as unknown as Settings;
}

/** The same of these attributes alone. */
export function settingsAmong(element: Element, names: ReadonlySet<string>): Settings {
  const among = settingNames.map((name) => [name, names.has(name) ? element.getAttribute(name) : null]);
  return Object.fromEntries(among) as unknown as Settings;
}

/** Of `src` and `problem` the one that was set last counts; of both together the former. */
export function leaveOther(element: Element, changed: ReadonlySet<string>): void {
  const [src, problem] = ["src", "problem"].map((name) => changed.has(name) && element.hasAttribute(name));
  if (src) element.removeAttribute("problem");
  else if (problem) element.removeAttribute("src");
}

/** The variant of an exercise that the attributes ask for: that of a student before that of a number. */
export function seedOf(element: Element): Seed {
  const student = element.getAttribute("student");
  if (student !== null && student.trim() !== "") return { name: student };
  return wholeNumberOf(element.getAttribute("seed") ?? "") ?? 0;
}

/** Whether it is the playground's own page, and no frame of another one. */
export const isOwnPage = (element: Element): boolean =>
  element.getAttribute("root") === "page" && window.parent === window;

/** Whether a student may say whose variant it is: on the playground's own page, where its address does not. A page around a frame has its own way. */
export const leavesSeed = (element: Element): boolean =>
  isOwnPage(element) && !element.hasAttribute("seed") && !element.hasAttribute("student");

const wholeNumberOf = (text: string): number | null => (/^\s*\d{1,15}\s*$/.test(text) ? Number(text) : null);

/** The playground that has the page's address has its keys, unless the page says otherwise. */
export function keyReachOf(element: Element): KeyReach {
  const asked = element.getAttribute("keys");
  return keyReaches.find((reach) => reach === asked) ?? (element.getAttribute("link") === "off" ? "focus" : "page");
}

export function hiddenParts(text: string | null): ReadonlySet<string> {
  return new Set((text ?? "").split(/[\s,]+/));
}

/** What also stands in the `hide` of an address: the page's own parts (site.ts). */
const pageParts = ["intro", "footer"] as const;

/** Words that are as good as none at all are among them. */
const links = ["on", "off"] as const;
const loadings = ["lazy", "eager"] as const;
/** How HTML, and the tools that write it, say that an attribute without a value is there. */
const yes = ["", "watch", "true"] as const;

/** `watch` invites to watch the first problem; where steps can't be walked through, their end is all there is to see. */
export const opensAt = (element: Element): "first" | "end" =>
  isOn(element, "watch") && !hiddenParts(element.getAttribute("hide")).has("stepper") ? "first" : "end";

/** Where else a page says what is a property. */
const INSIDE = ", or stands in the element, as a script of the type application/json";
const elsewhere = { document: INSIDE, state: "" } as const;

/** What is open. */
interface Open {
  /** How many goals the problem has; null while there is none. */
  goals: number | null;
  /** Whether there is a question, or there may be one. */
  asks: boolean;
}

/** What of these attributes can't be used: a sentence for each that says what was expected. */
export function mistakes(element: Element, names: ReadonlySet<string>, { goals, asks }: Open): string[] {
  const value = (name: string) => (names.has(name) ? element.getAttribute(name) : null);
  const [solver, step, theme, keys] = [value("solver"), value("step"), value("theme"), value("keys")];
  const [seed, student, watch, root] = [value("seed"), value("student"), value("watch"), value("root")];
  const found: string[] = [];
  if (solver !== null && !isOneOf(solverNames, solver)) found.push(unusable("solver", solver, solverNames.join(", ")));
  if (step !== null && stepOf(step) === null) found.push(unusable("step", step, "a whole number from 0"));
  if (theme !== null && !isOneOf(themes, theme)) found.push(unusable("theme", theme, themes.join(", ")));
  if (keys !== null && !isOneOf(keyReaches, keys)) found.push(unusable("keys", keys, keyReaches.join(", ")));
  if (seed !== null && wholeNumberOf(seed) === null) found.push(unusable("seed", seed, "a whole number from 0"));
  if (student?.trim() === "") found.push(unusable("student", student, "a name; without one the attribute is left out"));
  if (watch !== null && watch !== no && !isOneOf(yes, watch))
    found.push(
      unusable("watch", watch, "no value: the attribute alone says yes, and no attribute, or “false”, says no"),
    );
  if (root !== null && root !== "page")
    found.push(unusable("root", root, "page, which is for the playground’s own page alone"));
  if (names.has("required") && isOn(element, "required") && !asks)
    found.push("“required” is for a question, and none is asked here: a form is sent without an answer.");
  for (const [name, words] of Object.entries({ link: links, loading: loadings })) {
    const word = value(name);
    if (word !== null && !isOneOf(words, word)) found.push(unusable(name, word, words.join(", ")));
  }
  for (const name of ["k", "j"]) {
    const text = (value(name) ?? "").trim();
    if (goals === null || !/^\d+$/.test(text) || Number(text) <= goals) continue;
    found.push(unusable(name, brief(text), `a whole number from 1 to ${goals}`));
  }
  for (const name of propertiesAlone) {
    if (value(name) === null) continue;
    found.push(
      `“${name}” is no attribute but a property: it is set by a script (element.${name} = …)${elsewhere[name]}.`,
    );
  }
  for (const part of hiddenParts(value("hide"))) {
    const known = part === "" || isOneOf(parts, part) || isOneOf(pageParts, part);
    if (!known) found.push(unusable("hide", part, `parts of the playground: ${parts.join(", ")}`));
  }
  return found;
}

const isOneOf = (names: readonly string[], text: string): boolean => names.includes(text);

const unusable = (name: string, text: string, expected: string): string =>
  `“${text}” can’t be used for the attribute ${name}; expected ${expected}.`;

const stepOf = (text: string): number | null => (isStep(text) ? Number(text) : null);

interface Settling {
  /** Whether these settings are still the last ones asked for; when they are not, the rest is left to those that came after. */
  wanted: () => boolean;
  /** Asks for them once more. */
  again: () => void;
  /** Told of the text of the document before it is opened. */
  read: (text: string) => void;
  /** Opens what the attributes are of, where that is more than a document. */
  open?: () => Promise<boolean>;
}

/**
 * Opens what the attributes ask for; without any, what the page begins with. `at`: which step is shown then. False where
 * it came to no end; what was missing may be there the next time.
 */
export async function settle(
  playground: Playground,
  settings: Settings,
  fallback: string,
  at: "first" | "end",
  settling: Settling,
): Promise<boolean> {
  const { wanted, again, open } = settling;
  const { answer } = playground;
  const opened = await (open?.() ?? openProblem(playground, settings, fallback, at, settling));
  if (!wanted()) return false;
  if (answer.again.value !== null) answer.again.value = again;
  if (!opened) return false;
  // A question is neither solved nor shown a plan.
  if (playground.exercise.posed.value !== null) return true;
  const form = formOf(settings);
  if (Object.keys(form).length > 0) {
    // Bounds that no plan can keep are said (mistakes), and the solver does without.
    const scene = playground.problem.scene.value;
    playground.solving.edit({ ...form, ...(scene === null ? null : fitted({ ...emptyForm, ...form }, scene)) });
    await playground.solving.solve(at);
    if (!wanted()) return false;
  }
  if (settings.plan !== null && answer.again.value === null) await showPlan(playground, settings.plan, at, wanted);
  if (!wanted()) return false;
  if (answer.again.value !== null) answer.again.value = again;
  return answer.again.value === null;
}

/** The text of the document that the attributes ask for; null where it could not be loaded, or they ask for none. */
export async function documentOf({ gallery }: Playground, { src, problem }: Settings): Promise<string | null> {
  if (src !== null) return (await fetched(src)).text ?? null;
  if (problem === null) return null;
  if (!gallery.documents.value.has(problem)) await gallery.load();
  return gallery.documents.value.get(problem)?.text ?? null;
}

export function goToStep({ timeline }: Playground, { step }: Settings): void {
  const wanted = step === null ? null : stepOf(step);
  if (wanted !== null) timeline.goTo(wanted);
}

/** Until then one waits without a word. */
const LATE_MS = 4000;

const notYet = (src: string): string => `Still waiting for the problem document “${brief(src)}”.`;

async function openProblem(
  playground: Playground,
  { src, problem }: Settings,
  fallback: string,
  at: "first" | "end",
  { wanted, again, read }: Settling,
): Promise<boolean> {
  const { gallery } = playground;
  if (src !== null) {
    const isSilent = () => wanted() && playground.answer.error.value === null;
    const late = setTimeout(() => isSilent() && playground.solving.remark(notYet(src)), LATE_MS);
    const { text, fault, mayCome } = await fetched(src);
    clearTimeout(late);
    if (!wanted()) return false;
    if (text !== undefined) read(text);
    if (text !== undefined) return openFetched(playground, src, text, at, wanted);
    playground.solving.refuse(fault, mayCome ? again : null);
    return false;
  }
  if (problem === null) read(fallback);
  if (problem === null) return playground.edits.open(fallback, {}, "exact", at);
  if (!gallery.documents.value.has(problem)) await gallery.load();
  return wanted() && gallery.open(problem, at);
}

/** What is wrong with a document is said with its address and the line. */
async function openFetched(
  { answer, draft, edits }: Playground,
  src: string,
  text: string,
  at: "first" | "end",
  wanted: () => boolean,
): Promise<boolean> {
  if (await edits.open(text, {}, "exact", at)) return true;
  const said = answer.error.peek();
  if (said === null || answer.again.value !== null || !wanted()) return false;
  const fault = await draft.faultOf(text);
  if (answer.error.peek() === said)
    answer.error.value = said === fault?.message ? inFile(src, text, fault) : `“${brief(src)}”: ${said}`;
  return false;
}

function formOf({ solver, k, j, horizon }: Settings): Partial<Form> {
  const known = solverNames.find((name) => name === solver);
  return {
    ...(known === undefined ? {} : { solver: known }),
    ...(k === null ? {} : { k }),
    ...(j === null ? {} : { j }),
    ...(horizon === null ? {} : { horizon: horizon === "any" ? "" : horizon }),
  };
}

async function showPlan(
  playground: Playground,
  plan: string,
  at: "first" | "end",
  wanted: () => boolean,
): Promise<void> {
  const { gallery, plans, answer } = playground;
  const titled = gallery.current.value?.plans ?? [];
  const named = titled.find(({ title }) => title === plan);
  if (named !== undefined) return gallery.show(named, at);
  // An empty text is the plan without actions.
  const actions = plan.trim() === "" ? [] : plan.split(",").map((action) => action.trim());
  const fault = await plans.show(actions, "The plan of this page", wanted, at);
  if (fault === null || answer.error.peek() !== fault) return;
  const titles = titled.map(({ title }) => `“${title}”`).join(", ");
  const expected = `${titles === "" ? "" : `the title of a plan (${titles}) or `}actions separated by commas`;
  answer.error.value = `${unusable("plan", brief(plan), expected)} As actions: ${fault}`;
}
