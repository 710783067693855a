// The answer to the problem that the page begins with, as the build puts it into the scripts; null where the core is there already.
declare module "virtual:opening-answer" {
  const answer: (import("./opening-answer.js").OpeningAnswer & { options: import("../core.js").SolveOptions }) | null;
  export default answer;
}
