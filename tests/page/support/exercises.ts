// The exercises of the repository: their texts, right answers to them, and how they come onto a page.
import { readFileSync } from "node:fs";
import type { Page } from "playwright-core";
import { Exercise } from "./core.js";

export const exerciseText = (name: string): string =>
  readFileSync(new URL(`../../../examples/exercises/${name}.json`, import.meta.url), "utf8");

/** The problem of an exercise without its question. */
export function problemText(name: string): string {
  const { exercise: _, ...problem } = JSON.parse(exerciseText(name));
  return JSON.stringify(problem);
}

export interface Solved {
  kind: string;
  /** Positions of the choices of a right answer. */
  choices: number[];
  count: number;
  form: { choices: unknown[] };
}

export function solved(name: string, seed = 0): Solved {
  const { kind, form, solution } = new Exercise(exerciseText(name), seed).solution();
  const answer = solution?.answer;
  const list = form.arity === "one" ? [answer] : (answer as unknown[]);
  const known = form.choices.map((choice) => JSON.stringify(choice));
  return { kind, form, choices: list.map((choice) => known.indexOf(JSON.stringify(choice))), count: known.length };
}

/** Gives the page's playground a document as a script does. */
export const give = (page: Page, text: string): Promise<void> =>
  page.evaluate((text) => {
    (document.querySelector("mo-copp-playground") as unknown as { document: string }).document = text;
  }, text);

/** Opens an exercise as the page's own problem. */
export async function openExercise(page: Page, name: string): Promise<void> {
  await page.locator("mo-copp-playground[data-status=optimal]").waitFor();
  await give(page, exerciseText(name));
  const { title, vary } = JSON.parse(exerciseText(name)).exercise;
  await page.locator("#exercise-title", { hasText: title }).waitFor();
  // Where each student has another one: that of the document.
  if (vary !== undefined) await page.getByRole("button", { name: "Without a name" }).click();
  await page.locator("#exercise-question").waitFor();
}

/** What the page tells of answers and scores from now on. */
export const hear = (page: Page): Promise<void> =>
  page.evaluate(() => {
    const heard: unknown[] = [];
    Object.assign(window, { heard });
    for (const type of ["mo-copp-answer", "mo-copp-score"])
      addEventListener(type, (event) => heard.push([type, (event as CustomEvent).detail]));
  });

export const heardOn = (page: Page): Promise<[string, Record<string, unknown>][]> =>
  page.evaluate(() => (window as unknown as { heard: [string, Record<string, unknown>][] }).heard);
