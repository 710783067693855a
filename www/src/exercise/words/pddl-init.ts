// The atoms of the :init of a problem in PDDL. The core has read the text: it is well formed.

/** Each atom as it is written, with single blanks. */
export function atomsOfInit(problem: string): string[] {
  const text = problem.replace(/;[^\n]*/g, " ");
  const begin = /\(\s*:init\b/i.exec(text);
  if (begin === null) return [];
  const atoms: string[] = [];
  let depth = 0;
  let from = 0;
  for (let at = begin.index + begin[0].length; at < text.length && depth >= 0; at += 1) {
    const sign = text[at];
    if (sign === "(" && depth === 0) from = at;
    if (sign === "(") depth += 1;
    if (sign === ")") depth -= 1;
    if (sign === ")" && depth === 0) atoms.push(text.slice(from, at + 1).replace(/\s+/g, " "));
  }
  return atoms;
}
