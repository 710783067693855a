// The kit for Jupyter and marimo: the widget's class in Python, and its side in the browser.
import assert from "node:assert/strict";
import { cpSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { dist } from "../../scripts/lib/paths.mjs";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import { visit } from "../page/support/browser.js";
import { grid } from "../page/support/documents.js";
import { attributes, copyOf, kit, python, ready, served } from "./support/site.js";

test("anywidget: Python's side has what is synchronised, and the browser's synchronises it", () =>
  visit(async ({ page }) => {
    const folder = copyOf("anywidget");
    cpSync(join(dist, "mo-copp-playground.single.js"), join(folder, "mo-copp-playground.single.js"));
    const told = python(
      [
        "-c",
        `import json
notebook = {}
for cell in json.load(open("page.ipynb"))["cells"]:
    if cell["cell_type"] == "code": exec("".join(cell["source"]), notebook)
state = notebook["lab"].get_state()
print(json.dumps({name: state[name] for name in ("problem", "hide", "theme", "solver", "document", "plan", "step", "outcome")} | {"script": len(state["_script"])}))`,
      ],
      folder,
    );
    const { script, ...state } = JSON.parse(told);
    assert(script > 1_000_000);
    assert.equal(state.step, 2);
    // A stand-in for the notebook's model.
    writeFileSync(
      join(folder, "notebook.html"),
      `<!doctype html><html lang="en"><title>Notebook</title><div id="out"></div><script type="module">
        import widget from "./mo_copp_widget.js";
        const values = { ...${JSON.stringify(state)}, _script: await (await fetch("mo-copp-playground.single.js")).text() };
        const listeners = {};
        window.model = {
          values,
          get: (name) => values[name],
          set: (name, value) => { values[name] = value; },
          save_changes: () => {},
          on: (name, listener) => (listeners[name] ??= []).push(listener),
          python: (name, value) => { values[name] = value; (listeners["change:" + name] ?? []).forEach((listener) => listener()); },
        };
        window.undo = await widget.render({ model: window.model, el: document.querySelector("#out") });
      </script></html>`,
    );
    await page.goto(`${await served(folder)}notebook.html`);
    await ready(page, '[data-step="2"]', "mo-copp-playground");
    const values = () => page.evaluate("window.model.values") as Promise<Record<string, unknown>>;
    await page.waitForFunction("window.model.values.outcome !== null && window.model.values.plan.length === 5");
    assert.equal((await values()).step, 2);
    await page.evaluate("window.model.python('step', 4)");
    await ready(page, '[data-step="4"]', "mo-copp-playground");
    await page.evaluate(`window.model.python("document", ${grid({ width: 6 })})`);
    await page.locator('mo-copp-playground [data-board=actor] [data-cell="5,0"]').waitFor({ state: "attached" });
    await page.waitForFunction(
      "window.model.values.document.width === 6 && window.model.values.document.format === 'gridworld'",
    );
    // A plan is set again after a walk elsewhere.
    const plan = ["north", "north"];
    const shown = (step: number) =>
      page
        .waitForFunction(
          (wanted) =>
            JSON.stringify(document.querySelector<MoCoppPlayground>("mo-copp-playground")?.state?.plan) === wanted,
          JSON.stringify(plan),
        )
        .then(() => ready(page, `[data-step="${step}"]`, "mo-copp-playground"));
    const sets = (name: string, value: unknown) =>
      page.evaluate(`window.model.python("${name}", ${JSON.stringify(value)})`);
    await sets("plan", plan);
    await shown(2);
    await page.evaluate(() => {
      const playground = document.querySelector<MoCoppPlayground>("mo-copp-playground");
      if (playground?.state) playground.state = { ...playground.state, mode: "walk", plan: ["east"], step: 1 };
    });
    await page.waitForFunction(`window.model.values.plan.join() === "east"`);
    await sets("plan", plan);
    await shown(2);
    // A step beyond the last is the last, and Python is told.
    await sets("step", 99);
    await page.waitForFunction("window.model.values.step === 2");
    await page.evaluate("window.undo()");
    assert.equal(await page.locator("mo-copp-playground").count(), 0);
  }, kit));

/** A folder with the widget and the one script. */
function widgetFolder(): string {
  const folder = copyOf("anywidget");
  cpSync(join(dist, "mo-copp-playground.single.js"), join(folder, "mo-copp-playground.single.js"));
  return folder;
}

test("the widget in Python has every attribute of the element but `link`, and sends what is set later", () => {
  const told = python(
    [
      "-c",
      `import json
from mo_copp_widget import OPTIONS, Playground
exercise = {"kind": "best"}
given = {"problem": "head-fake", "k": 2, "j": 0, "src": "x.json", "horizon": "any", "exercise": exercise, "seed": 3,
  "student": "Ada", "watch": True, "keys_": "off", "worker_url": "worker.js", "loading": "lazy", "disabled": True}
lab = Playground(**given)
lab.k, lab.horizon, lab.exercise = 3, 7, None
state = lab.get_state()
print(json.dumps({"options": sorted(OPTIONS), "state": {name: state[name] for name in given}, "synced": sorted(set(OPTIONS) - set(lab.keys))}))`,
    ],
    widgetFolder(),
  );
  const { options, state, synced } = JSON.parse(told);
  const names = attributes().filter((name) => name !== "link");
  const inPython = names.map((name) => (name === "keys" ? "keys_" : name.replaceAll("-", "_")));
  assert.deepEqual(options, ["document", ...inPython].sort());
  assert.deepEqual(synced, []);
  assert.deepEqual(state, {
    ...{ problem: "head-fake", k: 3, j: 0, src: "x.json", horizon: 7, exercise: null, seed: 3, student: "Ada" },
    ...{ watch: true, keys_: "off", worker_url: "worker.js", loading: "lazy", disabled: true },
  });
});

test("an option that the widget does not have is refused with those that it has", () => {
  const told = python(
    [
      "-c",
      `from mo_copp_widget import Playground
for options in [{"horizn": 3}, {"link": "on"}, {"keys": "off"}, {"outcome": {}}, {"k": "many"}, {"k": -1}]:
    try:
        Playground(problem="corridor", **options)
    except Exception as error:
        print(type(error).__name__, str(error).replace("\\n", " "))
    else:
        print("taken", options)
print(Playground(problem="corridor", layout={"width": "50%"}, tooltip="A corridor").layout.width)`,
    ],
    widgetFolder(),
  );
  const [misspelt, link, keys, outcome, many, below, width] = told.trim().split("\n");
  assert.match(misspelt ?? "", /^TypeError Playground has no option horizn; expected some of .*\bhorizon, .*\bkeys_, /);
  assert.match(link ?? "", /^TypeError Playground has no option link; /);
  assert.match(keys ?? "", /^TypeError Playground has no option keys; expected some of .*\bkeys_, /);
  assert.match(outcome ?? "", /^TypeError Playground has no option outcome; /);
  assert.match(many ?? "", /^TraitError .*'k' trait/);
  assert.match(below ?? "", /^TraitError .*'k' trait/);
  assert.equal(width, "50%");
});

test("the widget's element follows the attributes by the names that Python and pages of MyST have for them", () =>
  visit(async ({ page }) => {
    const folder = widgetFolder();
    writeFileSync(
      join(folder, "notebook.html"),
      `<!doctype html><html lang="en"><title>Notebook</title><div id="out"></div><script type="module">
        import widget from "./mo_copp_widget.js";
        const values = { problem: "corridor", keys_: "off", loading: "lazy", k: null, j: 0, "wasm-url": "core.wasm", exercise: null,
          _script: await (await fetch("mo-copp-playground.single.js")).text() };
        const listeners = {};
        const model = {
          get: (name) => values[name],
          set: () => {},
          save_changes: () => {},
          on: (name, listener) => (listeners[name] ??= []).push(listener),
        };
        window.python = (name, value) => { values[name] = value; (listeners["change:" + name] ?? []).forEach((listener) => listener()); };
        await widget.render({ model, el: document.querySelector("#out") });
      </script></html>`,
    );
    await page.goto(`${await served(folder)}notebook.html`);
    const element = page.locator("mo-copp-playground");
    await element.waitFor({ state: "attached" });
    const given = () =>
      element.evaluate((node) =>
        Object.fromEntries(
          ["keys", "k", "j", "wasm-url", "seed", "exercise", "disabled"].map((name) => [name, node.getAttribute(name)]),
        ),
      );
    const none = { seed: null, exercise: null, disabled: null };
    assert.deepEqual(await given(), { keys: "off", k: null, j: "0", "wasm-url": "core.wasm", ...none });
    await page.evaluate(`for (const [name, value] of [["keys_", "focus"], ["k", 2], ["j", null], ["disabled", true], ["seed", 0]])
      window.python(name, value);`);
    assert.deepEqual(await given(), {
      ...{ keys: "focus", k: "2", j: null, "wasm-url": "core.wasm", seed: "0", exercise: null, disabled: "" },
    });
  }, kit));
