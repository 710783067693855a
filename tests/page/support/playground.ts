// Reading and working the playground by its stable attributes and by the names that a person sees.
import assert from "node:assert/strict";
import type { Page } from "playwright-core";
import type { Trace } from "../../../www/src/core.js";
import { put } from "./text.js";

const element = "mo-copp-playground";

export const statusIs = (page: Page, ...statuses: string[]) =>
  page.waitForSelector(statuses.map((status) => `${element}[data-status="${status}"]`).join(","));

export const stepIs = (page: Page, step: number) => page.waitForSelector(`${element}[data-step="${step}"]`);

export const attribute = (page: Page, name: string) => page.locator(element).getAttribute(name);

export const slider = (page: Page) => page.getByRole("slider");

export const press = (page: Page, name: string) => page.getByRole("button", { name, exact: true }).click();

/** Opens a tab of the workbench, whose panel may be fetched then. */
export async function openTab(page: Page, name: string): Promise<void> {
  await page.getByRole("tab", { name, exact: true }).click();
  const panel = page.getByRole("tabpanel", { name, exact: true });
  await panel.waitFor();
  await panel.getByText("Loading…", { exact: true }).waitFor({ state: "detached" });
}

/** Puts a document into the text field and opens it. */
export async function useDocument(page: Page, document: string): Promise<void> {
  await openTab(page, "Document");
  await put(page, document);
  await press(page, "Use this problem");
}

export const choose = (page: Page, field: string, value: string) => page.getByLabel(field).selectOption(value);

/** What is drawn of one step. */
export interface Drawn {
  believed: Record<"adversarial" | "cooperative", string[]>;
  goals: { name: string; adversarial: string; cooperative: string; isTrue: boolean }[];
}

export async function drawn(page: Page): Promise<Drawn> {
  const believed = (board: string) =>
    page
      .locator(`[data-board="${board}"] [data-cell][data-believed]`)
      .evaluateAll((cells) => cells.map((cell) => cell.getAttribute("data-cell") ?? ""));
  const goals = await page.locator("[data-goal]").evaluateAll((marks) =>
    marks.map((mark) => ({
      name: mark.getAttribute("data-goal") ?? "",
      adversarial: mark.getAttribute("data-adversarial") ?? "",
      cooperative: mark.getAttribute("data-cooperative") ?? "",
      isTrue: mark.hasAttribute("data-true-goal"),
    })),
  );
  return {
    believed: { adversarial: await believed("adversarial"), cooperative: await believed("cooperative") },
    goals,
  };
}

/** Checks what is drawn against a step of the core's own trace. */
export function assertDrawn(shown: Drawn, step: Trace["steps"][number], trueGoal: string): void {
  for (const role of ["adversarial", "cooperative"] as const) {
    assert.deepEqual(shown.believed[role].sort(), step.beliefs[role].map(String).sort(), `the ${role} belief`);
  }
  assert.notEqual(shown.goals.length, 0);
  for (const goal of shown.goals) {
    for (const role of ["adversarial", "cooperative"] as const) {
      assert.equal(goal[role], step.goals[role].includes(goal.name) ? "alive" : "dead", `${goal.name}, ${role}`);
    }
    assert.equal(goal.isTrue, goal.name === trueGoal);
  }
}
