// Limits that the page and the core share.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LARGEST_DOCUMENT, LARGEST_IN_WORDS } from "../../www/src/problem/limits.js";
import { taken } from "./support/core.js";

test("the page takes documents as large as the core does", () => {
  assert.match(String(taken(" ".repeat(LARGEST_DOCUMENT + 1))), new RegExp(`at most ${LARGEST_IN_WORDS}`));
  assert.doesNotMatch(String(taken(" ".repeat(LARGEST_DOCUMENT))), /MiB/);
});
