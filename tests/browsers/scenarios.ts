// What must work in every browser: the gallery in both cores, solving, stepping, editing, embedding, sharing.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import type { Outcome, Trace } from "../../www/src/core.js";
import { unpack } from "../../www/src/share/packed.js";
import { replay, solve } from "../page/support/core.js";
import { documentOf, entries } from "../page/support/gallery.js";
import { type Driver, waitFor } from "./drivers/driver.js";
import { button, choose, labelled, playground, press, show } from "./playground.js";
import type { Site } from "./site.js";
import { ways } from "./ways.js";

export interface Scenario {
  name: string;
  run(driver: Driver, site: Site): Promise<void>;
}

const shown = (driver: Driver, root = "document") =>
  driver.evaluate<{
    gd: string;
    step: string;
    believed: Record<string, string[]>;
    goals: Record<string, string>[];
  }>(`(() => {
    const root = ${root};
    const { gd, step } = root.querySelector("mo-copp-playground").dataset;
    const cells = (board) => all('[data-board="' + board + '"] [data-cell][data-believed]', root)
      .map((cell) => cell.dataset.cell).sort();
    const goals = all("[data-goal]", root).map(({ dataset }) => ({ ...dataset }));
    return { gd, step, believed: { adversarial: cells("adversarial"), cooperative: cells("cooperative") }, goals };
  })()`);

/** The step that is shown against the core's own trace of the plan, run in Node. */
async function assertStep(driver: Driver, step: number, trace: Trace, cells: boolean): Promise<void> {
  await waitFor(driver, playground(`[data-step="${step}"]`));
  const { believed, goals } = await shown(driver);
  const expected = trace.steps[step] ?? assert.fail(`the trace has no step ${step}`);
  assert.notEqual(goals.length, 0);
  for (const role of ["adversarial", "cooperative"] as const) {
    if (cells) assert.deepEqual(believed[role], expected.beliefs[role].map(String).sort(), `${role} at ${step}`);
    for (const goal of goals) {
      const alive = expected.goals[role].includes(goal.goal ?? "");
      assert.equal(goal[role], alive ? "alive" : "dead", `${goal.goal}, ${role} at ${step}`);
    }
  }
}

const answers = new Map<string, { outcome: Outcome; trace: Trace }>();

function answer(name: string): { outcome: Outcome; trace: Trace } {
  const known = answers.get(name) ?? solve(documentOf(name), { solver: "exact" });
  answers.set(name, known);
  return known;
}

const slider = (root = "document") => `all('.stepper input[type="range"]', ${root})[0]`;
const SLIDER = slider();

async function gallery(driver: Driver, site: Site): Promise<void> {
  await driver.open(site.address);
  for (const { name, title } of entries) {
    const { outcome } = answer(name);
    await waitFor(
      driver,
      `${playground(`[data-status="optimal"][data-gd="${outcome.goal_difference}"]`)} &&
        all(".problem-bar .title")[0].textContent.includes(${JSON.stringify(title)})`,
      `${title} solved`,
    );
    const { format } = JSON.parse(documentOf(name));
    // The plan that is shown is one of the best; it need not be the same as in Node where the page shows a named one.
    const plan = await driver.evaluate<string>(`${SLIDER}.max`);
    if (Number(plan) === outcome.plan?.length) {
      await driver.press(SLIDER, "Home");
      await assertStep(driver, 0, answer(name).trace, format === "gridworld");
      await driver.press(SLIDER, "ArrowRight");
      await assertStep(driver, 1, answer(name).trace, format === "gridworld");
    }
    await press(driver, button("Next problem"));
  }
  assert(site.fetched("mo_copp_light_bg"), "the page began with the light core");
  assert(site.fetched("mo_copp_bg"), "problems in PDDL took the full one");
}

async function solvers(driver: Driver, site: Site): Promise<void> {
  await driver.open(`${site.address}?problem=corridor`);
  await waitFor(driver, playground('[data-status="optimal"]'));
  const document = documentOf("corridor");
  await show(driver, "Solve");
  await choose(driver, "Solver", "baseline");
  await press(driver, button("Solve"));
  await waitFor(driver, playground('[data-status="solved"]'));
  const horizon = solve(document, { solver: "exact" }).outcome.horizon ?? assert.fail("no plan");
  for (const encoding of ["belief-flow", "paper"] as const) {
    await choose(driver, "Solver", "ip");
    await choose(driver, "Encoding", encoding);
    await press(driver, button("Solve"));
    await waitFor(driver, `text().includes("Integer program: proved best")`);
    const { outcome } = solve(document, { solver: "ip", encoding });
    assert.equal((await shown(driver)).gd, String(outcome.goal_difference));
    assert.equal(outcome.horizon !== null && outcome.horizon <= horizon, true);
    // The exact search needs no press of a button.
    await choose(driver, "Solver", "exact");
    await waitFor(driver, playground('[data-status="optimal"]'));
  }
  assert(site.fetched("mo_copp_bg"), "an integer program takes the full core");
  await driver.type(labelled("Plan length"), String(horizon + 2));
  const longer = solve(document, { solver: "exact", horizon: horizon + 2 }).outcome;
  await waitFor(driver, `${playground(`[data-status="${longer.status}"]`)} && ${SLIDER}.max === "${horizon + 2}"`);
  assert.equal((await shown(driver)).gd, String(longer.goal_difference));
}

