// What a page's script asks of the element while other things are asked, and what it hands out.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { address } from "./support/site.js";

const lesson = `<!doctype html><html lang="en"><head><title>Lesson</title>
  <script type="module" src="../mo-copp-playground.js"></script></head>
  <body><mo-copp-playground id="one" problem="head-fake" link="off"></mo-copp-playground></body></html>`;

const withLesson = (use: Parameters<typeof visit>[0]) =>
  visit(async (visited) => {
    const { page } = visited;
    await page.route(`${address}lesson/methods.html`, (route) =>
      route.fulfill({ contentType: "text/html", body: lesson }),
    );
    await page.goto(`${address}lesson/methods.html`);
    await page.waitForSelector("#one[data-status=optimal]");
    await use(visited);
  });

test("a question whose place another one took, or whose problem was changed, is said to be that", () =>
  withLesson(async ({ page }) => {
    const told = await page.locator("#one").evaluate(async (element, text) => {
      const playground = element as MoCoppPlayground;
      const both = await Promise.allSettled([playground.solve({ k: 1 }), playground.solve({ k: 2 })]);
      const misfits = await Promise.allSettled([playground.solve({ k: 99 })]);
      const overtaken = playground.solve({ solver: "ip", k: 1 });
      // The methods wait a turn, so that both are asked for.
      await new Promise((done) => setTimeout(done));
      playground.document = text;
      const changed = await Promise.allSettled([overtaken]);
      return [...both, ...misfits, ...changed].map((one) =>
        one.status === "fulfilled" ? one.value.status : String(one.reason.message),
      );
    }, grid());
    const [first, second, misfit, changed] = told;
    assert.equal(first, "Another question took the place of this one before it was answered.");
    assert.equal(second, "optimal");
    assert.match(misfit ?? "", /^These options do not fit the problem: k and j go from 1 to \d/);
    assert.equal(changed, "The problem was changed before this question was answered.");
  }));

test("the document is a copy: what a script does to it changes nothing", () =>
  withLesson(async ({ page }) => {
    const widths = await page.locator("#one").evaluate((element) => {
      const playground = element as MoCoppPlayground;
      const document = playground.document as { width: number; walls: unknown[] };
      const before = document.width;
      document.width = 99;
      document.walls.length = 0;
      const after = playground.document as { width: number; walls: unknown[] };
      const kept = JSON.parse(playground.state?.document ?? "{}");
      return { before: [before, kept.walls.length], after: [after.width, after.walls.length] };
    });
    assert.deepEqual(widths.after, widths.before);
  }));
