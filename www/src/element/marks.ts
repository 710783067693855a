// What the element carries for checks and for styles of the page: `data-status`, `data-step`, `data-gd`, `data-exercise`.
import type { Playground } from "../playground/playground.js";

export function mark({ dataset }: HTMLElement, { answer, boards, exercise, problem, timeline }: Playground): void {
  // The last thing that was asked for: where it could not be done, `step` and `gd` are those of what is still shown.
  dataset.status = answer.status.value;
  dataset.step = String(timeline.step.value);
  const { posed, score } = exercise;
  const asked = posed.value !== null;
  const difference = boards.difference.value;
  if (asked || difference === null || problem.veiled.value) delete dataset.gd;
  else dataset.gd = String(difference);
  if (!asked) delete dataset.exercise;
  else dataset.exercise = score.value === null ? "open" : score.value === 1 ? "right" : "wrong";
}
