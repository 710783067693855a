// Fields of the page's prose: what one shows of a playground, and what a person has chosen in it.
import { isStep } from "./attributes.js";

type Field = HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement;

const isField = (part: Element): part is Field =>
  part instanceof HTMLInputElement || part instanceof HTMLSelectElement || part instanceof HTMLTextAreaElement;

/** One of several: its value stays, and it is chosen or not. */
const isChoice = (part: Element): part is HTMLInputElement =>
  part instanceof HTMLInputElement && (part.type === "radio" || part.type === "checkbox");

const isNumber = (part: Element): part is HTMLInputElement =>
  part instanceof HTMLInputElement && part.type === "number";

/** Anything may be typed into it. */
const isText = (part: Element): part is HTMLInputElement | HTMLTextAreaElement =>
  part instanceof HTMLTextAreaElement || (part instanceof HTMLInputElement && part.type === "text");

/** What is a number, and what is expected then. */
const numbers: Record<string, [fits: (text: string) => boolean, expected: string]> = {
  step: [isStep, "a whole number from 0"],
  k: [(text) => /^\s*\d*\s*$/.test(text), "a whole number"],
  j: [(text) => /^\s*\d*\s*$/.test(text), "a whole number"],
  horizon: [(text) => /^\s*(?:\d*|any)\s*$/.test(text), "a whole number, or any"],
};

/** Fields that say themselves that what is typed in them can't be used, and whether the words are from here: others are the browser's or the page's. */
const marked = new WeakMap<Field, boolean>();

/** What a person has chosen or typed for `name`; null where there is nothing yet, or what can't be used, which the field says. */
export function chosenIn(part: Element, name: string): string | null {
  if (!isField(part)) return null;
  unmark(part);
  if (isChoice(part)) return part.validity.valid && part.checked ? part.value : null;
  // None is chosen yet, or typed. An empty text is the plan without actions.
  if (part.value === "" && part.validity.valid && (!isText(part) || name === "step")) return null;
  const fault = faultIn(part, name);
  if (fault !== null) {
    mark(part, fault);
    return null;
  }
  // A number may be typed as 1e1.
  return isNumber(part) ? String(part.valueAsNumber) : part.value;
}

/** Why what a field holds can't be set. */
function faultIn(part: Field, name: string): string | null {
  const { valid, rangeOverflow, badInput, stepMismatch, customError } = part.validity;
  // A step beyond the last one is the last.
  const beyond = name === "step" && rangeOverflow && !badInput && !stepMismatch && !customError;
  if (!valid && !beyond) return part.validationMessage;
  const [fits, expected] = numbers[name] ?? [];
  return !isText(part) || fits === undefined || fits(part.value)
    ? null
    : `“${part.value}” can’t be used here; expected ${expected}.`;
}

/** The field itself says what is wrong with it, and the playground stays as it is. */
function mark(part: Field, fault: string): void {
  const isSound = part.validity.valid;
  if (isSound) part.setCustomValidity(fault);
  part.setAttribute("aria-invalid", "true");
  marked.set(part, isSound);
}

function unmark(part: Field): void {
  const isOurs = marked.get(part);
  if (!marked.delete(part)) return;
  if (isOurs) part.setCustomValidity("");
  part.removeAttribute("aria-invalid");
}

/** Whether a field is left with what can't be used, or what may not be what came of it: it shows what is then. */
export function givesWay(part: Element, name: string): boolean {
  if (!isField(part)) return false;
  const isTyped = isNumber(part) || isText(part);
  return marked.has(part) || (isNumber(part) && part.value === "") || (isTyped && name === "step");
}

/** Whether a person has taken back what a field sets. */
export const isUnchecked = (part: Element): boolean =>
  part instanceof HTMLInputElement && part.type === "checkbox" && !part.checked;

/** Shows a value in a field or as text. `most`: the largest that it can become, where it is a number that has one. */
export function showIn(part: Element, value: string, most: number | null): void {
  if (isChoice(part)) part.checked = part.value === value;
  else if (part instanceof HTMLProgressElement || part instanceof HTMLMeterElement) {
    if (most !== null) part.max = most;
    if (Number.isFinite(Number(value))) part.value = Number(value);
  } else if (isField(part)) {
    // What is typed into a file's field is the person's alone.
    if (part.type === "file") return;
    // A marked field keeps its text while it has the focus.
    if (marked.has(part) && part.matches(":focus")) return;
    unmark(part);
    if (part instanceof HTMLInputElement && most !== null)
      Object.assign(part, { min: part.min || "0", max: String(most) });
    part.value = value;
  } else if (part.textContent !== value && part.querySelector(holding) === null) {
    part.textContent = value;
  }
}

/** A label or a group holds fields of its own: no text takes their place. */
const holding = "input, select, textarea, button, output, progress, meter";