async function steps(driver: Driver, site: Site): Promise<void> {
  await driver.open(`${site.address}?problem=head-fake`);
  await waitFor(driver, playground('[data-status="optimal"]'));
  const { trace } = answer("head-fake");
  await driver.press(SLIDER, "Home");
  for (let step = 0; step < 4; step += 1) {
    await assertStep(driver, step, trace, true);
    if (step % 2 === 0) await driver.press(SLIDER, "ArrowRight");
    else await press(driver, button("Forward one step"));
  }
  await press(driver, button("Back one step"));
  await assertStep(driver, 3, trace, true);
  await driver.press(SLIDER, "End");
  await assertStep(driver, trace.steps.length - 1, trace, true);
}

async function editing(driver: Driver, site: Site): Promise<void> {
  await driver.open(`${site.address}?problem=corridor`);
  await waitFor(driver, playground('[data-status="optimal"]'));
  const document = JSON.parse(documentOf("corridor"));
  const walls = new Set(document.walls.map(String));
  const taken = new Set([
    ...document.goals.map(({ cell }: { cell: number[] }) => String(cell)),
    String(document.start),
  ]);
  const cells = Array.from({ length: document.width * document.height }, (_, at) =>
    String([at % document.width, Math.floor(at / document.width)]),
  );
  const free = cells.find((cell) => !walls.has(cell) && !taken.has(cell)) ?? assert.fail("no free cell");
  const [goal] = document.goals;
  const cell = (at: string) => `all('[data-board="actor"] [data-cell="${at}"]')[0]`;
  await driver.drag(cell(String(goal.cell)), cell(free));
  const moved = JSON.stringify({
    ...document,
    goals: document.goals.map((one: { cell: number[] }) =>
      one === goal ? { ...one, cell: free.split(",").map(Number) } : one,
    ),
  });
  const { outcome } = solve(moved, { solver: "exact" });
  await waitFor(driver, `text().includes("An edited problem")`);
  await waitFor(driver, playground(`[data-status="${outcome.status}"][data-gd="${outcome.goal_difference}"]`));
  await press(driver, button("Undo"));
  await waitFor(driver, `text().includes(${JSON.stringify("One step too far")})`);
  const before = answer("corridor").outcome.goal_difference;
  await waitFor(driver, playground(`[data-status="optimal"][data-gd="${before}"]`));
}

async function embedding(driver: Driver, site: Site): Promise<void> {
  await driver.open(`${site.address}embed.html`);
  await driver.evaluate(
    `document.addEventListener("mo-copp-step", ({ detail }) => (window.lastStep = detail.step)) ?? null`,
  );
  await waitFor(driver, `document.querySelector('#parity:is([data-status="optimal"], [data-status="solved"])')`);
  await waitFor(driver, `document.querySelector('#waiting[data-step="2"]')`);
  await driver.press(slider('document.querySelector("#waiting")'), "ArrowRight");
  await waitFor(driver, `document.querySelector('#waiting[data-step="3"]') && window.lastStep === 3`);
  const frame = `document.querySelector("iframe").contentDocument`;
  await waitFor(driver, `${frame}.querySelector('mo-copp-playground[data-status="optimal"]')`, "the frame's answer");
  assert.equal((await shown(driver, frame)).gd, String(answer("delivery").outcome.goal_difference));
  await driver.evaluate(`(${button("First step", frame)}).click() ?? null`);
  await waitFor(driver, `${frame}.querySelector('mo-copp-playground[data-step="0"]')`);
}

async function article(driver: Driver, site: Site): Promise<void> {
  await driver.open(`${site.address}learn/index.html`);
  await driver.evaluate(`document.querySelector("#figure-survivors").scrollIntoView() ?? null`);
  await waitFor(driver, `document.querySelector('#survivors[data-step="0"]')`);
  await driver.evaluate(
    `document.querySelector('a[data-mo-copp-for="survivors"][data-mo-copp-set-step="4"]').click() ?? null`,
  );
  await waitFor(driver, `document.querySelector('#survivors[data-step="4"]:not([data-gd="0"])')`);
  const later = `document.querySelectorAll("#figure-belief-automaton .later").length`;
  const before = await driver.evaluate<number>(later);
  await driver.evaluate(`document.querySelectorAll("#figure-belief-automaton button")[1].click() ?? null`);
  assert.equal(await driver.evaluate<number>(later), before - 1);
}

