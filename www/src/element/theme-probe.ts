// What feels a change of the page's colours that no event tells of: a style sheet that a script switches off, adopts or
// writes into. It is nothing to see; the colours that come down to it from the page change by a transition of their own,
// and the browser tells where that begins.

export const probeStyle = `.probe { position: absolute; width: 0; height: 0; overflow: hidden; visibility: hidden;
  background-color: light-dark(#fff, #000); transition: color 1ms, background-color 1ms; }`;

/** Tells each time that the text's colour or the color-scheme of the page has changed around the playground. */
export function probe(changed: () => void): HTMLElement {
  const made = document.createElement("div");
  made.className = "probe";
  made.setAttribute("aria-hidden", "true");
  made.addEventListener("transitionrun", changed);
  return made;
}
