// The kit for Jupyter and marimo: the widget's class in Python, and its side in the browser.
import assert from "node:assert/strict";
import { cpSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { dist } from "../../scripts/lib/paths.mjs";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import { visit } from "../page/support/browser.js";
import { grid } from "../page/support/documents.js";
import { copyOf, kit, python, ready, served } from "./support/site.js";

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
