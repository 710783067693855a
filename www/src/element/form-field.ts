// What a form asks of a field, and what its page hears from it: whether a required answer is there, and that it changed.

const MISSING = "Check an answer to this question first: its code is what the form sends.";

/** Where the browser shows what is missing: the button that checks an answer, once it is drawn. */
const anchorIn = (element: HTMLElement): HTMLElement | undefined =>
  (element.shadowRoot ?? element).querySelector<HTMLElement>(".exercise .answer button.primary") ?? undefined;

/** Says whether a required answer is missing. */
export function validate(element: HTMLElement, internals: ElementInternals, isMissing: boolean): void {
  if (isMissing) internals.setValidity({ valueMissing: true }, MISSING, anchorIn(element));
  else internals.setValidity({});
}

/** What the controls in the element tell of themselves is no word of the element's value, and stays in it. */
const ofControls = ["input", "beforeinput"] as const;

export function keepInside(root: HTMLElement): void {
  for (const type of ofControls) root.addEventListener(type, (event) => event.stopPropagation());
}

/** Says that the person has given another value, as other fields do. */
export function tellChange(element: HTMLElement): void {
  element.dispatchEvent(new Event("input", { bubbles: true, composed: true }));
  element.dispatchEvent(new Event("change", { bubbles: true }));
}
