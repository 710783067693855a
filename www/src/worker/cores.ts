// The two builds of the core. The page begins with the light one, which is built for size and has exact search for one
// best plan alone, without PDDL. The full one is built for speed; it is fetched where something needs it, or in a pause that the page tells of,
// and does everything from then on. Which things need it, the light core says.

import initFull, { Exercise as FullExercise, Problem as FullProblem, seedOf } from "../../pkg/mo_copp.js";
import initLight, { Problem as LightProblem } from "../../pkg-light/mo_copp_light.js";
import type { Elimination, Nearest } from "../core.js";
import { faultOf, NotLoaded } from "./not-loaded.js";
import type { CoreMessage } from "./protocol.js";

/** What the worker asks of a problem. */
export interface Problem extends FullProblem {
  elimination(plan: string[], observer: string, goal: string, step: number): Elimination | null;
  nearest(plan: string[], observer: string, goal: string, step: number): Nearest | null;
}

/** A core at work: it reads documents. */
export interface Core {
  Problem: new (document: string) => Problem;
  /** Exercises, which the full core alone has. */
  exercises: Exercises | null;
}

export interface Exercises {
  Exercise: new (document: string, seed: number) => FullExercise;
  seedOf: (name: string) => number;
}

// Both are built from the same bindings.
const light = { Problem: LightProblem, exercises: null } as unknown as Core;
const full = { Problem: FullProblem, exercises: { Exercise: FullExercise, seedOf } } as unknown as Core;

const NOT_LOADED =
  "The part of the program for PDDL, exercises and other solvers could not be loaded. Your problem is as it was.";
const CHECK = "Check the connection, then try again.";

let current = light;
let loading: Promise<void> | null = null;

/** Settles for each core when the page has told where it is, or sent it. */
const sent = { light: waits(), full: waits() };
let ask = () => {};

/**
 * Loads the core with which work begins: the one that the page tells of first. A page that tells of the full one alone
 * has it used for everything.
 */
export async function loadFirst(askForFull: () => void): Promise<void> {
  ask = askForFull;
  const { light, full } = sent;
  const starts = [
    light.promise.then((core) => () => startLight(core)),
    full.promise.then((core) => () => startFull(core)),
  ];
  const start = await Promise.race(starts);
  await start();
}

/** What the page sent. */
export function takeCore(message: CoreMessage): void {
  const { resolve, reject } = sent[message.kind];
  if (message.core !== null) {
    resolve(message.core);
    return;
  }
  reject(new NotLoaded(message.error));
  sent[message.kind] = waits();
}

/** Whether an error is the light core's word that the full one is needed. */
const needsFullCore = (error: unknown) => error instanceof Error && error.name === "NeedsFullCore";

/** The exercises of a core; the light one's word that the full one is needed. */
export function exercisesOf({ exercises }: Core): Exercises {
  if (exercises !== null) return exercises;
  throw Object.assign(new Error("exercises need the full core"), { name: "NeedsFullCore" });
}

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

/** Fetches the full core before something needs it. A core that does not come is no fault until then. */
export function lookAhead(): void {
  if (current === light) toFullCore().catch(() => undefined);
}

/** One load for all who wait for it; a load that failed is tried again by the next. */
async function toFullCore(): Promise<void> {
  loading ??= askForFull();
  try {
    await loading;
  } catch (error) {
    loading = null;
    throw new NotLoaded(`${NOT_LOADED} ${error instanceof NotLoaded ? `${error.message}.` : CHECK}`);
  }
}

function askForFull(): Promise<void> {
  ask();
  return sent.full.promise.then(startFull);
}

async function startLight(core: CoreFile): Promise<void> {
  await initLight({ module_or_path: await comes(core) });
}

async function startFull(core: CoreFile): Promise<void> {
  await initFull({ module_or_path: await comes(core) });
  current = full;
}

/** The address of a core, or its bytes. */
type CoreFile = string | BufferSource;

/** A host may answer with something else, and that is no broken core. */
async function comes(core: CoreFile): Promise<Response | BufferSource> {
  if (typeof core !== "string") return core;
  const response = await fetch(core).catch(() => {
    throw new NotLoaded(`${core} could not be loaded. ${CHECK.replace(/\.$/, "")}`);
  });
  const fault = faultOf(response);
  if (fault !== null) throw new NotLoaded(fault);
  return response;
}

interface Waits {
  promise: Promise<CoreFile>;
  resolve: (core: CoreFile) => void;
  reject: (error: Error) => void;
}

function waits(): Waits {
  const parts: Partial<Waits> = {};
  const promise = new Promise<CoreFile>((resolve, reject) => Object.assign(parts, { resolve, reject }));
  // It is asked for when it is needed; until then a refusal is no error.
  promise.catch(() => undefined);
  return { ...parts, promise } as Waits;
}
