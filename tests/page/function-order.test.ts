// The order of the functions in the built cores: like ones beside each other, and nothing lost by it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { withOrderedNames } from "../../scripts/lib/function-order.mjs";
import { lightWasmPackage } from "../../scripts/lib/paths.mjs";
import { writtenNumber } from "../../scripts/lib/wasm-sections.mjs";

const END = 0x0b;
const DROP = 0x1a;

/** Adds numbers, and throws each sum away; or the same with multiplication. */
const body = (operation: number, first: number) => {
  const once = (value: number) => [0x41, value, 0x41, 7, operation, DROP];
  return [0, ...once(first), ...Array.from({ length: 6 }, () => once(5)).flat(), END];
};
const [ADD, MULTIPLY] = [0x6a, 0x6c];

const section = (id: number, content: number[]) => [id, ...writtenNumber(content.length), ...content];

/** A module of four functions, of which the first and the third, and the second and the fourth are alike. */
const bodies = [body(ADD, 1), body(MULTIPLY, 2), body(ADD, 3), body(MULTIPLY, 4)];
const four = Buffer.from([
  ...[0, 0x61, 0x73, 0x6d, 1, 0, 0, 0],
  ...section(1, [1, 0x60, 0, 0]),
  ...section(2, [1, 1, 0x65, 1, 0x66, 0, 0]),
  ...section(3, [4, 0, 0, 0, 0]),
  ...section(10, [4, ...bodies.flatMap((one) => [one.length, ...one])]),
]);

/** The numbers and names of functions in the file's section of names. */
function namesOf(wasm: Buffer) {
  const [names, ...more] = WebAssembly.Module.customSections(new WebAssembly.Module(new Uint8Array(wasm)), "name");
  assert.ok(names !== undefined && more.length === 0, "one section of names");
  const bytes = Buffer.from(names);
  let at = 0;
  const number = () => {
    let [found, scale] = [0, 1];
    for (; ; scale *= 0x80) {
      const byte = bytes.readUInt8(at++);
      found += (byte & 0x7f) * scale;
      if (byte < 0x80) return found;
    }
  };
  assert.equal(number(), 1, "the part about functions");
  number();
  return Array.from({ length: number() }, () => {
    const index = number();
    const length = number();
    at += length;
    return { index, name: bytes.toString("utf8", at - length, at) };
  });
}

test("functions that are alike follow each other", () => {
  const sorted = namesOf(withOrderedNames(four)).sort((a, b) => (a.name < b.name ? -1 : 1));
  // The first function is imported.
  const parity = sorted.map(({ index }) => index % 2);
  assert.ok(parity[0] === parity[1] && parity[2] === parity[3], JSON.stringify(sorted));
});

test("each function of a built core has one place, and the same bytes are ordered the same way again", () => {
  const core = readFileSync(join(lightWasmPackage, "mo_copp_light_bg.wasm"));
  const named = withOrderedNames(core);
  const names = namesOf(named);
  assert.ok(names.length > 1000, `${names.length} functions`);
  assert.equal(new Set(names.map(({ name }) => name)).size, names.length, "names of their own");
  assert.ok(named.equals(withOrderedNames(named)), "the same order again");
});

test("a file that ends too early is refused", () => {
  assert.throws(() => withOrderedNames(four.subarray(0, 40)), RangeError, "no end is waited for");
});

test("the file that hosts send holds no names", () => {
  const core = new WebAssembly.Module(readFileSync(join(lightWasmPackage, "mo_copp_light_bg.wasm")));
  assert.deepEqual(WebAssembly.Module.customSections(core, "name"), [], "names take room");
});
