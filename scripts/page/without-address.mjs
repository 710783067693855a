// The glue code of the cores names no file: the page tells the workers where the cores are, or sends them.

/** For the worker's build. */
export function withoutAddress() {
  return {
    name: "without-address",
    enforce: "pre",
    transform(code, id) {
      if (!/\/www\/pkg(?:-light)?\/[^/]+\.js$/.test(id)) return null;
      return { code: code.replace(/new URL\('[^']+\.wasm', import\.meta\.url\)/, "undefined"), map: null };
    },
  };
}
