// What the keyboard comes to is not left behind the bar of the steps, which stays at the window's edge. (A browser takes
// what lies behind it for seen.)

/** Room between the two, in pixels. */
const ROOM = 8;

export function keepInSight(root: ParentNode): (event: FocusEvent) => void {
  return ({ target }) => {
    const bar = root.querySelector(".stepper");
    if (!(target instanceof Element) || bar === null || bar.contains(target) || !target.matches(":focus-visible"))
      return;
    const [at, over] = [target.getBoundingClientRect(), bar.getBoundingClientRect()];
    const behind = at.bottom > over.top && at.top < over.bottom && at.right > over.left && at.left < over.right;
    // A board that is higher than what is left of the window is seen all the same.
    if (behind && at.height < over.top - ROOM) scrollBy({ top: at.bottom - over.top + ROOM });
  };
}
