// The edit tab: sizes, goals, sensors, cameras and beliefs of a grid; the parts of a delivery.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import type { DeliveryDocument } from "../../www/src/problem/types.js";
import { solve } from "./support/core.js";
import { explicit, figure1 } from "./support/documents.js";
import { assertLive, documentOf, dragMouse, edit } from "./support/hands.js";
import { attribute, openTab, press, stepIs, useDocument } from "./support/playground.js";

const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

async function enter(page: Page, label: string, text: string): Promise<void> {
  await page.getByLabel(label, { exact: true }).fill(text);
  await page.getByLabel(label, { exact: true }).press("Enter");
}

for (const [device, options] of [
  ["desktop", {}],
  ["phone", phone],
] as const) {
  test(`the size and staying, ${device}`, () =>
    edit(async (page) => {
      await openTab(page, "Edit");
      await enter(page, "Columns", "5");
      await page.getByText("To fit, G1 moved to column 4, row 0,").waitFor();
      await page.waitForFunction(() => document.querySelectorAll('[data-board="actor"] [data-cell]').length === 40);
      await enter(page, "Rows", "32");
      const tall = await assertLive(page);
      assert.deepEqual([tall.width, tall.height], [5, 32]);
      await enter(page, "Rows", "33");
      await page.getByText("A whole number from 2 to 32.").waitFor();
      assert.equal((await documentOf(page)).height, 32);
      await enter(page, "Rows", "2");
      assert.equal((await assertLive(page)).height, 2);
      await page.getByLabel("The agent may also stay").check();
      await page.getByLabel("Staying").first().waitFor();
      const staying = await assertLive(page);
      assert.deepEqual([staying.stay, staying.observers.cooperative.sensor.stay], [true, "stay"]);
      await press(page, "Undo");
      await page.getByLabel("Staying").first().waitFor({ state: "detached" });
      assert.equal(await page.getByLabel("The agent may also stay").isChecked(), false);
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert(overflow <= 0, `${overflow} pixels too wide`);
    }, options));
}

test("a grid that is made too small for its goals stays as it is, and says why", () =>
  edit(async (page) => {
    await openTab(page, "Edit");
    await press(page, "Add a goal");
    await enter(page, "Columns", "2");
    await page.getByText(/^To fit, /).waitFor();
    const { start, goals } = await assertLive(page);
    assert.equal(new Set([start, ...goals.map(({ cell }) => cell)].map(String)).size, 6);
    await enter(page, "Rows", "2");
    await page
      .getByText("Too small: there are 4 free cells for the goals’ 5 places. Remove goals or walls first.")
      .waitFor();
    assert.equal(await page.getByLabel("Rows", { exact: true }).getAttribute("aria-invalid"), "true");
    assert.equal((await documentOf(page)).height, 8);
  }));

test("goals are named, added, removed, and one is true", () =>
  edit(async (page) => {
    await openTab(page, "Edit");
    await enter(page, "Name of goal 1", "<img src=x onerror=alert(1)>");
    const named = await assertLive(page);
    assert.equal(named.true_goal, "<img src=x onerror=alert(1)>");
    await enter(page, "Name of goal 2", "G3");
    await page.getByText("“G3” is taken").waitFor();
    assert.equal(await page.getByLabel("Name of goal 2").getAttribute("aria-invalid"), "true");
    await enter(page, "Name of goal 2", " ");
    await page.getByText("A name is needed.").waitFor();
    assert.equal((await documentOf(page)).goals[1]?.name, "G2");
    await enter(page, "Name of goal 2", " Exit ");
    assert.equal(await page.getByLabel("Name of goal 2").inputValue(), "Exit");
    await page.getByLabel("G4 is the true goal").check();
    assert.equal((await assertLive(page)).true_goal, "G4");
    await press(page, "Add a goal");
    assert.deepEqual((await assertLive(page)).goals.at(-1), { name: "G1", cell: [7, 7] });
    await dragMouse(page, "actor", [
      [7, 7],
      [4, 0],
    ]);
    await page.getByText("column 4, row 0").waitFor();
    await press(page, "Remove G4");
    assert.equal((await assertLive(page)).true_goal, "<img src=x onerror=alert(1)>");
    await press(page, "Remove G1");
    await press(page, "Remove G3");
    // The keyboard is still in the list.
    assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("aria-label")), "Remove Exit");
    await press(page, "Remove Exit");
    await page.getByText("At least two goals stay").waitFor();
    assert.equal((await assertLive(page)).goals.length, 2);
  }));

