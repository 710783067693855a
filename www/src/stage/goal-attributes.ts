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

type Attribute = GoalView["attributes"][Role];

export const isKnown = (attribute: Attribute): attribute is "alive" | "dead" => attribute !== nothing;

/** The goals of a step are asked for by every view. */
const known = new WeakMap<TraceStep, { scene: Scene; goals: GoalView[] }>();

export function goalViews(scene: Scene, step: TraceStep): readonly GoalView[] {
  const found = known.get(step);
  if (found?.scene === scene) return found.goals;
  const goals = viewed(scene, step);
  known.set(step, { scene, goals });
  return goals;
}

function viewed(scene: Scene, step: TraceStep): GoalView[] {
  const secret = isGuessedAt(scene);
  const alive = { adversarial: new Set(step.goals.adversarial), cooperative: new Set(step.goals.cooperative) };
  const word = (lives: boolean) => (lives ? "alive" : "dead");
  return scene.goals.map(({ name }) => {
    const lives = { adversarial: alive.adversarial.has(name), cooperative: alive.cooperative.has(name) };
    return {
      name,
      isTrue: name === scene.true_goal,
      alive: lives,
      attributes: { adversarial: word(lives.adversarial), cooperative: secret ? nothing : word(lives.cooperative) },
    };
  });
}
