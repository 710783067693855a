// What a page adds to Object.prototype is no export of a module: the bundler's helper for modules that are loaded late goes
// through the names that an object inherits, too.

const inherited = "for (var name in all)";
const own = "for (var name of Object.keys(all))";

export function ownNames() {
  return {
    name: "own-names",
    transform(code, id) {
      if (id !== "\0rolldown/runtime.js") return null;
      if (!code.includes(inherited)) this.error("the bundler's helper goes through names in another way");
      return { code: code.replaceAll(inherited, own), map: null };
    },
  };
}