/** The page's address, once it holds this step: it follows what is shown with a little delay. */
async function linkTo(driver: Driver, step: number): Promise<string> {
  for (let known = ""; ; ) {
    await waitFor(driver, `location.hash !== ${JSON.stringify(known)}`, `a link to step ${step}`);
    const link = await driver.evaluate<string>("location.href");
    known = new URL(link).hash;
    const state = JSON.parse(await unpack(known.slice(1)));
    if (state.step === step) return link;
  }
}

async function sharing(driver: Driver, site: Site): Promise<void> {
  await driver.open(`${site.address}?problem=head-fake`);
  await waitFor(driver, playground('[data-status="optimal"]'));
  await driver.press(SLIDER, "Home");
  await driver.press(SLIDER, "ArrowRight");
  await waitFor(driver, playground('[data-step="1"]'));
  await press(driver, button("Copy link"));
  // A browser without a hand at it may not let the page use the clipboard: then the link stands in a field.
  await waitFor(
    driver,
    `all("button").some((one) => one.textContent.trim() === "Copied") ||
      all("input").some((one) => one.value.includes("#1."))`,
    "the link",
  );
  const link = await linkTo(driver, 1);
  const before = await shown(driver);
  await driver.open("about:blank");
  await driver.open(link);
  await waitFor(driver, playground(`[data-step="1"][data-gd="${before.gd}"]`));
  const after = await shown(driver);
  assert.deepEqual(after, before);
  const trace = replay(documentOf("head-fake"), answer("head-fake").outcome.plan ?? []);
  await assertStep(driver, 1, trace, true);
}

/** What the command writes: `tests/pictures.rs`. */
const golden = readFileSync(new URL("../golden/picture.svg", import.meta.url), "utf8");

async function pictures(driver: Driver, site: Site): Promise<void> {
  await driver.open(`${site.address}?problem=eight-by-eight&plan=north,north,east&step=2`);
  await waitFor(driver, playground('[data-step="2"]'));
  const svg = await driver.evaluate<string>(`${playground("")}.toSVG({ theme: "light" })`);
  assert(svg === golden, "the element gives the text that the command writes");
  // What would be saved is kept in the page.
  await driver.evaluate(`(() => {
    window.saved = [];
    URL.createObjectURL = (blob) => { window.saved.push(blob); return "#"; };
    HTMLAnchorElement.prototype.click = () => {};
    return null;
  })()`);
  await press(driver, button("Save picture"));
  await choose(driver, "Colours", "light");
  // WebKit gives the size at which it is shown for that of the picture.
  const isSlide = "complete && naturalWidth > 0 && Math.abs(naturalWidth / naturalHeight - 1184 / 666) < 0.01";
  await waitFor(driver, `all("dialog img").some(({ complete, naturalWidth, naturalHeight }) => ${isSlide})`);
  await press(driver, button("Step 2 as PNG"));
  await waitFor(driver, `text().includes("Saved: eight-by-eight-step-2.png")`);
  const png = await driver.evaluate<{ type: string; width: number; height: number; signs: number[] }>(`(async () => {
    const [blob] = window.saved;
    const image = await createImageBitmap(blob);
    const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    // The grounds of what the enemy and the friend believe.
    const signs = [[245, 205, 184], [185, 217, 241]].map(([red, green, blue]) => {
      let found = 0;
      for (let at = 0; at < data.length; at += 4)
        if (data[at] === red && data[at + 1] === green && data[at + 2] === blue) found += 1;
      return found;
    });
    return { type: blob.type, width: image.width, height: image.height, signs };
  })()`);
  assert.deepEqual([png.type, png.width, png.height], ["image/png", 2368, 1332]);
  // At least one cell of each, 42 units wide, at twice its size.
  for (const found of png.signs) assert(found > 4000, `${png.signs}`);
}

export const scenarios: readonly Scenario[] = [
  { name: "every problem of the gallery is opened, solved and stepped through, by both cores", run: gallery },
  { name: "the solvers answer, integer programs too", run: solvers },
  { name: "steps are walked by keys and buttons", run: steps },
  { name: "a goal is dragged to another cell, and back by undo", run: editing },
  { name: "elements and a frame stand in one page, and tell of their steps", run: embedding },
  { name: "the article's words drive its figures, and its automaton grows", run: article },
  { name: "a link brings back what was shown", run: sharing },
  { name: "a picture has the text that the command writes, and a PNG is made of it", run: pictures },
  { name: "the element solves from any host, in any frame and without a server", run: ways },
];
