// Whether each candidate goal survives for each observer at the step shown: one reading for every view,
// and the stable attributes that course styles and checks rely on.
import { nothing } from "lit";
import type { Scene, TraceStep } from "../core.js";
import type { Role } from "../view/observers.js";

export interface GoalView {
  name: string;
  isTrue: boolean;
  alive: Record<Role, boolean>;
  /** `nothing` where it is not known: the friend's while the enemy's player must not know it. */
  attributes: Record<Role, "alive" | "dead" | typeof nothing>;
}

/** While a goal is being guessed no scene says which is the true one, and no step what the friend knows. */
export const isGuessedAt = (scene: Scene): boolean => scene.true_goal === "";

export function goalViews(scene: Scene, step: TraceStep): GoalView[] {
  const secret = isGuessedAt(scene);
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
      attributes: { adversarial: word(alive.adversarial), cooperative: secret ? nothing : word(alive.cooperative) },
    };
  });
}
