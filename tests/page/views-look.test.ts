// The further domains at every size, in light and dark, with more and longer names than fit.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertNoBarrier } from "./support/barriers.js";
import { visit } from "./support/browser.js";
import { documentOf } from "./support/gallery.js";
import { statusIs } from "./support/playground.js";
import { board, drop, open } from "./support/views.js";

const names = ["box-pushing", "recycling-robot", "blocks", "blocks-unseen", "logistics", "driverlog"];
for (const { width, height, colorScheme } of [
  { width: 1280, height: 800, colorScheme: "light" },
  { width: 390, height: 844, colorScheme: "dark" },
  { width: 320, height: 640, colorScheme: "light" },
] as const) {
  for (const name of names) {
    test(`${name}: axe finds no barrier and nothing is too wide, ${width} wide, ${colorScheme}`, () =>
      open(
        name,
        async (page) => {
          await assertNoBarrier(page, name);
          assert((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
        },
        { viewport: { width, height }, colorScheme },
      ));
  }
}

test("sixty blocks and long names break nothing", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      const { domain } = JSON.parse(documentOf("blocks")) as { domain: string[] };
      const blocks = Array.from({ length: 60 }, (_, index) => `block-with-a-very-long-name-${"x".repeat(60)}-${index}`);
      await drop(
        page,
        JSON.stringify({
          format: "pddl",
          domain,
          problem: `(define (problem many) (:domain blocksworld) (:objects ${blocks.join(" ")} - block)
            (:init (handempty) ${blocks.map((name) => `(ontable ${name}) (clear ${name})`).join(" ")}))`,
          goals: [
            { name: "<img src=x onerror=alert(1)>", condition: `(holding ${blocks[0]})` },
            { name: "y".repeat(100), condition: `(holding ${blocks[1]})` },
          ],
          true_goal: "<img src=x onerror=alert(1)>",
          observers: { adversarial: { sensor: "{name}" }, cooperative: { sensor: "{name} {1}" } },
        }),
      );
      await board(page, "actor").locator(".block").nth(59).waitFor();
      assert.equal(await page.locator("mo-copp-playground img").count(), 0);
      assert((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
    },
    { viewport: { width: 320, height: 640 } },
  ));

test("a hundred packages break nothing", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      const { domain } = JSON.parse(documentOf("logistics")) as { domain: string[] };
      const packages = Array.from({ length: 100 }, (_, index) => `package${index}`);
      await drop(
        page,
        JSON.stringify({
          format: "pddl",
          domain,
          problem: `(define (problem many) (:domain logistics)
            (:objects here - airport there - place truck - truck ${packages.join(" ")} - package)
            (:init (road here there) (road there here) (at truck here) ${packages.map((name) => `(at ${name} here)`).join(" ")}))`,
          goals: [
            { name: "G1", condition: "(at truck there)" },
            { name: "G2", condition: "(in package1 truck)" },
          ],
          true_goal: "G1",
          observers: { adversarial: { sensor: "{name}" }, cooperative: { sensor: "{name}" } },
        }),
      );
      await board(page, "actor").locator(".thing-box.package").nth(99).waitFor();
      assert((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
    },
    { viewport: { width: 390, height: 844 } },
  ));
