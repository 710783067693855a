// The name of the element. Where the script is loaded twice, or in two versions, the first one has it.

export const NAME = "mo-copp-playground";

/** Does nothing where there is no document. */
export function define(element: CustomElementConstructor): void {
  const registry = globalThis.customElements;
  if (registry !== undefined && registry.get(NAME) === undefined) registry.define(NAME, element);
}
