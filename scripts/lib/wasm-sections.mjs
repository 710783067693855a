// The outer form of a wasm file: its sections, the parts of one, and numbers as it writes them (LEB128).
// https://webassembly.github.io/spec/core/binary/modules.html

/** What sections are called by number. */
export const [CUSTOM, IMPORTS, FUNCTION_BODIES] = [0, 2, 10];

/** What an import can be, by number. */
const [FUNCTION, TABLE, MEMORY, GLOBAL, TAG] = [0, 1, 2, 3, 4];

/** The number at a place, and the place after it. */
export function readNumber(wasm, at) {
  let [number, scale, next] = [0, 1, at];
  for (;;) {
    const byte = wasm.readUInt8(next);
    next += 1;
    number += (byte & 0x7f) * scale;
    if (byte < 0x80) return [number, next];
    scale *= 0x80;
  }
}

/** A number as bytes. */
export function writtenNumber(number) {
  const bytes = [];
  let rest = number;
  for (; rest >= 0x80; rest = Math.floor(rest / 0x80)) bytes.push((rest % 0x80) | 0x80);
  return [...bytes, rest];
}

/** The sections in their order: where each begins and ends, and where its content does. */
export function sections(wasm) {
  const found = [];
  for (let at = 8; at < wasm.length; ) {
    const [length, content] = readNumber(wasm, at + 1);
    found.push({ id: wasm[at], start: at, content, end: content + length });
    at = content + length;
  }
  return found;
}

/** The name of a section of the kind that has one. */
export const nameOf = (wasm, { content }) => textAt(wasm, content)[0];

/** The parts of a section that is a list of parts with their lengths. */
export function parts(wasm, { content }) {
  const [count, first] = readNumber(wasm, content);
  let at = first;
  return Array.from({ length: count }, () => {
    const [length, begin] = readNumber(wasm, at);
    at = begin + length;
    return wasm.subarray(begin, at);
  });
}

/** How many functions a section of imports brings. */
export function importedFunctions(wasm, { content }) {
  let [count, at] = readNumber(wasm, content);
  let functions = 0;
  for (; count > 0; count -= 1) {
    at = textAt(wasm, textAt(wasm, at)[1])[1];
    const kind = wasm[at];
    at += 1;
    if (kind === FUNCTION) functions += 1;
    at = afterImport(wasm, kind, at);
  }
  return functions;
}

/** After the description of an import. */
function afterImport(wasm, kind, at) {
  if (kind === FUNCTION) return readNumber(wasm, at)[1];
  if (kind === TABLE) return afterLimits(wasm, at + 1);
  if (kind === MEMORY) return afterLimits(wasm, at);
  if (kind === GLOBAL) return at + 2;
  if (kind === TAG) return readNumber(wasm, at + 1)[1];
  throw new Error(`an import of kind ${kind}: expected a function, a table, a memory, a global or a tag`);
}

function afterLimits(wasm, at) {
  const after = readNumber(wasm, at + 1)[1];
  return (wasm[at] & 1) === 1 ? readNumber(wasm, after)[1] : after;
}

function textAt(wasm, at) {
  const [length, begin] = readNumber(wasm, at);
  return [wasm.toString("utf8", begin, begin + length), begin + length];
}
