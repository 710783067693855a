// The two observers, as the page speaks of them.
import type { Role } from "../problem/types.js";

export type { Role };

export const roles: readonly Role[] = ["adversarial", "cooperative"];

export const called: Record<Role, string> = { adversarial: "enemy", cooperative: "friend" };
