// Actions as people read them: PDDL writes `(stack a b)`.
export const actionText = (action: string | null): string => (action ?? "").replace(/^\((.*)\)$/s, "$1");
