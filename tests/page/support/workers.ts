// Workers that a test can reach or trouble.
import type { Page } from "playwright-core";

/** Workers that never hear of a cancel, as one in the middle of a long piece of work would not. */
export const withDeafWorkers = (page: Page) =>
  page.addInitScript(`
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (message) {
      if (message.kind !== "cancel") post.call(this, message);
    };
  `);

/** Workers that fetch the full core only when something needs it. */
export const withoutLookingAhead = (page: Page) =>
  page.addInitScript(`
    const send = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (message, ...rest) {
      if (message.kind !== "ahead") send.call(this, message, ...rest);
    };
  `);

/** Workers that a test finds in `window.workers`, in the order they were started; the one that got a solve last, in `lastSolver`. */
export const withKnownWorkers = (page: Page) =>
  page.addInitScript(`
    window.workers = [];
    const Original = window.Worker;
    window.Worker = class extends Original {
      constructor(...args) {
        super(...args);
        window.workers.push(this);
      }
      postMessage(message, ...others) {
        if (message.kind === "solve") window.lastSolver = this;
        super.postMessage(message, ...others);
      }
    };
  `);

/** Holds the core back from every worker that begins to load it from now on, until the page is told to let it go. */
export async function holdCore(page: Page): Promise<{ asked: Promise<void>; release: () => void }> {
  let release = (): void => undefined;
  let ask = (): void => undefined;
  const released = new Promise<void>((done) => {
    release = done;
  });
  const asked = new Promise<void>((done) => {
    ask = done;
  });
  await page.route("**/*.wasm", async (route) => {
    ask();
    await released;
    await route.continue();
  });
  return { asked, release };
}
