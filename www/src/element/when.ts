// Waiting for the page: until it is read, and until an element comes near what is seen of it.

/** An element that is this far away, in parts of the window's height, is near. */
const NEAR = "50%";

/** The least part of an element that is seen; the browser tells also of those that merely touch what is seen. */
const SOME = 1e-4;

/** What is in sight and has no area is looked at again after so long: nothing tells that a transform lets it grow. */
const AGAIN_MS = 250;

/** Until then an element may lack its children. */
export function whenParsed(): Promise<void> {
  if (document.readyState !== "loading") return Promise.resolve();
  return new Promise((resolve) => document.addEventListener("DOMContentLoaded", () => resolve(), { once: true }));
}

/** Signs of reading on. Before any of them what is out of sight may stay there. */
const signs = ["scroll", "keydown", "pointerdown"] as const;
let reading = false;

/** Calls `begun` at the first of the signs; at once where there was one. Returns how to stop waiting. */
function whenReading(begun: () => void): () => void {
  const begin = () => {
    reading = true;
    stop();
    begun();
  };
  // Scrolling does not bubble.
  const stop = () => {
    for (const sign of signs) window.removeEventListener(sign, begin, { capture: true });
  };
  if (reading) begun();
  else for (const sign of signs) window.addEventListener(sign, begin, { capture: true, passive: true });
  return stop;
}

/**
 * Calls `near` once: when the element is in sight or, once the page is being read, near it, or when the page is printed.
 * What is closed, clipped to nothing or has no size is not in sight.
 * Returns how to stop waiting.
 */
export function whenNear(element: Element, near: () => void): () => void {
  const paper = globalThis.matchMedia?.("print");
  const observers: IntersectionObserver[] = [];
  const come = () => {
    stop();
    near();
  };
  let later: ReturnType<typeof setTimeout> | undefined;
  const again = () => {
    for (const observer of observers) {
      observer.unobserve(element);
      observer.observe(element);
    }
  };
  const observe = (margin: string) => {
    const observer = new IntersectionObserver(
      (entries) => {
        if (entries.some(isToBeSeen)) return come();
        if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
        clearTimeout(later);
        later = setTimeout(again, AGAIN_MS);
      },
      { rootMargin: `${margin} 0px`, threshold: [0, SOME] },
    );
    observer.observe(element);
    observers.push(observer);
  };
  observe("0px");
  // What grows from nothing is no news to them.
  const sizes = new ResizeObserver(again);
  sizes.observe(element);
  const stopReading = whenReading(() => observe(NEAR));
  const stop = () => {
    stopReading();
    clearTimeout(later);
    sizes.disconnect();
    for (const observer of observers) observer.disconnect();
    window.removeEventListener("beforeprint", come);
    paper?.removeEventListener("change", come);
  };
  window.addEventListener("beforeprint", come);
  paper?.addEventListener("change", come);
  return stop;
}

/** A poster that is not loaded yet may leave an element without a height. */
const isToBeSeen = ({ isIntersecting, intersectionRect, boundingClientRect }: IntersectionObserverEntry): boolean =>
  isIntersecting && intersectionRect.width > 0 && (intersectionRect.height > 0 || boundingClientRect.height === 0);
