// A PDDL document as PDDL: three texts that write one document.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { compose, partNames, split } from "../../www/src/text/parts.js";
import { templates } from "../../www/src/text/templates.js";
import { taken } from "./support/core.js";
import { Dice } from "./support/dice.js";
import { documentOf, edit } from "./support/hands.js";
import { openTab, press, statusIs } from "./support/playground.js";
import { field, linesOf, put, retype, said, textIs } from "./support/text.js";

const lamps = templates.find(({ title }) => title === "PDDL")?.text ?? assert.fail();

const onPddl = (use: (page: Page) => Promise<void>) =>
  edit(async (page) => {
    await openTab(page, "Document");
    await put(page, lamps);
    await said(page, "No errors.").waitFor();
    await press(page, "PDDL");
    await field(page, "Domain (PDDL)").waitFor();
    await use(page);
  });

const errorUnder = async (page: Page, name: string): Promise<[string | undefined, string | undefined]> => {
  const lines = await linesOf(page, name);
  const at = lines.findIndex((line) => line.startsWith("[") && line.includes("found"));
  return [lines[at - 1], lines[at]];
};

test("errors in PDDL stand under their line of the domain, the problem and the rest", () =>
  onPddl(async (page) => {
    await retype(page, "types", "kinds", "Domain (PDDL)");
    await said(page, "domain, line 4, column 4").waitFor();
    const domain = await errorUnder(page, "Domain (PDDL)");
    assert.match(domain[0] ?? "", /\(:kinds room\)/);
    assert.match(domain[1] ?? "", /found ":kinds"/);
    assert.equal(
      await page
        .locator(".cm-fault")
        .allTextContents()
        .then((words) => words.join("")),
      ":kinds",
    );
    await retype(page, "kinds", "types", "Domain (PDDL)");
    await retype(page, "kitchen", "cellar", "Problem (PDDL)");
    await said(page, "problem, line 4").waitFor();
    assert.match((await errorUnder(page, "Problem (PDDL)"))[0] ?? "", /:init \(dark kitchen/);
    // F8 goes from one field to the other that has the error.
    await field(page, "Domain (PDDL)").focus();
    await page.keyboard.press("F8");
    await page.keyboard.press("Control+ArrowRight");
    await page.keyboard.press("Control+Backspace");
    await page.keyboard.type("cellar");
    await said(page, "goals[0].condition").waitFor();
    const rest = await errorUnder(page, "Goals and observers (JSON)");
    assert.match(rest[0] ?? "", /"light in the kitchen", "condition"/);
    await page.keyboard.press("F8");
    await page.keyboard.press("Control+ArrowRight");
    await page.keyboard.press("Control+Backspace");
    await page.keyboard.type("cellar");
    await page.waitForFunction(() =>
      [...document.querySelectorAll(".text-field")].every(
        (text) => text.shadowRoot?.querySelector(".cm-fault") === null,
      ),
    );
    await field(page, "Goals and observers (JSON)").press("Control+Enter");
    await page.locator("[data-goal='light in the kitchen']").first().waitFor();
    await statusIs(page, "optimal");
    // It is one document.
    const opened = await documentOf<object>(page);
    assert.equal(taken(JSON.stringify(opened)), true);
    assert.deepEqual(opened, JSON.parse(lamps.replaceAll(/(dark|lit|objects) kitchen/g, "$1 cellar")));
  }));

test("going between JSON and PDDL loses nothing, right or wrong", () =>
  onPddl(async (page) => {
    await press(page, "JSON");
    await textIs(page, lamps);
    await press(page, "PDDL");
    const halfDone = ['(define (domain "', "(define", '{\n  "goals": [oops'];
    for (const [index, name] of ["Domain (PDDL)", "Problem (PDDL)", "Goals and observers (JSON)"].entries()) {
      await put(page, halfDone[index] ?? "", name);
    }
    await said(page, "line").waitFor();
    await press(page, "JSON");
    await said(page, "line").waitFor();
    assert.match((await linesOf(page)).join("\n"), /"\(define \(domain \\"".*"\(define".*\[oops/s);
    await openTab(page, "Solve");
    await openTab(page, "Document");
    await press(page, "PDDL");
    for (const [index, name] of ["Domain (PDDL)", "Problem (PDDL)", "Goals and observers (JSON)"].entries()) {
      await textIs(page, halfDone[index] ?? "", name);
    }
    // Broken by hand it can't be told what is PDDL; that is said.
    await press(page, "JSON");
    await put(page, lamps.slice(0, -3));
    await page.getByText("The JSON must be whole").waitFor();
    assert.equal(await page.getByRole("button", { name: "PDDL", exact: true }).isDisabled(), true);
  }));

const example = (name: string) => readFileSync(new URL(`../../examples/${name}.json`, import.meta.url), "utf8");

test("the parts of a document make the same document again", () => {
  for (const text of [lamps, example("blocksworld"), example("logistics"), example("driverlog")]) {
    const parts = split(text) ?? assert.fail();
    assert.deepEqual(JSON.parse(compose(parts)), JSON.parse(text));
    assert.deepEqual(split(compose(parts)), parts);
  }
  assert.equal(split(lamps.replace('"goals"', '"goals": 1, "goals"')), null);
  assert.equal(split(lamps.replace('"pddl"', '"explicit"')), null);
  assert.equal(split('{"format": "pddl", "domain": ["x", 1], "problem": "y"}'), null);
  assert.deepEqual(split('{"format": "pddl", "domain": "x\\ny", "problem": [""]}'), {
    domain: "x\ny",
    problem: "",
    rest: "{\n}\n",
  });
});

test("parts of any characters come back from what they make", () => {
  const dice = new Dice(7);
  const piece = () => dice.of(['"', "\\", "\n", "(", ")", "{", "}", "[", ",", " ", "é", "🏔", "\u2028", "x", ";"]);
  const any = () => Array.from({ length: dice.below(12) }, piece).join("");
  let whole = 0;
  for (let count = 0; count < 3000; count += 1) {
    const rest = dice.coin() ? any() : `{"goals": ${JSON.stringify(any())}, ${JSON.stringify(any())}: {}}`;
    const parts = { domain: any(), problem: any(), rest };
    const text = compose(parts);
    const again = split(text);
    assert(text.endsWith(rest.replace(/^\s*\{\s*/, "")));
    if (again === null) continue;
    whole += 1;
    for (const name of partNames.slice(0, 2)) assert.equal(again[name], parts[name]);
  }
  assert(whole > 500, String(whole));
});
