// Waiting for the page: until it is read, and until an element comes near what is seen of it.

/** An element that is this far away, in parts of the window's height, is near. */
const NEAR = "50%";

/** Until then an element may lack its children. */
export function whenParsed(): Promise<void> {
  if (document.readyState !== "loading") return Promise.resolve();
  return new Promise((resolve) => document.addEventListener("DOMContentLoaded", () => resolve(), { once: true }));
}

/** Calls `near` once: when the element comes near what is seen, or the page is printed. Returns how to stop waiting. */
export function whenNear(element: Element, near: () => void): () => void {
  const paper = globalThis.matchMedia?.("print");
  const stop = () => {
    observer.disconnect();
    window.removeEventListener("beforeprint", come);
    paper?.removeEventListener("change", come);
  };
  const come = () => {
    stop();
    near();
  };
  const observer = new IntersectionObserver(
    (entries) => {
      if (entries.some(({ isIntersecting }) => isIntersecting)) come();
    },
    { rootMargin: `${NEAR} 0px` },
  );
  observer.observe(element);
  window.addEventListener("beforeprint", come);
  paper?.addEventListener("change", come);
  return stop;
}
