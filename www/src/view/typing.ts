// Whether an event comes from where text is typed. Some text fields stand in a shadow root, from which an event is seen
// to come from the element around it.
export const composedFrom = (event: Event, selector: string): boolean =>
  event.composedPath().some((place) => place instanceof Element && place.matches(selector));

const texts = "textarea, [contenteditable=''], [contenteditable=true]";

/** Keys are letters there, or have a meaning of their own. */
export const inField = (event: Event): boolean => composedFrom(event, `input, select, ${texts}`);

/** Text fields take back what was typed in them by themselves. */
export const inText = (event: Event): boolean =>
  composedFrom(event, `${texts}, input:not([type=range], [type=checkbox], [type=radio], [type=button], [type=file])`);
