// What the scenarios ask of a browser: little enough that every engine's own driver can do it.

/**
 * A page in a browser. Expressions are JavaScript, run in the page with the names of `inPage`, and may be promises;
 * an element is an expression, too, for the playground's parts are in a shadow root that not every driver's selectors reach.
 */
export interface Driver {
  open(address: string): Promise<void>;
  /** The value of an expression, as JSON carries it. */
  evaluate<T>(expression: string): Promise<T>;
  /** A press of the mouse, by the browser itself, as a hand would. */
  click(element: string): Promise<void>;
  /** Text into a field, instead of what is in it. */
  type(element: string, text: string): Promise<void>;
  /** A key while the element has the focus. */
  press(element: string, key: Key): Promise<void>;
  /** The mouse pressed in the middle of one element and let go in that of another. */
  drag(from: string, to: string): Promise<void>;
  close(): Promise<void>;
}

/** An expression as the drivers send it: `all(selector, root?)` and `text(root?)` look into shadow roots as well. */
export const inPage = (expression: string) => `(() => {
  const roots = (root) =>
    [root, ...[...root.querySelectorAll("*")].flatMap((one) => (one.shadowRoot ? roots(one.shadowRoot) : []))];
  const all = (selector, root = document) =>
    roots(root.shadowRoot ?? root).flatMap((one) => [...one.querySelectorAll(selector)]);
  const text = (root = document.body) => roots(root.shadowRoot ?? root).map((one) => one.textContent).join(" ");
  return (${expression});
})()`;

/** The error for an element that is not there. */
export const missing = (element: string) => new Error(`not on the page: ${element}`);

export type Key = "ArrowLeft" | "ArrowRight" | "Home" | "End" | "Enter";

/** Viewport of every browser. */
export const SIZE = { width: 1280, height: 800 } as const;

const LIMIT_MS = 60_000;

/** Waits until an expression is true in the page; the error names what was waited for and what there was instead. */
export async function waitFor(driver: Driver, expression: string, what = expression): Promise<void> {
  // In the page itself: it looks again after each change of the document, and now and then.
  const held = await driver.evaluate<boolean>(`new Promise((resolve) => {
    const holds = () => { try { return Boolean(${expression}); } catch { return false; } };
    if (holds()) return resolve(true);
    const end = (found) => { observer.disconnect(); clearInterval(timer); clearTimeout(limit); resolve(found); };
    const look = () => { if (holds()) end(true); };
    const observer = new MutationObserver(look);
    observer.observe(document, { subtree: true, childList: true, attributes: true, characterData: true });
    const timer = setInterval(look, 200);
    const limit = setTimeout(() => end(holds()), ${LIMIT_MS});
  })`);
  if (held) return;
  const state = await driver.evaluate<string>(
    `JSON.stringify([...document.querySelectorAll("mo-copp-playground")].map((one) => ({ ...one.dataset })))`,
  );
  throw new Error(`waited for ${what}; the playgrounds are at ${state}`);
}
