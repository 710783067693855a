// A classic script is read in the charset of its page, which may be another than UTF-8: only ASCII is the same in all.

/** A program of the same meaning whose characters are all ASCII. */
export const inAscii = (code) =>
  code.replace(/(\\*)([^\0-\x7f])/g, (_, slashes, character) => {
    // A backslash that a character does not need would stand before the one of its escape.
    const before = slashes.length % 2 === 0 ? slashes : slashes.slice(1);
    return `${before}\\u${character.charCodeAt(0).toString(16).padStart(4, "0")}`;
  });

export function onlyAscii() {
  return {
    name: "only-ascii",
    enforce: "post",
    generateBundle(_, bundle) {
      for (const file of Object.values(bundle)) {
        if (file.type !== "chunk") continue;
        // The text between the quotation marks is what such a tag gives: an escape would be another.
        if (file.code.includes("String.raw")) this.error("String.raw can't have its characters escaped");
        file.code = inAscii(file.code);
      }
    },
  };
}
