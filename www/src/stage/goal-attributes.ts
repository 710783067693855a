// What each observer holds of each candidate goal at the step shown: one reading for every view, and the stable
// attributes that course styles and checks rely on.
import { nothing } from "lit";
import type { Scene, TraceStep } from "../core.js";
import { isVeiled } from "../problem/veil.js";
import { type Role, roles } from "../view/observers.js";

/** `not now`: no state that is believed reaches the goal, and one may still lead to it. */
export type Standing = "possible" | "not now" | "ruled out";

export interface GoalView {
  name: string;
  isTrue: boolean;
  standing: Record<Role, Standing>;
  /** `nothing` where it is not told: the friend's to the enemy's player, both while a question hides them. */
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
  const veiled = isVeiled(scene);
  const secret = veiled || isGuessedAt(scene);
  const [enemys, friends] = roles.map((role) => standings(step, role));
  return scene.goals.map(({ name }) => {
    const standing = {
      adversarial: enemys?.get(name) ?? "not now",
      cooperative: friends?.get(name) ?? "not now",
    };
    return {
      name,
      isTrue: name === scene.true_goal,
      standing,
      attributes: {
        adversarial: veiled ? nothing : word(standing.adversarial),
        cooperative: secret ? nothing : word(standing.cooperative),
      },
    };
  });
}

/** Of the goals of which something is certain at a step. */
function standings({ goals, ruled_out }: TraceStep, role: Role): ReadonlyMap<string, Standing> {
  const known = new Map<string, Standing>();
  for (const name of ruled_out?.[role] ?? []) known.set(name, "ruled out");
  for (const name of goals[role]) known.set(name, "possible");
  return known;
}

const word = (standing: Standing) => (standing === "possible" ? "alive" : "dead");
