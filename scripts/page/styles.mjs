// The element's styles, as each place needs them. On the stand-alone page they reach what is in the element and nothing
// else. In a shadow root (`?inline`) nothing else is there; there the element's own width decides, and not the window's,
// and its lengths can be set by the page.

/** Styles of the page around the element, and those that name the element themselves. */
const ofThePage = /^(?:site|embed-page|colours|guest)$/;

/** What our own custom properties begin with in a shadow root; the stand-alone page is all ours. */
const OWN = "--mo-copp-own-";

export function stylesInElement() {
  return {
    name: "styles-in-element",
    enforce: "pre",
    transform(code, id) {
      if (/\/www\/src\/text\/colours\.ts$/.test(id)) return { code: inBoth(code), map: null };
      const [, name, query] = /\/www\/src\/style\/([^/?]+)\.css(\?.*)?$/.exec(id) ?? [];
      if (name === undefined) return null;
      if (/\binline\b/.test(query ?? "")) return { code: inShadow(code), map: null };
      if (ofThePage.test(name)) return null;
      return { code: `:where(mo-copp-playground, .mo-copp-part) {\n${code}\n}\n`, map: null };
    },
  };
}

/** The text fields stand on the stand-alone page and in shadow roots. */
const inBoth = (code) => code.replace(/var\(--([a-z-]+)(, [^()]+)?\)/g, `var(${OWN}$1, var(--$1$2))`);

function inShadow(code) {
  // A page may register a property of any name, and then decides what it is everywhere, unless a script did before
  // (own-properties.ts).
  return code
    .replace(/(?<![\w-])--(?!mo-copp-)(?=[a-z])/g, OWN)
    .split("\n")
    .map((line) => {
      // A container's `em` is the size that all of the playground goes by; its `rem` is that of the page around it.
      if (line.startsWith("@media (max-width"))
        return line.replace("@media", "@container mo-copp").replace(/rem\b/, "em");
      if (line.startsWith("@container")) return line.replace(/rem\b/, "em");
      if (line.startsWith("@") || line.includes(`${OWN}rem:`)) return line;
      // As wide as the playground, and not as the window; dialogs go by the window.
      const own = line.includes("-room:") ? line.replace("100vw", "100cqi") : line;
      return own.replace(/(-?[\d.]+)rem\b/g, (_, number) => `calc(${number} * var(${OWN}rem))`);
    })
    .join("\n");
}
