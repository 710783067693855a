// Fields of the page's prose: what one shows of a playground, and what a person has chosen in it.

type Field = HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement;

const isField = (part: Element): part is Field =>
  part instanceof HTMLInputElement || part instanceof HTMLSelectElement || part instanceof HTMLTextAreaElement;

/** One of several: its value stays, and it is chosen or not. */
const isChoice = (part: Element): part is HTMLInputElement =>
  part instanceof HTMLInputElement && (part.type === "radio" || part.type === "checkbox");

const isNumber = (part: Element): part is HTMLInputElement =>
  part instanceof HTMLInputElement && part.type === "number";

/** What a person has chosen or typed; null where there is nothing yet, as in a number that is being typed. */
export function chosenIn(part: Element): string | null {
  if (!isField(part) || !part.validity.valid) return null;
  if (isChoice(part)) return part.checked ? part.value : null;
  // A number may be typed as 1e1.
  if (isNumber(part) && part.value !== "") return String(part.valueAsNumber);
  // An empty text is the plan without actions.
  const nothing = part.value === "" && (part instanceof HTMLSelectElement || isNumber(part));
  return nothing ? null : part.value;
}

/** Whether a field is left with what is no number, or none that can be set. */
export const isUnusable = (part: Element): boolean => isNumber(part) && chosenIn(part) === null;

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
    if (part instanceof HTMLInputElement && most !== null)
      Object.assign(part, { min: part.min || "0", max: String(most) });
    part.value = value;
  } else if (part.textContent !== value && part.querySelector(holding) === null) {
    part.textContent = value;
  }
}

/** A label or a group holds fields of its own: no text takes their place. */
const holding = "input, select, textarea, button, output, progress, meter";
