// Waiting for the page: until it is read, and until an element comes near what is seen of it.

/** An element that is this far away, in parts of the window's height, is near. */
const NEAR = "50%";

/** Until then an element may lack its children. */
export function whenParsed(): Promise<void> {
  if (document.readyState !== "loading") return Promise.resolve();
  return new Promise((resolve) => document.addEventListener("DOMContentLoaded", () => resolve(), { once: true }));
}

/** Calls `near` once; returns how to stop waiting. */
export function whenNear(element: Element, near: () => void): () => void {
  const observer = new IntersectionObserver(
    (entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
      observer.disconnect();
      near();
    },
    { rootMargin: `${NEAR} 0px` },
  );
  observer.observe(element);
  return () => observer.disconnect();
}
