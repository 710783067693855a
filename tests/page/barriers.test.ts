// The page in every state that a person brings it into, looked at by axe: on a desktop and on a phone, light and dark.
import { test } from "node:test";
import type { Page } from "playwright-core";
import { assertNoBarrier } from "./support/barriers.js";
import { visit } from "./support/browser.js";
import { endless, explicit, figure1, grid } from "./support/documents.js";
import { choose, openTab, press, slider, statusIs, useDocument } from "./support/playground.js";

type State = [name: string, reach: (page: Page) => Promise<unknown>];

/** Each goes on from the one before. */
const states: State[] = [
  ["idle", (page) => press(page, "Forward one step")],
  ["a goal chosen", (page) => page.locator(".choose").nth(1).click()],
  [
    "Compare filled",
    async (page) => {
      await openTab(page, "Compare");
      await page.getByLabel("Each may take").selectOption({ label: "2 seconds" });
      await press(page, "Compare all solvers");
      await page.getByText("The comparison is complete.").waitFor({ state: "attached" });
      await page.getByRole("button", { name: "Baseline" }).click();
      await page.getByText("On the boards: the plan of Baseline").waitFor();
    },
  ],
  [
    "Trade-off filled",
    async (page) => {
      await openTab(page, "Trade-off");
      await page.locator('.charts[aria-busy="false"] .point').first().waitFor();
      for (const twin of ["The pairs as a table", "The lengths as a table"]) await page.getByText(twin).click();
    },
  ],
  [
    "no plan, with what would do",
    async (page) => {
      await openTab(page, "Solve");
      await page.getByLabel("Plan length").fill("13");
      await statusIs(page, "infeasible");
      await page.locator(".remedies button").first().waitFor();
    },
  ],
  [
    "a number that can't be used",
    async (page) => {
      await page.getByLabel("Plan length").fill("many");
      await page.getByText(/^A whole number of moves/).waitFor();
      await page.getByLabel("Plan length").fill("");
      await statusIs(page, "optimal");
      await page.getByLabel("Enemy keeps at least").fill("99");
      await page.getByText(/^A whole number of goals/).waitFor();
    },
  ],
  [
    "the steps",
    async (page) => {
      await openTab(page, "Steps");
      await slider(page).fill("3");
    },
  ],
  [
    "a picture to be saved",
    async (page) => {
      await press(page, "Save picture");
      await page.getByRole("dialog").getByRole("img").waitFor();
    },
  ],
  [
    "walking",
    async (page) => {
      await page.keyboard.press("Escape");
      await openTab(page, "Play");
      await press(page, "Take over");
      await press(page, "north");
      await page.locator('mo-copp-playground[data-step="1"]').waitFor();
    },
  ],
  [
    "guessing",
    async (page) => {
      await press(page, "Stop walking");
      await press(page, "Start guessing");
      await page.getByText("Which goal is it after?").waitFor();
    },
  ],
  [
    "guessed",
    async (page) => {
      await page.locator(".next button").first().click();
      await page.getByText("The boards now show the whole way.").waitFor();
    },
  ],
  [
    "editing",
    async (page) => {
      await press(page, "Leave the game");
      await openTab(page, "Edit");
      await page.getByLabel("Columns").fill("99");
      await page.getByLabel("Columns").press("Enter");
      await page.getByText("A whole number from 2 to 32.").waitFor();
    },
  ],
  [
    "an error shown",
    async (page) => {
      await useDocument(page, grid({ start: [9, 9] }));
      await statusIs(page, "error");
    },
  ],
  [
    "the help open",
    async (page) => {
      await useDocument(page, grid());
      await statusIs(page, "optimal");
      await press(page, "Help");
      await page.getByRole("dialog").waitFor();
    },
  ],
  [
    "the gallery open",
    async (page) => {
      await page.keyboard.press("Escape");
      await page.getByRole("dialog").waitFor({ state: "detached" });
      await page.getByTitle("All problems").click();
      await page.getByRole("dialog").waitFor();
    },
  ],
  [
    "a delivery",
    async (page) => {
      await page.keyboard.press("Escape");
      await useDocument(page, figure1);
      await page.locator("svg.delivery").first().waitFor();
      await statusIs(page, "optimal");
    },
  ],
  [
    "a problem in words",
    async (page) => {
      await useDocument(page, explicit);
      await page.locator(".states-board").first().waitFor();
      await statusIs(page, "optimal");
    },
  ],
  [
    "solving, with Cancel",
    async (page) => {
      await useDocument(page, endless());
      await openTab(page, "Solve");
      await page.getByText(/states looked at/).waitFor();
      await page.getByRole("button", { name: "Cancel" }).waitFor();
    },
  ],
  [
    "stopped, with the best plan kept",
    async (page) => {
      await press(page, "Cancel");
      await statusIs(page, "feasible");
      await choose(page, "Solver", "ip");
    },
  ],
];

for (const [device, options] of [
  ["desktop", {}],
  ["phone", { viewport: { width: 320, height: 720 }, hasTouch: true, isMobile: true }],
] as const) {
  test(`axe finds no barrier in any state, ${device}, light and dark`, () =>
    visit(
      async ({ page }) => {
        await statusIs(page, "optimal");
        for (const [name, reach] of states) {
          await reach(page);
          await assertNoBarrier(page, name, { dark: true });
        }
      },
      { ...options, reducedMotion: "reduce" },
    ));
}
