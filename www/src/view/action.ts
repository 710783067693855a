// Actions as people read them: PDDL writes `(stack a b)`.
import { visible } from "../problem/unseen.js";

export const actionText = (action: string | null): string => visible((action ?? "").replace(/^\((.*)\)$/s, "$1"));
