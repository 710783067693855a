// The two builds of the core: the page begins with the light one, and the full one is fetched when something needs it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import type { Page } from "playwright-core";
import initLight, { Problem as LightProblem } from "../../www/pkg-light/mo_copp_light.js";
import type { SolveOptions } from "../../www/src/core.js";
import { type Options, type Visit, visit } from "./support/browser.js";
import { scene, solve } from "./support/core.js";
import { grid } from "./support/documents.js";
import { documentOf, entries } from "./support/gallery.js";
import { attribute, choose, openTab, press, statusIs, useDocument } from "./support/playground.js";
import { address } from "./support/site.js";
import { withoutLookingAhead } from "./support/workers.js";

await initLight({
  module_or_path: readFileSync(new URL("../../www/pkg-light/mo_copp_light_bg.wasm", import.meta.url)),
});

/** Two rooms to go to, in PDDL. */
const rooms = (change: Record<string, unknown> = {}) =>
  JSON.stringify({
    format: "pddl",
    domain: `(define (domain rooms) (:predicates (at ?x) (door ?x ?y))
      (:action walk :parameters (?x ?y) :precondition (and (at ?x) (door ?x ?y)) :effect (and (at ?y) (not (at ?x)))))`,
    problem: `(define (problem two) (:domain rooms) (:objects hall left right)
      (:init (at hall) (door hall left) (door left hall) (door hall right) (door right hall)))`,
    goals: [
      { name: "L", condition: "(at left)" },
      { name: "R", condition: "(at right)" },
    ],
    true_goal: "L",
    observers: { adversarial: { sensor: "{name}" }, cooperative: { sensor: "{name} {2}" } },
    ...change,
  });

const isFull = (address: string) => /\/mo_copp_bg-[^/]*\.wasm$/.test(address);
const isLight = (address: string) => /\/mo_copp_light_bg-[^/]*\.wasm$/.test(address);
const fetched = ({ requests }: Visit) => ({
  light: requests.filter(isLight).length,
  full: requests.filter(isFull).length,
});

function run(problem: LightProblem, options: SolveOptions) {
  const at = problem.solve(options);
  while (!at.advance(10_000));
  const { stats, ...rest } = at.outcome();
  const { seconds: _, ...work } = stats;
  return { ...rest, stats: work };
}

const inPddl = (name: string) => JSON.parse(documentOf(name)).format === "pddl";

for (const { name } of entries.filter(({ name }) => !inPddl(name))) {
  test(`the light core answers as the full one: ${name}`, () => {
    const document = documentOf(name);
    const problem = new LightProblem(document);
    assert.deepEqual(problem.scene(), scene(document));
    const { outcome, trace } = solve(document, { solver: "exact" });
    const { seconds: _, ...stats } = outcome.stats;
    const light = run(problem, { solver: "exact" });
    assert.deepEqual(light, { ...outcome, stats });
    assert.deepEqual(problem.trace(light.plan ?? []), trace);
    problem.free();
  });
}

const needsFull = (error: unknown) => error instanceof Error && error.name === "NeedsFullCore";

test("the light core says what needs the full one, and only that", () => {
  assert.throws(() => new LightProblem(rooms()), needsFull);
  // Whether it is right, only the full core can tell.
  assert.throws(() => new LightProblem(rooms({ domain: "(nonsense" })), needsFull);
  const problem = new LightProblem(grid());
  for (const encoding of ["belief-flow", "paper"] as const) {
    assert.throws(() => problem.solve({ solver: "ip", encoding, horizon: 5 }), needsFull);
  }
  for (const solver of ["search", "satisficing", "obfuscate", "legible", "baseline"] as const) {
    assert.throws(() => problem.solve({ solver }), needsFull);
  }
  for (const more of [{ pairs: true }, { pareto: true }, { lengths: 5 }]) {
    assert.throws(() => problem.solve({ solver: "exact", ...more }), needsFull);
  }
  assert.throws(() => problem.remedy({ solver: "exact", horizon: 1 }), needsFull);
  assert.throws(() => problem.picture([], {}), needsFull);
  const named = (name: string) => (error: unknown) => error instanceof Error && error.name === name;
  assert.throws(() => new LightProblem('{"format": "chess"}'), named("DocumentError"));
  assert.throws(() => problem.solve({ solver: "ip", k: 9 }), named("OptionsError"));
  assert.equal(run(problem, { solver: "exact", horizon: 5, k: 1, j: 2 }).status, "optimal");
});

