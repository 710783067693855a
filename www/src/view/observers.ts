// The two observers, as the page speaks of them.

export type Role = "adversarial" | "cooperative";

export const roles: readonly Role[] = ["adversarial", "cooperative"];

export const called: Record<Role, string> = { adversarial: "enemy", cooperative: "friend" };
