// One session with the keyboard alone, from the gallery to the link: nothing is clicked.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { entries } from "./support/gallery.js";
import { edit } from "./support/hands.js";
import { attribute, statusIs, stepIs } from "./support/playground.js";

/** What the focus is on: its name, and whether that can be seen. */
const focus = (page: Page) =>
  page.evaluate(() => {
    const on = document.activeElement ?? document.body;
    const labels = on instanceof HTMLInputElement || on instanceof HTMLSelectElement ? on.labels : null;
    const label = labels?.[0] === undefined ? null : `field: ${labels[0].textContent}`;
    const name =
      on.getAttribute("aria-label") ?? label ?? `${on.getAttribute("role") === "tab" ? "tab: " : ""}${on.textContent}`;
    const outline = getComputedStyle(on);
    return { name: name.replace(/\s+/g, " ").trim(), seen: outline.outlineStyle !== "none" || on.matches("svg") };
  });

/** Presses Tab, or another key, until the focus is on what is called so; everything on the way shows that it has it. */
async function goTo(page: Page, name: RegExp, key = "Tab"): Promise<void> {
  const passed: string[] = [];
  for (let count = 0; count < 90; count += 1) {
    const on = await focus(page);
    if (name.test(on.name)) {
      assert(on.seen, `the focus on “${on.name}” can be seen`);
      return;
    }
    passed.push(on.name.slice(0, 30));
    await page.keyboard.press(key);
  }
  assert.fail(`${name} is not reached by ${key}: ${passed.join(" | ")}`);
}

const keys = async (page: Page, ...pressed: string[]) => {
  for (const key of pressed) await page.keyboard.press(key);
};

test("the keyboard alone does everything", () =>
  edit(
    async (page) => {
      // Another problem, and back.
      await goTo(page, /^Next problem$/);
      await keys(page, "Enter");
      await page.getByText(`2 of ${entries.length}`).waitFor();
      await goTo(page, /^Problem before$/, "Shift+Tab");
      await keys(page, "Enter");
      await page.getByText(`1 of ${entries.length}`).waitFor();
      await statusIs(page, "optimal");

      // A named plan, and its steps.
      await goTo(page, /^Straight there$/);
      await keys(page, "Enter");
      await stepIs(page, 14);
      await keys(page, "Home");
      await stepIs(page, 0);
      await keys(page, "ArrowRight", "ArrowRight");
      await stepIs(page, 2);

      // A wall on the agent's board, and undone.
      await goTo(page, /^The agent on a grid/);
      await keys(page, "ArrowRight", "w");
      await page.locator('[data-board="actor"] [data-cell="1,7"].wall').waitFor();
      await keys(page, "Control+z");
      await page.locator('[data-board="actor"] [data-cell="1,7"].floor').waitFor();
      await statusIs(page, "optimal");

      // Another solver within a bound.
      await goTo(page, /^field: Solver$/);
      await keys(page, "b");
      await goTo(page, /^field: Plan length$/);
      await keys(page, "1", "8");
      await goTo(page, /^Solve$/);
      await keys(page, "Enter");
      await statusIs(page, "solved");
      assert.equal(await page.getByRole("slider").getAttribute("max"), "18");

      // A goal's end.
      await goTo(page, /^G4$/);
      await keys(page, "Enter");
      await page.locator(".story", { hasText: /^G4: / }).waitFor();

      // Being the agent.
      await goTo(page, /^tab: Solve$/, "Shift+Tab");
      await keys(page, "ArrowRight", "ArrowRight");
      await goTo(page, /^Take over$/);
      await keys(page, "Enter");
      await page.getByRole("button", { name: "Stop walking" }).waitFor();
      await goTo(page, /^north$/);
      await keys(page, "Enter");
      await stepIs(page, 1);
      await goTo(page, /^The agent's board: walk/, "Shift+Tab");
      await keys(page, "ArrowUp", "ArrowRight");
      await stepIs(page, 3);
      await keys(page, "Backspace");
      await stepIs(page, 2);
      await goTo(page, /^Stop walking$/);
      await keys(page, "Enter");

      // Being the enemy.
      await page.getByRole("button", { name: "Start guessing" }).waitFor();
      await goTo(page, /^tab: Play$/, "Shift+Tab");
      await goTo(page, /^Start guessing$/);
      await keys(page, "Enter");
      await page.getByText("Which goal is it after?").waitFor();
      await goTo(page, /^tab: Play$/, "Shift+Tab");
      await goTo(page, /^G2$/);
      await keys(page, "Enter");
      await page.getByText(/^(Right|No): it was/).waitFor();
      await goTo(page, /^Leave the game$/);
      await keys(page, "Enter");

      // All solvers side by side.
      await page.getByRole("button", { name: "Start guessing" }).waitFor();
      await goTo(page, /^tab: Play$/, "Shift+Tab");
      await keys(page, "ArrowRight");
      await goTo(page, /^Compare all solvers$/);
      await keys(page, "Enter");
      await page.getByText("The comparison is complete.").waitFor({ state: "attached" });
      await goTo(page, /^Legible only$/);
      await keys(page, "Enter");
      await page.getByText("On the boards: the plan of Legible only").waitFor();

      // What a word means, and the link.
      await keys(page, "?");
      await page.getByRole("dialog").waitFor();
      await keys(page, "Escape");
      await page.getByRole("dialog").waitFor({ state: "detached" });
      await goTo(page, /^Copy link$/, "Shift+Tab");
      await keys(page, "Enter");
      await page.getByText("The link is on the clipboard.").waitFor();
      assert.equal(await attribute(page, "data-status"), "solved");
    },
    { permissions: ["clipboard-read", "clipboard-write"] },
  ));
