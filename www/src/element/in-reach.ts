// Whether a pointer could reach something now: it is drawn, in the window, and nothing that is modal or inert keeps it away.

/** Where it is looked for across what of it is in the window. */
const PARTS = [0.1, 0.3, 0.5, 0.7, 0.9];

export function isInReach(element: Element): boolean {
  const { left, top, right, bottom } = element.getBoundingClientRect();
  const [begin, end] = [Math.max(0, left), Math.min(innerWidth, right)];
  const [first, last] = [Math.max(0, top), Math.min(innerHeight, bottom)];
  if (begin >= end || first >= last) return false;
  const around = element.getRootNode() as Document | ShadowRoot;
  return PARTS.some((down) =>
    PARTS.some((across) => {
      const hit = around.elementFromPoint(begin + across * (end - begin), first + down * (last - first));
      return hit !== null && element.contains(hit);
    }),
  );
}
