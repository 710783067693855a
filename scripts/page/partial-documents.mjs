// Vite's loader of chunks asks at once how its links are loaded ahead. A program without a browser may have a `document`
// that makes no elements, as some renderers on servers do: the element's script is quiet there, too.

const helper = /vite\/preload-helper/;
const asks = /typeof document !== ["']undefined["'] && document\.createElement\(["']link["']\)\.relList/;

export function partialDocuments() {
  let seen = false;
  return {
    name: "partial-documents",
    apply: "build",
    transform(code, id) {
      if (!helper.test(id)) return null;
      seen ||= asks.test(code);
      return { code: code.replace(asks, 'globalThis.document?.createElement?.("link").relList'), map: null };
    },
    buildEnd(error) {
      if (!error && !seen) this.error("Vite's loader of chunks has changed; expected that it asks for link.relList");
    },
  };
}
