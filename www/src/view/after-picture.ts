// Once what has changed is on the screen.

/** Whoever looks at it has that long before anything else is done. */
const MOMENT_MS = 100;
/** Nothing is drawn while nobody looks. */
const UNSEEN_MS = 1000;

/** Settles a moment after the picture of what has just changed. */
export const afterPicture = (): Promise<void> =>
  new Promise((settle) => {
    setTimeout(settle, UNSEEN_MS);
    requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(settle, MOMENT_MS)));
  });
