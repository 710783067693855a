// The element is moved by the page, or taken out for a while: whenever that is, what was asked of it goes on.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import { visit } from "./support/browser.js";
import { endless, grid } from "./support/documents.js";
import { address } from "./support/site.js";

/** Of the page. */
declare function passed(ms: number): Promise<void>;

async function lesson(page: Page, body: string): Promise<void> {
  await page.route(`${address}lesson/moved.html`, (route) =>
    route.fulfill({
      contentType: "text/html",
      body: `<!doctype html><html lang="en"><head><title>Lesson</title>
        <script type="module" src="../mo-copp-playground.js"></script></head>
        <script>window.passed = (ms) => new Promise((done) => setTimeout(done, ms));</script>
        <body><div id="here">${body}</div><div id="there"></div></body></html>`,
    }),
  );
  await page.goto(`${address}lesson/moved.html`);
}

const kinds: Record<string, string> = {
  "of the gallery": `<mo-copp-playground id="one" problem="head-fake" link="off"></mo-copp-playground>`,
  "in the element": `<mo-copp-playground id="one" link="off"><script type="application/json">${grid()}</script></mo-copp-playground>`,
};
const one = kinds["of the gallery"] ?? "";

const drawn = (page: Page) => page.waitForSelector("#one[data-status=optimal][data-gd]", { timeout: 20_000 });

for (const [kind, element] of Object.entries(kinds)) {
  test(`moved again and again while it loads, it shows its problem: a document ${kind}`, () =>
    visit(async ({ page }) => {
      for (const [times, pause] of [
        [1, 90],
        [3, 20],
        [60, 10],
      ]) {
        await lesson(
          page,
          `${element}<script>
            let left = ${times};
            const timer = setInterval(() => {
              document.querySelector(left % 2 ? "#there" : "#here").append(document.querySelector("#one"));
              left -= 1;
              if (left === 0) clearInterval(timer);
            }, ${pause});
          </script>`,
        );
        await drawn(page);
      }
    }));
}

test("moved once, or away for a while, at any moment before its first picture, it is ready", () =>
  visit(async ({ page }) => {
    await lesson(page, one);
    await drawn(page);
    const never = await page.evaluate(async (document_) => {
      const [here, there] = ["#here", "#there"].map((id) => document.querySelector(id)) as [Element, Element];
      const found: string[] = [];
      for (const way of ["append", "moveBefore", "away"]) {
        for (let moment = 0; moment <= 300; moment += 15) {
          const made = document.createElement("mo-copp-playground") as MoCoppPlayground;
          made.setAttribute("link", "off");
          // Each is another problem.
          made.document = { ...JSON.parse(document_), width: 4 + (moment % 4) };
          here.append(made);
          await passed(moment);
          if (way === "away") made.remove();
          if (way === "away") await passed(40);
          if (way === "moveBefore" && "moveBefore" in there)
            (there.moveBefore as (node: Node, before: null) => void)(made, null);
          else there.append(made);
          const end = await Promise.race([made.ready.then(() => made.dataset.gd), passed(10_000)]);
          if (end === undefined) found.push(`${way} after ${moment} ms`);
          made.remove();
          if (found.length > 0) return found;
        }
      }
      return found;
    }, grid());
    assert.deepEqual(never, []);
  }));

test("what was asked of it goes on where it was moved to: an attribute, a document, a solver, a picture", () =>
  visit(async ({ page }) => {
    await lesson(page, one);
    await drawn(page);
    const told = await page.evaluate(async (document_) => {
      const playground = document.querySelector("#one") as MoCoppPlayground;
      const [here, there] = ["#here", "#there"].map((id) => document.querySelector(id)) as [Element, Element];
      const widths: (number | undefined)[] = [];
      const outcome = playground.solve({ solver: "ip" });
      await passed(60);
      there.append(playground);
      const { status, solver } = await outcome;
      for (const pause of [0, 20, 60]) {
        playground.setAttribute("problem", pause === 20 ? "head-fake" : "corridor");
        await passed(pause);
        here.append(playground);
        await playground.toSVG();
        widths.push((playground.document as { width?: number }).width);
        playground.document = { ...JSON.parse(document_), width: 7 };
        await passed(pause);
        playground.remove();
        await passed(pause);
        there.append(playground);
        await playground.toSVG();
        widths.push((playground.document as { width?: number }).width);
      }
      const picture = playground.toSVG();
      playground.remove();
      const out = (await picture).startsWith("<svg");
      return { status, solver, widths, out };
    }, grid());
    assert.equal(told.solver, "ip");
    assert.notEqual(told.status, "limit");
    const { widths } = told;
    assert.deepEqual(
      widths.filter((_, index) => index % 2 === 1),
      [7, 7, 7],
    );
    assert.equal(widths[0], widths[4]);
    assert.notEqual(widths[0], widths[2]);
    assert.equal(told.out, true);
  }));

test("out of the page it has no worker, and takes its work up once it is back", () =>
  visit(async ({ page }) => {
    await lesson(page, one);
    await drawn(page);
    await page.evaluate((text) => {
      const playground = document.querySelector("#one") as MoCoppPlayground;
      Object.assign(window, { playground });
      playground.document = text;
    }, endless());
    await page.waitForSelector("#one[data-status=solving]");
    assert(page.workers().length > 0);
    await page.evaluate("playground.remove()");
    for (let tries = 0; page.workers().length > 0; tries += 1) {
      assert(tries < 100, "a worker is still there");
      await page.waitForTimeout(50);
    }
    await page.evaluate(`document.body.append(playground)`);
    await page.getByRole("button", { name: "Cancel" }).first().click();
    await page.waitForSelector("#one:not([data-status=solving])");
    await page.evaluate((text) => {
      (document.querySelector("#one") as MoCoppPlayground).document = text;
    }, grid());
    await drawn(page);
  }));