test("sensors by preset and by symbol, cameras and first beliefs", () =>
  edit(async (page) => {
    await openTab(page, "Edit");
    const enemy = page.getByRole("group", { name: "What the enemy is told" });
    const sensor = enemy.getByLabel("Sensor");
    await sensor.selectOption({ label: "Sees every move" });
    const seen = await assertLive(page);
    assert.deepEqual(seen.observers.adversarial.sensor, { north: "north", south: "south", east: "east", west: "west" });
    await sensor.selectOption("nothing");
    assert.deepEqual(new Set(Object.values((await assertLive(page)).observers.adversarial.sensor)).size, 1);
    await enemy.getByLabel("Moving north").fill("up");
    await enemy.getByLabel("Moving east").focus();
    assert.equal((await assertLive(page)).observers.adversarial.sensor.north, "up");
    assert.equal(await sensor.locator("option:checked").textContent(), "Symbols of its own");
    assert(await page.locator('datalist option[value="up"]').count());
    await enemy.getByLabel("Moving north").fill("");
    await enemy.getByLabel("Moving north").press("Enter");
    await page.getByText("A symbol for north is needed").waitFor();
    const cameras = page.getByRole("group", { name: "Cameras of the enemy" });
    await cameras.getByRole("button", { name: "Everywhere" }).click();
    await page.getByText("in 53 cells").waitFor();
    await assertLive(page);
    await cameras.getByRole("button", { name: "None" }).click();
    assert.equal((await assertLive(page)).observers.adversarial.cameras, undefined);
    await cameras.getByRole("button", { name: "Paint" }).click();
    await dragMouse(page, "adversarial", [[4, 0]]);
    await cameras.getByText("in 1 cell").waitFor();
    const belief = page.getByRole("group", { name: "First belief of the friend" });
    await belief.getByRole("button", { name: "Everywhere" }).click();
    await belief.getByText("53 cells").waitFor();
    await assertLive(page);
    await belief.getByRole("button", { name: "Start alone" }).click();
    await belief.getByText("1 cell").waitFor();
    await belief.getByRole("button", { name: "Paint" }).click();
    await stepIs(page, 0);
    await dragMouse(page, "cooperative", [[4, 0]]);
    assert.deepEqual((await assertLive(page)).observers.cooperative.initial_belief?.map(String), ["0,7", "4,0"]);
  }));

test("a new grid begins empty, and Undo brings the problem back", () =>
  edit(async (page) => {
    const before = await documentOf(page);
    await openTab(page, "Edit");
    await press(page, "New grid");
    const empty = await assertLive(page);
    assert.deepEqual([empty.width, empty.walls?.length], [8, 0]);
    assert.equal(await page.getByRole("button", { name: "Reset" }).getAttribute("aria-disabled"), "true");
    await press(page, "Undo");
    assert.deepEqual(await documentOf(page), before);
  }));

test("a delivery is edited in all its parts", () =>
  edit(async (page) => {
    await useDocument(page, figure1);
    await page.locator("[data-goal='a1+b1']").first().waitFor();
    await openTab(page, "Edit");
    const live = async () => {
      const document = await documentOf<DeliveryDocument>(page);
      const { outcome } = solve(JSON.stringify(document), { solver: "exact" });
      assert.equal(await attribute(page, "data-gd"), String(outcome.goal_difference));
      return document;
    };
    await page.getByLabel("True goal").selectOption("a1+b1");
    assert.equal((await live()).true_goal, "a1+b1");
    assert.equal(await attribute(page, "data-gd"), "0.4");
    await page.getByLabel("Name of package 1 at A").fill("b1");
    await page.getByLabel("Name of package 1 at A").press("Enter");
    await page.getByText("“b1” is taken").waitFor();
    await enter(page, "Name of package 1 at A", "p+q");
    await page.getByText("can’t hold “+”").waitFor();
    await enter(page, "Name of package 1 at A", "parcel");
    assert.equal((await live()).true_goal, "parcel+b1");
    await press(page, "Add a factory");
    await press(page, "Add a package at C");
    await page.getByText("3 of 5 (10 candidate goals)").waitFor({ state: "attached" });
    await page.getByLabel("Packages at once").selectOption("3");
    assert.equal((await live()).true_goal, "parcel+a2+b1");
    const friend = page.getByRole("group", { name: "What the friend is told" });
    await friend.getByLabel("Sensor").selectOption({ label: "Reads each package" });
    assert.equal((await live()).observers.cooperative.sensor.load instanceof Object, true);
    await friend.getByLabel("Sensor").selectOption({ label: "Reads the factory" });
    await friend.getByLabel("Loading c1").fill("special");
    await friend.getByLabel("Loading c1").press("Enter");
    const { load } = (await live()).observers.cooperative.sensor;
    assert.deepEqual(load, { A: "barcode A", B: "barcode B", C: "barcode C", c1: "special" });
    await press(page, "Remove c1");
    assert.equal((await live()).factories[2]?.packages.length, 0);
    for (const name of ["parcel", "a2"]) await press(page, `Remove ${name}`);
    await press(page, "Remove b2");
    await page.getByText("At least two packages stay").waitFor();
    assert.deepEqual((await live()).deliver, 1);
    assert.equal(await page.getByRole("group", { name: "Tools" }).count(), 0);
    for (let count = 0; count < 3; count += 1) await press(page, "Undo");
    assert.equal((await live()).deliver, 3);
  }));

test("a problem written state by state is edited as text", () =>
  edit(async (page) => {
    await useDocument(page, explicit);
    await page.locator("[data-board=actor] .state-name").waitFor();
    await openTab(page, "Edit");
    await press(page, "Edit as text");
    await page.getByLabel("Problem document (JSON)").waitFor();
  }));
