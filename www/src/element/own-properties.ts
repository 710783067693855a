// Custom properties that the styles in the shadow root have for themselves. A rule of the page (`@property`) may register
// any name, and then decides what it holds in shadow roots, too; what a script has registered goes before such rules.

const known = new WeakMap<Document, Set<string>>();

/** Registers the properties that `styles` name as what they are without it: any value, inherited. */
export function keepProperties(document: Document, styles: string): void {
  const { CSS: css } = (document.defaultView ?? {}) as { CSS?: typeof CSS };
  if (css?.registerProperty === undefined) return;
  const names = known.get(document) ?? new Set<string>();
  known.set(document, names);
  for (const [name] of styles.matchAll(/--mo-copp-own-[a-z-]+/g)) {
    if (names.has(name)) continue;
    names.add(name);
    try {
      css.registerProperty({ name, syntax: "*", inherits: true });
    } catch {
      // Another version of the element, or another copy, did it.
    }
  }
}
