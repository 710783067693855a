// Once what has changed is on the screen.

/** Between the picture and other work. */
const MOMENT_MS = 100;
/** A page that is hidden draws nothing: then after this. */
const UNSEEN_MS = 1000;

/** Settles a moment after the picture of what has just changed. */
export const afterPicture = (): Promise<void> =>
  new Promise((settle) => {
    setTimeout(settle, UNSEEN_MS);
    requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(settle, MOMENT_MS)));
  });
