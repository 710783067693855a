// Puts a playground into the state that a link holds.
import { effect } from "@preact/signals-core";
import type { Gallery } from "../gallery/gallery.js";
import { initialPatience } from "../state/comparison.js";
import type { Edits } from "../state/edits.js";
import type { Exercise } from "../state/exercise.js";
import { emptyForm } from "../state/form.js";
import type { Plans } from "../state/plans.js";
import type { Solving } from "../state/solving.js";
import { initialExtra } from "../state/tradeoff.js";
import type { Walk } from "../state/walk.js";
import { LinkError } from "./packed.js";
import { planShown, readState, type SharedState, type SharedStores } from "./shared-state.js";

export interface RestoreStores extends SharedStores {
  edits: Edits;
  exercise: Exercise;
  gallery: Gallery;
  plans: Plans;
  walk: Walk;
}

/** Whose the plan is that no solver has found again. */
const LINK = "the plan of the link";

/** As `restore`, of a state as a script keeps it. */
export async function restoreText(playground: RestoreStores & { solving: Solving }, text: string): Promise<boolean> {
  try {
    return await restore(playground, readState(text));
  } catch (error) {
    if (!(error instanceof LinkError)) throw error;
    playground.solving.refuse("This state can’t be used: it holds no problem document.");
    return false;
  }
}

/** Nothing changes where the link's problem is not right: then the page says why, and false comes back. */
export async function restore(playground: RestoreStores, state: SharedState): Promise<boolean> {
  // What the link leaves out is as nobody touched it, whatever the page was used for before.
  const form = { ...emptyForm, ...state.form };
  const stop = showMeanwhile(playground, state);
  const solver = state.answered ? "chosen" : "exact";
  const right = await playground.edits.open(state.document, form, solver, "end", state.question ?? null);
  stop();
  const { again } = playground.answer;
  if (!right && again.value !== null) again.value = () => void restore(playground, state);
  if (!right) return false;
  if (playground.exercise.posed.value !== null) {
    if (state.answer !== undefined) await playground.exercise.resume(state.answer);
    return true;
  }
  const opened = playground.problem.document.value;
  // It may be one of the gallery's: then it has a name, and named plans.
  void playground.gallery.load();
  showSettings(playground, state);
  if (state.tab !== "") playground.workbench.open(state.tab);
  if (state.mode === "guess" && !opened?.closed) {
    // What the other was to guess is not in the link: another goal is drawn.
    await playground.guess.start();
    return true;
  }
  const { plan = [], title = LINK } = state;
  // What the solver has found again is its plan.
  const other = plan.length > 0 && (title !== LINK || !same(plan, planShown(playground)));
  // Who had only begun to walk has no plan yet.
  if (state.mode === "walk" || other) await showPlan(playground, plan, state);
  // Somebody may have gone on already.
  if (playground.problem.document.value === opened) playground.timeline.goTo(state.step);
  return true;
}

function showSettings({ tradeoff, comparison }: RestoreStores, { extra, patience }: SharedState): void {
  tradeoff.extra.value = extra ?? initialExtra;
  comparison.patience.value = patience === 0 ? Number.POSITIVE_INFINITY : (patience ?? initialPatience);
}

/** Shows the link's plan while a solver that takes long is at work. */
function showMeanwhile(playground: RestoreStores, { document, plan = [], title, step, mode }: SharedState): () => void {
  let begun = false;
  return effect(() => {
    const solving =
      playground.answer.status.value === "solving" && playground.problem.document.value?.text === document;
    if (begun || !solving || plan.length === 0 || mode !== "plan") return;
    begun = true;
    const wanted = () => playground.answer.status.value === "solving";
    void playground.plans.show(plan, title ?? LINK, wanted).then(() => wanted() && playground.timeline.goTo(step));
  });
}

async function showPlan(playground: RestoreStores, plan: string[], { mode, title }: SharedState): Promise<void> {
  if (mode === "walk") return playground.walk.resume(plan);
  await playground.plans.show(plan, title ?? LINK);
}

const same = (one: readonly string[], other: readonly string[]): boolean =>
  one.length === other.length && one.every((action, index) => action === other[index]);
