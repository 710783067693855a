// Reaching what is in a playground from outside.

/**
 * What a playground is drawn into: search there for `[data-goal]`, `[data-cell]`, `[data-board]` and the other stable
 * attributes. In a page of other people that is the element's shadow root, on the stand-alone page the element itself.
 */
export const inside = (playground: Element): ParentNode => playground.shadowRoot ?? playground;
