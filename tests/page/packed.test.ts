// Text in an address: it comes out as it went in, and what is not right is known.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LONGEST_LINK, pack, unpack } from "../../www/src/share/packed.js";
import { documentOf } from "./support/gallery.js";

test("text goes into an address and comes out again, whatever it is", async () => {
  for (const text of ["", "{}", documentOf("city"), '𝒢 – ñ \u0000 \\ "quoted"', "x".repeat(300_000)]) {
    const packed = await pack(text);
    assert.match(packed, /^1\.[A-Za-z0-9_-]*\.[a-z0-9]+$/);
    assert.equal(await unpack(packed), text);
  }
});

test("a link with one character changed, cut off or added is known for damaged", async () => {
  const packed = await pack(documentOf("head-fake"));
  for (let at = 0; at < packed.length; at += 1) {
    const other = packed[at] === "7" ? "8" : "7";
    await assert.rejects(
      unpack(packed.slice(0, at) + other + packed.slice(at + 1)),
      /damaged|newer/,
      `changed at ${at}`,
    );
    await assert.rejects(unpack(packed.slice(0, at)), /damaged/, `cut at ${at}`);
  }
  await assert.rejects(unpack(`${packed}x`), /damaged/);
  await assert.rejects(unpack("2.abc"), /newer/);
  await assert.rejects(unpack("hello"), /damaged/);
});

test("a small link that holds a very large text is refused soon, and not inflated", async () => {
  const bomb = await pack("\0".repeat(30_000_000)).catch((error) => error);
  assert(typeof bomb === "string" && bomb.length < LONGEST_LINK, "it is small");
  const before = performance.now();
  await assert.rejects(unpack(bomb), /more than any problem/);
  assert(performance.now() - before < 2000);
});
