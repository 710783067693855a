// The two observers, as the page speaks of them.
import type { Role } from "../problem/types.js";

export type { Role };

/** Whose board: the agent's own, or what an observer believes. */
export type BoardName = "actor" | Role;

export const roles: readonly Role[] = ["adversarial", "cooperative"];

export const called: Record<Role, string> = { adversarial: "enemy", cooperative: "friend" };
