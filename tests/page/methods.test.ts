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

test("solve answers for what was asked for when it was called, and says where that was replaced since", () =>
  withLesson(async ({ page }) => {
    const far = grid({ height: 6, start: [0, 5] });
    await page.route("**/lesson.json", (route) => route.fulfill({ contentType: "application/json", body: far }));
    const documents = JSON.stringify({ near: grid({ start: [3, 2] }), far });
    const told = await page.evaluate<{ lengths: Record<string, unknown>; said: string[] }>(`(async () => {
      const playground = document.querySelector("#one");
      const { near, far } = ${documents};
      const length = async () => (await playground.solve({ solver: "exact" })).plan.length;
      const lengths = { gallery: await length() };
      // What is set before, in the same turn.
      playground.document = near;
      lengths.near = await length();
      playground.problem = "corridor";
      lengths.problem = await length();
      const { state } = playground;
      playground.document = far;
      lengths.far = await length();
      playground.state = state;
      lengths.state = await length();
      // An address that is taken away for another one is no other question.
      playground.src = "lesson.json";
      lengths.src = await length();
      playground.problem = "head-fake";
      lengths.address = await length();
      // What could not be had is no answer about what was shown before it.
      playground.document = "{}";
      lengths.broken = await length().catch(({ message }) => message);
      playground.problem = "nowhere";
      lengths.nowhere = await length().catch(({ message }) => message);
      playground.problem = "head-fake";
      lengths.mended = await length();
      // What is set after, in the same turn.
      const said = [];
      for (const change of [
        () => Object.assign(playground, { document: near }),
        () => Object.assign(playground, { state }),
        () => Object.assign(playground, { problem: "corridor" }),
        () => playground.removeAttribute("problem"),
        () => Object.assign(playground, { k: 2 }),
        // What looks else, and no other problem, leaves a question as it is.
        () => Object.assign(playground, { theme: "dark", step: 1, k: 2 }),
      ]) {
        const asked = playground.solve({ solver: "exact" });
        change();
        said.push(await asked.then(({ status }) => status, ({ message }) => message));
        await playground.toSVG();
      }
      return { lengths, said };
    })()`);
    const { gallery, near, far: longest, problem, state, src, address: last, broken, nowhere, mended } = told.lengths;
    assert.equal(new Set([gallery, near, longest, problem]).size, 4, "the problems have plans of other lengths");
    assert.deepEqual(
      [state, src, last, mended],
      [problem, longest, gallery, gallery],
      "each answer is of what was set last",
    );
    assert.match(String(broken), /expected/);
    assert.match(String(nowhere), /“nowhere”/);
    const changed = "The problem was changed before this question was answered.";
    const overtaken = "Another question took the place of this one before it was answered.";
    assert.deepEqual(told.said, [...Array(4).fill(changed), overtaken, "optimal"]);
  }));

test("a question that is asked before there is a picture is about what was set before it", () =>
  withLesson(async ({ page }) => {
    const told = await page.evaluate<string[]>(`(async () => {
      const text = ${JSON.stringify(grid())};
      const made = (given) => {
        const playground = document.createElement("mo-copp-playground");
        Object.assign(playground, { link: "off", problem: "corridor", ...given });
        document.body.append(playground);
        return playground;
      };
      const [before, after] = [made({ document: text }), made({})];
      const asked = [before.solve(), after.solve()];
      after.document = text;
      return (await Promise.allSettled(asked)).map(({ value, reason }) => value?.status ?? reason.message);
    })()`);
    assert.deepEqual(told, ["optimal", "The problem was changed before this question was answered."]);
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
