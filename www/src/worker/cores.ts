// The two builds of the core. The page begins with the light one, which lacks PDDL and integer programs; the full one is
// fetched the first time something needs it, and does everything from then on. Which things need it, the light core says.
import initFull, { Problem as FullProblem } from "../../pkg/mo_copp.js";
import initLight, { Problem as LightProblem } from "../../pkg-light/mo_copp_light.js";

/** A core at work: it reads documents. */
export interface Core {
  Problem: new (document: string) => FullProblem;
}

const light: Core = { Problem: LightProblem };
const full: Core = { Problem: FullProblem };

const NOT_LOADED =
  "The part of the program for PDDL and integer programs could not be loaded. Your problem is as it was. " +
  "Check the connection, then try again.";

let current = light;
let loading: Promise<void> | null = null;

/** Loads the light core. */
export const loadLight = (): Promise<unknown> => initLight();

/** Whether an error is the light core's word that the full one is needed. */
const needsFullCore = (error: unknown) => error instanceof Error && error.name === "NeedsFullCore";

/**
 * Has the current core do some work; where that takes the full one, fetches it and begins again. `begun` is told of each
 * beginning, `fetching` of the wait between them; null is the answer when the work has become `stale` meanwhile.
 */
export async function onCore<T>(
  work: (core: Core) => T | Promise<T>,
  { begun, fetching, stale }: { begun: () => void; fetching: () => void; stale: () => boolean },
): Promise<T | null> {
  begun();
  try {
    return await work(current);
  } catch (error) {
    if (!needsFullCore(error)) throw error;
  }
  // Loading takes as long as the network does: nobody may be waiting in the end.
  if (stale()) return null;
  fetching();
  await toFullCore();
  if (stale()) return null;
  begun();
  return work(current);
}

/** One load for all who wait for it; a load that failed is tried again by the next. */
async function toFullCore(): Promise<void> {
  loading ??= initFull().then(() => {
    current = full;
  });
  try {
    await loading;
  } catch {
    loading = null;
    // Not one of the errors that say that a core is broken: the light one is as good as before.
    throw new Error(NOT_LOADED);
  }
}
