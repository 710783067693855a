// Opening the problems of the further domains, and finding what is drawn of them.
import type { Page } from "playwright-core";
import type { Trace } from "../../../www/src/core.js";
import { type Options, visit } from "./browser.js";
import { solve } from "./core.js";
import { documentOf } from "./gallery.js";
import { slider, statusIs, stepIs } from "./playground.js";

/** Opens a problem of the gallery. */
export const open = (name: string, use: (page: Page, trace: Trace) => Promise<void>, options: Options = {}) =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await page.locator("mo-copp-playground").evaluate((element, value) => element.setAttribute("problem", value), name);
    const { trace } = solve(documentOf(name), { solver: "exact" });
    await page.waitForSelector(`mo-copp-playground[data-status="optimal"][data-step="${trace.steps.length - 1}"]`);
    await page.locator('[data-board="actor"]').waitFor();
    await use(page, trace);
  }, options);

export const board = (page: Page, name: string) => page.locator(`[data-board="${name}"]`);
export async function goTo(page: Page, step: number): Promise<void> {
  await slider(page).fill(String(step));
  await stepIs(page, step);
}

/** Drops a document onto the page. */
export async function drop(page: Page, text: string): Promise<void> {
  await page.evaluate((content) => {
    const data = new DataTransfer();
    data.items.add(new File([content], "problem.json", { type: "application/json" }));
    for (const type of ["dragenter", "dragover", "drop"]) {
      window.dispatchEvent(new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true }));
    }
  }, text);
}

/** Lamps with a switch each: a domain that no picture knows. */
export function switches(names: readonly string[] = ["one", "two"]): string {
  return JSON.stringify({
    format: "pddl",
    domain: `(define (domain switches) (:predicates (up ?x) (down ?x))
      (:action flip :parameters (?x) :precondition (down ?x) :effect (and (up ?x) (not (down ?x)))))`,
    problem: `(define (problem p) (:domain switches) (:objects ${names.join(" ")})
      (:init ${names.map((name) => `(down ${name})`).join(" ")}))`,
    goals: names.slice(0, 2).map((name, index) => ({ name: `G${index + 1}`, condition: `(up ${name})` })),
    true_goal: "G1",
    observers: { adversarial: { sensor: "{name}" }, cooperative: { sensor: "{name} {1}" } },
  });
}
