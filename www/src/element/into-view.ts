// Bringing what was driven from elsewhere in the page into sight.

/** Whether most of an element, or most of the window with it, can be seen. */
export function isSeen(element: Element): boolean {
  const { top, bottom, height } = element.getBoundingClientRect();
  const seen = Math.min(bottom, innerHeight) - Math.max(top, 0);
  return seen >= 0.75 * Math.min(height, innerHeight);
}

const still = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** Scrolls no further than it takes, gently where that is wanted. */
export function bringIntoView(element: Element, block: ScrollLogicalPosition = "nearest"): void {
  const tall = element.getBoundingClientRect().height > innerHeight;
  element.scrollIntoView({ block: tall ? "start" : block, behavior: still() ? "instant" : "smooth" });
}