/** What needs the full core fetches it; nothing else does. */
const onDemand = (use: (visited: Visit) => Promise<void>, options: Options = {}) =>
  visit(use, { before: withoutLookingAhead, ...options });

test("in the first pause the full core is fetched, and everything is answered by it from then on", () => {
  let came = (): void => undefined;
  const full = new Promise<void>((resolve) => {
    came = resolve;
  });
  return visit(
    async (visited) => {
      const { page } = visited;
      await statusIs(page, "optimal");
      const difference = await attribute(page, "data-gd");
      await full;
      assert.deepEqual(fetched(visited), { light: 1, full: 1 });
      // It is there, or on its way: nothing is fetched again.
      await network(page, false);
      await choose(page, "Solver", "ip");
      await press(page, "Solve");
      await page.getByText(/^Integer program: proved best/).waitFor();
      await choose(page, "Solver", "exact");
      await page.waitForSelector(`mo-copp-playground[data-status=optimal][data-gd="${difference}"]`);
      assert.deepEqual(fetched(visited), { light: 1, full: 1 });
    },
    {
      before: async (page) => {
        page.context().on("response", (response) => {
          if (isFull(new URL(response.url()).pathname)) came();
        });
      },
    },
  );
});

test("in a page of other people the full core is fetched once somebody is at work in the playground, and not before", () =>
  visit(async (visited) => {
    const { page } = visited;
    await page.goto("about:blank");
    visited.requests.length = 0;
    await page.route(`${address}lesson/page.html`, (route) =>
      route.fulfill({
        contentType: "text/html",
        body: `<!doctype html><html lang="en"><title>Lesson</title><link rel="icon" href="data:,">
          <script type="module" src="../mo-copp-playground.js"></script><h1>Lesson</h1>
          <mo-copp-playground id="one" problem="corridor"></mo-copp-playground>`,
      }),
    );
    // The pause is over as soon as it has begun: a page that waits for one fetches the core at once.
    await page.clock.install();
    await page.goto(`${address}lesson/page.html`);
    const until = async (there: () => Promise<boolean>) => {
      while (!(await there())) await page.clock.runFor(100);
    };
    await until(() => page.locator("#one[data-status=optimal]").isVisible());
    await page.getByRole("heading", { name: "Lesson" }).click();
    await page.clock.runFor(60_000);
    await page.waitForLoadState("networkidle");
    assert.deepEqual(fetched(visited), { light: 1, full: 0 });
    await page.locator("#one [data-board=actor]").click({ position: { x: 5, y: 5 } });
    const asked = page.context().waitForEvent("request", (request) => isFull(new URL(request.url()).pathname));
    await page.clock.runFor(2000);
    await asked;
  }));

test("the first load fetches the light core alone, another solver the full one, once", () =>
  onDemand(async (visited) => {
    const { page } = visited;
    await statusIs(page, "optimal");
    // The answer comes with the page, and the core after it.
    if (fetched(visited).light === 0)
      await page.context().waitForEvent("request", (request) => isLight(new URL(request.url()).pathname));
    assert.deepEqual(fetched(visited), { light: 1, full: 0 });
    const difference = await attribute(page, "data-gd");
    await choose(page, "Solver", "search");
    await press(page, "Solve");
    await statusIs(page, "solved");
    assert.deepEqual(fetched(visited), { light: 1, full: 1 });
    for (const encoding of ["belief-flow", "paper"]) {
      await useDocument(page, grid());
      await openTab(page, "Solve");
      await choose(page, "Solver", "ip");
      await choose(page, "Encoding", encoding);
      await press(page, "Solve");
      await page.getByText(/^Integer program: proved best/).waitFor();
      assert.equal(await attribute(page, "data-gd"), String(solve(grid(), { solver: "ip" }).outcome.goal_difference));
    }
    // From now on the full one does everything.
    await useDocument(page, documentOf("eight-by-eight"));
    await openTab(page, "Solve");
    await choose(page, "Solver", "exact");
    await page.waitForSelector(`mo-copp-playground[data-status=optimal][data-gd="${difference}"]`);
    // The field for the text, in which the documents were put, checks them in a worker of its own.
    assert.deepEqual(fetched(visited), { light: 2, full: 1 });
  }));

