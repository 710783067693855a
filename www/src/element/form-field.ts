// What a form asks of a field: whether a required answer is there.

const MISSING = "Check an answer to this question first: its code is what the form sends.";

/** Where the browser shows what is missing: the button that checks an answer, once it is drawn. */
const anchorIn = (element: HTMLElement): HTMLElement | undefined =>
  (element.shadowRoot ?? element).querySelector<HTMLElement>(".exercise .answer button.primary") ?? undefined;

/** Says whether a required answer is missing. */
export function validate(element: HTMLElement, internals: ElementInternals, isMissing: boolean): void {
  if (isMissing) internals.setValidity({ valueMissing: true }, MISSING, anchorIn(element));
  else internals.setValidity({});
}
