// Whether each candidate goal survives for each observer at the step shown: one reading for every view,
// and the stable attributes that course styles and checks rely on.
import type { Scene, TraceStep } from "../core.js";
import type { Role } from "../view/observers.js";

export interface GoalView {
  name: string;
  isTrue: boolean;
  alive: Record<Role, boolean>;
  attributes: Record<Role, "alive" | "dead">;
}

export function goalViews(scene: Scene, step: TraceStep): GoalView[] {
  return scene.goals.map(({ name }) => {
    const alive = {
      adversarial: step.goals.adversarial.includes(name),
      cooperative: step.goals.cooperative.includes(name),
    };
    const word = (lives: boolean) => (lives ? "alive" : "dead");
    return {
      name,
      isTrue: name === scene.true_goal,
      alive,
      attributes: { adversarial: word(alive.adversarial), cooperative: word(alive.cooperative) },
    };
  });
}