test("a problem in PDDL fetches the full core and is solved by it", () =>
  onDemand(async (visited) => {
    const { page } = visited;
    await statusIs(page, "optimal");
    await useDocument(page, rooms());
    const { outcome } = solve(rooms(), { solver: "exact" });
    assert.equal(outcome.plan?.length, 1);
    await page.waitForSelector(`mo-copp-playground[data-status=optimal][data-gd="${outcome.goal_difference}"]`);
    // Two workers: that of the boards, and that of the field for the text.
    assert.deepEqual(fetched(visited), { light: 2, full: 2 });
    // What is wrong in one is said as ever.
    await useDocument(page, rooms({ true_goal: "X" }));
    await page
      .getByRole("alert")
      .getByText(/^true_goal: found "X"/)
      .waitFor();
  }));

/** Whether the full core can be had. */
async function network(page: Page, there: boolean): Promise<void> {
  await page.context().unrouteAll();
  if (!there) await page.context().route(isFullUrl, (route) => route.abort());
}
const isFullUrl = (address: URL) => isFull(address.pathname);

test("a full core that can't be loaded is said to be so, leaves the problem as it was, and is asked for again", () =>
  onDemand(
    async (visited) => {
      const { page } = visited;
      await statusIs(page, "optimal");
      const before = await page.locator("[data-board=actor]").innerHTML();
      await network(page, false);
      await useDocument(page, rooms());
      await page
        .getByText(/could not be loaded/)
        .first()
        .waitFor();
      assert.equal(await page.locator("[data-board=actor]").innerHTML(), before);
      assert.equal(await attribute(page, "data-status"), "error");

      await openTab(page, "Solve");
      await choose(page, "Solver", "ip");
      await press(page, "Solve");
      await page
        .getByText(/could not be loaded/)
        .first()
        .waitFor();
      assert.equal(await page.locator("[data-board=actor] [data-cell]").count(), 64);
      // The light one still does what it can.
      await useDocument(page, grid());
      await statusIs(page, "optimal");
      assert.equal(fetched(visited).light, 2);

      await network(page, true);
      await useDocument(page, rooms());
      await statusIs(page, "optimal");
      await page.waitForFunction(() => document.querySelectorAll("[data-cell]").length === 0);
    },
    { quiet: false },
  ));

test("while the full core is on its way, what needs the light one alone is answered", () =>
  onDemand(async (visited) => {
    const { page } = visited;
    await statusIs(page, "optimal");
    let letThrough = () => {};
    const held = new Promise<void>((resolve) => {
      letThrough = resolve;
    });
    await page.context().route(isFullUrl, async (route) => {
      await held;
      await route.continue();
    });
    const asked = page.context().waitForEvent("request", (request) => isFull(new URL(request.url()).pathname));
    await choose(page, "Solver", "ip");
    await press(page, "Solve");
    await asked;
    await press(page, "Next problem");
    await page.waitForFunction(() => document.querySelectorAll("[data-board=actor] [data-cell]").length === 54);
    await statusIs(page, "optimal");
    letThrough();
    await openTab(page, "Solve");
    await choose(page, "Solver", "ip");
    await press(page, "Solve");
    await page.getByText(/^Integer program: proved best/).waitFor();
    assert.deepEqual(fetched(visited), { light: 1, full: 1 });
  }));
