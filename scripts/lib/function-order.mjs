// The order of the functions in a wasm file: like ones beside each other. Compilers make many functions that are nearly
// the same, one for each type; hosts send files packed by gzip, which finds again only what it saw within its last 32 KiB.
// The functions get names that sort in this order, as wasm-opt sorts functions by name.
import {
  CUSTOM,
  FUNCTION_BODIES,
  IMPORTS,
  importedFunctions,
  nameOf,
  parts,
  sections,
  writtenNumber,
} from "./wasm-sections.mjs";

/** What the section of the names is called, and the number of its part about functions. */
const [NAMES, FUNCTION_NAMES] = ["name", 1];
/** How many bytes in a row count as one sequence. */
const SEQUENCE = 6;
/** A sequence that is in more functions than this tells none of them from others. */
const MOST_FUNCTIONS = 400;
/** How many bytes before a function it is compared with: less than the window of gzip, for near matches are cheaper. */
const WINDOW = 8000;
/** What a function costs beside its bytes: without it very short ones, which match anything, would come first. */
const COST = 20;

/** The same file with names by which its functions are put in order. */
export function withOrderedNames(wasm) {
  const all = sections(wasm);
  const imports = all.find(({ id }) => id === IMPORTS);
  const imported = imports === undefined ? 0 : importedFunctions(wasm, imports);
  const bodies = all.filter(({ id }) => id === FUNCTION_BODIES).flatMap((section) => parts(wasm, section));
  const names = [];
  for (const [place, index] of inOrder(bodies).entries()) names[index] = String(place).padStart(8, "0");
  // Functions are numbered from the imported ones on.
  const entries = names.flatMap((name, index) => [...writtenNumber(imported + index), ...written(name)]);
  const functions = [...writtenNumber(names.length), ...entries];
  const content = [...written(NAMES), FUNCTION_NAMES, ...writtenNumber(functions.length), ...functions];
  const others = all.filter((section) => section.id !== CUSTOM || nameOf(wasm, section) !== NAMES);
  return Buffer.concat([
    wasm.subarray(0, 8),
    ...others.map(({ start, end }) => wasm.subarray(start, end)),
    Buffer.from([CUSTOM, ...writtenNumber(content.length), ...content]),
  ]);
}

const written = (name) => [...writtenNumber(name.length), ...Buffer.from(name)];

/** The functions' numbers: first the longest, then always the one of which most has been seen shortly before. */
function inOrder(bodies) {
  const { sequences, owners } = sequencesOf(bodies);
  const score = new Int32Array(bodies.length);
  const uses = new Int32Array(owners.length);
  const left = new Set(bodies.keys());
  const order = [];
  let [first, size] = [0, 0];
  const change = (index, by) => {
    for (const sequence of sequences[index]) {
      uses[sequence] += by;
      // Seen for the first time, or no longer.
      if (uses[sequence] === (by > 0 ? 1 : 0)) for (const owner of owners[sequence]) score[owner] += by;
    }
  };
  while (left.size > 0) {
    let [next, best] = [-1, -1];
    for (const index of left) {
      const worth = order.length === 0 ? bodies[index].length : score[index] / (bodies[index].length + COST);
      if (worth > best) [next, best] = [index, worth];
    }
    left.delete(next);
    order.push(next);
    change(next, 1);
    size += bodies[next].length;
    for (; size > WINDOW && first < order.length - 1; first += 1) {
      change(order[first], -1);
      size -= bodies[order[first]].length;
    }
  }
  return order;
}

/** Which sequences of bytes each function shares with others, and which functions have each of these. */
function sequencesOf(bodies) {
  const holders = new Map();
  for (const [index, body] of bodies.entries()) {
    for (let at = 0; at + SEQUENCE <= body.length; at += 1) {
      const key = body.readUIntBE(at, SEQUENCE);
      const holding = holders.get(key);
      if (holding === undefined) holders.set(key, [index]);
      else if (holding.at(-1) !== index) holding.push(index);
    }
  }
  const owners = [...holders.values()].filter(({ length }) => length > 1 && length < MOST_FUNCTIONS);
  const sequences = bodies.map(() => []);
  for (const [sequence, holding] of owners.entries()) for (const index of holding) sequences[index].push(sequence);
  return { sequences, owners };
}
