// The plan on the boards, as an exercise is made of it.
import type { Shown } from "../state/exercise-subject.js";
import type { AuthorPanelStores } from "./stores.js";

export function shownOn({ problem, timeline, answer }: AuthorPanelStores): Shown | null {
  const document = problem.document.value?.value ?? null;
  const [scene, trace] = [problem.scene.value, timeline.trace.value];
  if (document === null || scene === null || trace === null) return null;
  return {
    document,
    steps: trace.steps,
    step: timeline.step.value,
    goals: scene.goals.map(({ name }) => name),
    trueGoal: scene.true_goal,
    best: answer.optimum.value?.outcome.goal_difference ?? null,
  };
}
