// The playground in other pages: as an element with attributes and events, several in one page, and in a frame.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { attributes } from "../../www/src/element/attributes.js";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";
import { address } from "./support/site.js";

/** A course page with a style of its own, on the same host. */
async function course(page: Page, body: string): Promise<void> {
  await page.route(`${address}lesson/*.html`, (route) =>
    route.fulfill({
      contentType: "text/html",
      body: `<!doctype html><html lang="en"><head><title>Lesson</title>
        <style>body { background: rgb(1, 2, 3); color: rgb(250, 250, 250); font-family: serif }</style>
        <script type="module" src="../mo-copp-playground.js"></script></head><body>
        <h1 class="intro">Lesson</h1><button id="own">Own</button><p class="card error">Own</p>${body}</body></html>`,
    }),
  );
  await page.route(`${address}lesson/problem.json`, (route) =>
    route.fulfill({ contentType: "application/json", body: grid() }),
  );
  await page.goto(`${address}lesson/page.html`);
}

/** Waits until the agent's board of a playground has so many cells. */
const cells = (page: Page, selector: string, count: number) =>
  page.waitForFunction(
    ([selector, count]) =>
      document.querySelector(selector)?.shadowRoot?.querySelectorAll('[data-board="actor"] [data-cell]').length ===
      count,
    [selector, count] as const,
  );

const ready = (page: Page, selector: string, data = "") =>
  page.waitForSelector(`mo-copp-playground${selector}:is([data-status=optimal], [data-status=solved])${data}`);

test("the element does what its attributes ask", () =>
  visit(async ({ page }) => {
    await course(
      page,
      `<mo-copp-playground id="src" src="problem.json" step="1" link="off"></mo-copp-playground>
       <mo-copp-playground id="plan" problem="delivery" plan="One from each" link="off"></mo-copp-playground>
       <mo-copp-playground id="actions" src="problem.json" plan="north, north" step="2" link="off"></mo-copp-playground>
       <mo-copp-playground id="solver" problem="blind-enemy" solver="search" k="2" j="3" horizon="7" link="off"></mo-copp-playground>`,
    );
    await ready(page, "#src", '[data-step="1"]');
    assert.equal(await page.locator('#src [data-board="actor"] [data-cell]').count(), 12);
    await ready(page, "#plan", '[data-gd="0.4"]');
    await page.waitForSelector('#actions[data-step="2"]');
    assert.equal(await page.locator("#actions .panel.actor .symbols li").count(), 2);
    await page.waitForSelector("#solver[data-status=solved]");
    assert.equal(await page.locator("#solver").getByLabel("Solver").inputValue(), "search");
    assert.equal(await page.locator("#solver").getByLabel("Enemy keeps at least").inputValue(), "2");
    assert.equal(await page.locator("#solver").getByRole("slider").getAttribute("max"), "7");
  }));

test("attributes that change are followed, and what can't be used is said", () =>
  visit(
    async ({ page }) => {
      await course(page, `<mo-copp-playground id="one" problem="corridor" link="off"></mo-copp-playground>`);
      await ready(page, "#one", '[data-step="5"]');
      await page.evaluate(() => document.querySelector("#one")?.setAttribute("problem", "head-fake"));
      await ready(page, "#one", '[data-step="16"]');
      await page.evaluate(() => document.querySelector("#one")?.setAttribute("step", "4"));
      await ready(page, "#one", '[data-step="4"]');
      await page.evaluate(() => document.querySelector("#one")?.setAttribute("problem", "nothing like it"));
      await page.getByText("no problem called “nothing like it”").waitFor();
      assert.equal(await page.locator('#one [data-board="actor"] [data-cell]').count(), 54);
      await page.evaluate(() => document.querySelector("#one")?.setAttribute("src", "missing.json"));
      await page.getByText("“missing.json” could not be loaded").waitFor();
      await page.evaluate(() => document.querySelector("#one")?.setAttribute("hide", "workbench, legend stepper"));
      await page.locator("#one .workbench").waitFor({ state: "detached" });
      assert.equal(await page.locator("#one .stepper").count(), 0);
      assert.equal(await page.locator("#one .stage").count(), 1);
    },
    // The missing file is an error on the console, too.
    { quiet: false },
  ));

test("settings that can't be used are said, and the problem is shown", () =>
  visit(async ({ page }) => {
    await course(
      page,
      `<mo-copp-playground id="one" problem="corridor" solver="magic" step="abc" hide="tols legend" link="of" loading="lazzy" k="99" j="2"
        watch="yes" student="   " root="x"></mo-copp-playground>`,
    );
    const alert = page.locator("#one").getByRole("alert").first();
    await alert.getByText("“magic” can’t be used for the attribute solver; expected exact, ip,").waitFor();
    await alert.getByText("“abc” can’t be used for the attribute step; expected a whole number").waitFor();
    await alert.getByText("“tols” can’t be used for the attribute hide; expected parts").waitFor();
    await alert.getByText("“of” can’t be used for the attribute link; expected on, off.").waitFor();
    await alert.getByText("“lazzy” can’t be used for the attribute loading; expected lazy, eager.").waitFor();
    await alert.getByText("“yes” can’t be used for the attribute watch; expected no value").waitFor();
    await alert.getByText("“   ” can’t be used for the attribute student; expected a name").waitFor();
    await alert.getByText("“x” can’t be used for the attribute root; expected page").waitFor();
    await alert.getByText("“99” can’t be used for the attribute k; expected a whole number from 1 to 4.").waitFor();
    assert.equal(await page.locator("#one .title", { hasText: "One step too far" }).count(), 1);
    // An attribute that is there says yes, whatever its value.
    assert.equal(await page.locator("#one").getAttribute("data-step"), "0");
    assert.equal(await page.locator("#one .legend").count(), 0);
    await page.locator("#one").getByRole("button", { name: "Close the message" }).click();
    await ready(page, "#one");
    // Once is enough.
    await page.evaluate(() => document.querySelector("#one")?.setAttribute("step", "2"));
    await ready(page, "#one", '[data-step="2"]');
    assert.equal(await alert.textContent().then((text) => text?.trim()), "");
    for (const [src, protocol] of [
      ["javascript:alert(1)", "javascript:"],
      ["mailto:someone@example.org", "mailto:"],
    ]) {
      await page.evaluate((src) => document.querySelector("#one")?.setAttribute("src", src ?? ""), src);
      await alert
        .getByText(`“${src}” could not be loaded: “${protocol}” is no place of documents; expected an`)
        .waitFor();
      assert.equal(await page.locator("#one").getAttribute("data-step"), "2", "what was shown stays");
    }
    // In a frame's address as well, where the page has parts of its own.
    await page.goto(`${address}?problem=corridor&step=-1&k=many&hide=intro,footer`);
    const own = page.getByRole("alert").first();
    await own.getByText("“-1” can’t be used for the attribute step").waitFor();
    const text = (await own.textContent()) ?? "";
    assert(text.includes("k must be a whole number"), text);
    assert(!text.includes("hide"), text);
  }));

test("a message about an attribute goes once the attribute is right, and no other message does", () =>
  visit(
    async ({ page }) => {
      await course(page, `<mo-copp-playground id="one" problem="corridor" link="off"></mo-copp-playground>`);
      await ready(page, "#one");
      const one = page.locator("#one");
      const set = (name: string, value: string) =>
        one.evaluate((element, [name, value]) => element.setAttribute(name, value), [name, value] as const);
      const alert = one.getByRole("alert").first();
      const wrong = { theme: "pink", step: "abc", keys: "some", hide: "tols" };
      const right = { theme: "dark", step: "2", keys: "focus", hide: "" };
      for (const [name, value] of Object.entries(wrong)) await set(name, value);
      for (const value of Object.values(wrong)) await alert.getByText(`“${value}” can’t be used`).waitFor();
      for (const [name, value] of Object.entries(right)) {
        assert.equal(await one.getAttribute("data-status"), "error");
        await set(name, value);
        await alert.getByText(`can’t be used for the attribute ${name}`).waitFor({ state: "detached" });
      }
      await ready(page, "#one", '[data-step="2"]');
      // Without the attribute there is nothing wrong either.
      await set("theme", "pink");
      await alert.getByText("“pink” can’t be used").waitFor();
      await one.evaluate((element) => element.removeAttribute("theme"));
      await ready(page, "#one");
      await set("src", "missing.json");
      await alert.getByText("“missing.json” could not be loaded").waitFor();
      await set("theme", "pink");
      await alert.getByText("“pink” can’t be used").waitFor();
      await set("theme", "light");
      await alert.getByText("“pink” can’t be used").waitFor({ state: "detached" });
      await alert.getByText("“missing.json” could not be loaded").waitFor();
      assert.equal(await one.getAttribute("data-status"), "error");
    },
    // The missing file is an error on the console, too.
    { quiet: false },
  ));

test("attributes that change together are followed together, and the last ones win", () =>
  visit(async ({ page }) => {
    await course(
      page,
      `<mo-copp-playground id="one" src="problem.json" link="off"></mo-copp-playground>
       <mo-copp-playground id="two" src="problem.json" horizon="5" link="off"></mo-copp-playground>`,
    );
    await ready(page, "#one");
    await page.waitForSelector("#two[data-status=optimal], #two[data-status=infeasible]");
    const set = (selector: string, attributes: Record<string, string | null>) =>
      page.evaluate(
        ([selector, attributes]) => {
          const element = document.querySelector(selector);
          for (const [name, value] of Object.entries(attributes)) {
            if (value === null) element?.removeAttribute(name);
            else element?.setAttribute(name, value);
          }
        },
        [selector, attributes] as const,
      );
    await set("#one", { plan: "north,north,east", step: "1" });
    await page.locator("#one").getByText("The plan of this page").first().waitFor();
    await page.waitForSelector('#one[data-step="1"]');
    await set("#two", { problem: "eight-by-eight", src: null, horizon: null });
    await cells(page, "#two", 64);
    // One that is still on its way is overtaken by what is asked for after it.
    let answer = () => {};
    const held = new Promise<void>((resolve) => {
      answer = resolve;
    });
    await page.route(`${address}lesson/late.json`, async (route) => {
      await held;
      await route.fulfill({ contentType: "application/json", body: grid({ width: 6 }) });
    });
    const late = page.waitForRequest("**/late.json");
    await set("#one", { src: "late.json" });
    await late;
    await set("#one", { src: null, plan: null, step: null, problem: "corridor" });
    await ready(page, "#one", '[data-step="5"]');
    const finished = page.waitForResponse("**/late.json").then((response) => response.finished());
    answer();
    await finished;
    await set("#one", { step: "2" });
    await ready(page, "#one", '[data-step="2"]');
    assert.equal(await page.locator("#one .title", { hasText: "One step too far" }).count(), 1);
  }));

test("every part can be left out", () =>
  visit(async ({ page }) => {
    const parts: [part: string, selector: string][] = [
      ["gallery", ".problem-bar"],
      ["tools", ".toolbar"],
      ["stepper", ".stepper"],
      ["legend", ".legend"],
      ["workbench", ".workbench"],
      ["goals", "table.goals"],
    ];
    const all = parts.map(([part]) => part).join(" ");
    await course(
      page,
      `<mo-copp-playground id="none" problem="corridor" hide="${all}" link="off"></mo-copp-playground>
       <mo-copp-playground id="all" problem="corridor" link="off"></mo-copp-playground>`,
    );
    await ready(page, "#none");
    await ready(page, "#all");
    for (const [part, selector] of parts) {
      assert.equal(await page.locator(`#none ${selector}`).count(), 0, part);
      assert.equal(await page.locator(`#all ${selector}`).count(), 1, part);
    }
    assert.equal(await page.locator("#none [data-board]").count(), 3);
  }));

test("several stand in one page: no id twice, one address, keys and undo for the one in hand", () =>
  visit(async ({ page }) => {
    await course(
      page,
      `<mo-copp-playground id="a" problem="corridor"></mo-copp-playground>
       <mo-copp-playground id="b" problem="head-fake"></mo-copp-playground>
       <mo-copp-playground id="c" problem="delivery" link="off"></mo-copp-playground>`,
    );
    for (const one of ["#a", "#b", "#c"]) await ready(page, one);
    for (const tab of ["Solve", "Edit", "Play", "Compare", "Trade-off", "Steps", "Document"]) {
      for (const one of ["#a", "#b", "#c"])
        await page.locator(one).getByRole("tab", { name: tab, exact: true }).click();
      const { twice, dangling } = await page.evaluate(() => {
        const ids = [...document.querySelectorAll("[id]")].map(({ id }) => id);
        const wanted = ["for", "aria-controls", "aria-labelledby", "aria-describedby", "list"].flatMap((name) =>
          [...document.querySelectorAll(`[${name}]`)].flatMap((part) => part.getAttribute(name)?.split(" ") ?? []),
        );
        return {
          twice: ids.filter((id, index) => ids.indexOf(id) !== index),
          dangling: wanted.filter((id) => !ids.includes(id)),
        };
      });
      assert.deepEqual([twice, dangling], [[], []], tab);
    }
    // The address is the first one's.
    await page.waitForFunction(() => location.hash.startsWith("#1."));
    assert.equal(await page.getByRole("button", { name: "Copy link" }).count(), 1);
    assert.equal(await page.locator("#a").getByRole("button", { name: "Copy link" }).count(), 1);
    // Keys: the one with the focus, or the first.
    await page.locator("#b .belief").first().click();
    await page.locator("#b").getByRole("tab", { name: "Document" }).focus();
    await page.locator("#b").getByRole("button", { name: "Help" }).focus();
    await page.keyboard.press("ArrowLeft");
    await page.waitForSelector('#b[data-step="15"]');
    assert.equal(await page.locator("#a").getAttribute("data-step"), "5");
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
    await page.keyboard.press("Home");
    await page.waitForSelector('#a[data-step="0"]');
    assert.equal(await page.locator("#b").getAttribute("data-step"), "15");
    // Undo as well.
    for (const one of ["#a", "#c"]) await page.locator(one).getByRole("button", { name: "Next problem" }).click();
    await page.locator("#a .title", { hasText: "Three rooms" }).first().waitFor();
    await page.locator("#c .title", { hasText: "A blind enemy" }).first().waitFor();
    await page.keyboard.press("Control+z");
    await page.locator("#c .title", { hasText: "The paper’s delivery" }).first().waitFor();
    await page.locator("#a .title", { hasText: "Three rooms" }).first().waitFor();
  }));

test("what is dropped on one playground is not for the one that has the page", () =>
  visit(async ({ page }) => {
    await course(
      page,
      `<mo-copp-playground id="a" problem="corridor"></mo-copp-playground>
       <mo-copp-playground id="b" problem="head-fake" link="off"></mo-copp-playground>`,
    );
    for (const one of ["#a", "#b"]) await ready(page, one);
    const data = await page.evaluateHandle((text) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([text], "problem.json", { type: "application/json" }));
      return transfer;
    }, grid());
    const drag = (on: string, type: string) => page.dispatchEvent(on, type, { dataTransfer: data });
    // Over the page it is the first one's, until it comes over the other.
    await drag("h1", "dragover");
    await page.locator("#a .drop").waitFor();
    await drag("#b .stage", "dragenter");
    await drag("#b .stage", "dragover");
    await page.locator("#b .drop").waitFor();
    assert.equal(await page.locator("#a .drop").count(), 0);
    await drag("#b .stage", "drop");
    await cells(page, "#b", 12);
    assert.equal(await page.locator("#a .title", { hasText: "One step too far" }).count(), 1);
    assert.equal(await page.locator("#a").getAttribute("data-status"), "optimal");
    // And what is dropped elsewhere is the first one's.
    await drag("h1", "drop");
    await cells(page, "#a", 12);
  }));

test("it tells the page of steps and answers", () =>
  visit(async ({ page }) => {
    await page.addInitScript(`
      window.told = [];
      for (const name of ["mo-copp-step", "mo-copp-outcome"]) {
        addEventListener(name, (event) => window.told.push([name, event.target.id, event.detail]));
      }
    `);
    await course(page, `<mo-copp-playground id="one" problem="corridor" link="off"></mo-copp-playground>`);
    await ready(page, "#one");
    const told = () =>
      page.evaluate(() => (window as unknown as { told: [string, string, Record<string, unknown>][] }).told);
    const first = await told();
    // Where the solver takes its time the start is shown before the plan. No step is told twice.
    const steps = first.slice(0, -1);
    assert(steps.length === 1 || steps.length === 2, JSON.stringify(first));
    assert.deepEqual(new Set(steps.map(([name, id]) => `${name} ${id}`)), new Set(["mo-copp-step one"]));
    assert.equal(new Set(steps.map(([, , { step }]) => step)).size, steps.length);
    const [last, id, outcome] = first.at(-1) ?? assert.fail();
    assert.deepEqual([last, id, outcome.status], ["mo-copp-outcome", "one", "optimal"]);
    assert.equal(outcome.goal_difference, 1);
    assert.deepEqual(steps.map(([, , { step, ended }]) => [step, ended]).at(-1), [5, true]);
    await page.getByRole("button", { name: "Back one step" }).click();
    await page.waitForSelector('#one[data-step="4"]');
    const [name, , detail] = (await told()).at(-1) ?? assert.fail();
    assert.equal(name, "mo-copp-step");
    assert.deepEqual([detail.step, detail.steps, detail.action], [4, 5, "east"]);
    assert.equal(detail.ended, false, "a step of the plan before its end");
    assert.equal((await told()).length, first.length + 1);
  }));

test("its styles reach nothing of the page around it", () =>
  visit(
    async ({ page }) => {
      const styles = () =>
        page.evaluate(() =>
          ["body", "h1", "#own", ".card"].map((selector) => {
            const style = getComputedStyle(document.querySelector(selector) ?? document.body);
            return [
              style.backgroundColor,
              style.color,
              style.font,
              style.padding,
              style.border,
              style.position,
              style.boxSizing,
            ];
          }),
        );
      await page.route("**/mo-copp-playground.js", (route) => route.abort());
      await course(page, "<p></p>");
      const before = await styles();
      await page.unroute("**/mo-copp-playground.js");
      await course(page, `<mo-copp-playground id="one" problem="corridor" link="off"></mo-copp-playground>`);
      await ready(page, "#one");
      assert.deepEqual(await styles(), before);
      // And it has a ground of its own, so that it can be read.
      const ground = await page.locator("#one").evaluate((element) => getComputedStyle(element).backgroundColor);
      assert.notEqual(ground, "rgba(0, 0, 0, 0)");
    },
    { quiet: false },
  ));

test("the element can be taken out of the page and put back", () =>
  visit(async ({ page }) => {
    await course(page, `<div id="box"><mo-copp-playground id="one" problem="corridor"></mo-copp-playground></div>`);
    await ready(page, "#one");
    await page.evaluate(() => {
      const element = document.querySelector("#one");
      element?.remove();
      document.body.append(element ?? "");
    });
    await page.keyboard.press("Home");
    await page.waitForSelector('#one[data-step="0"]');
    await page.getByRole("button", { name: "Next problem" }).click();
    await ready(page, "#one", '[data-step="6"]');
  }));

test("in a frame, its address says what it shows", () =>
  visit(async ({ page }) => {
    await page.goto(`${address}embed.html`);
    await ready(page, "#parity", '[data-gd="0.5"]');
    await ready(page, "#waiting", '[data-step="2"]');
    await page.getByRole("heading", { name: "As elements, one below the other" }).waitFor();
    const [upper, lower] = await Promise.all(
      ["#parity", "#waiting"].map((selector) => page.locator(selector).boundingBox()),
    );
    assert(upper && lower && upper.x === lower.x && upper.y + upper.height <= lower.y);
    const frame = page.frameLocator("iframe");
    await frame.locator('mo-copp-playground[data-gd="1"]').waitFor();
    await frame.getByText("The paper’s delivery").first().waitFor();
    for (const hidden of ["header", "footer", ".workbench", ".toolbar"]) {
      assert.equal(await frame.locator(hidden).isVisible(), false, hidden);
    }
    await frame.getByRole("button", { name: "One from each" }).click();
    await frame.locator('mo-copp-playground[data-gd="0.4"]').waitFor();
    // Nothing of it came to the page around it.
    assert.equal(await page.evaluate(() => location.hash), "");
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert(overflow <= 0);
  }));

test("the footer says what this is and leads to the paper, the documents and the licences", () =>
  visit(async ({ page }) => {
    const footer = page.getByRole("contentinfo");
    await footer.getByText("Kulkarni").waitFor();
    for (const name of ["Problem documents and the command", "MIT", "Apache-2.0", "In your own page"]) {
      const link = await footer.getByRole("link", { name, exact: true }).getAttribute("href");
      const response = await page.request.get(new URL(link ?? "", address).href);
      assert.equal(response.status(), 200, name);
    }
  }));

test("the documentation names every attribute, part, event and gallery problem's folder", () => {
  const text = readFileSync(new URL("../../docs/embedding.md", import.meta.url), "utf8");
  const settings = readFileSync(new URL("../../www/src/element/settings.ts", import.meta.url), "utf8");
  const parts = /export const parts = \[([^\]]+)\]/.exec(settings)?.[1]?.match(/\w+/g) ?? [];
  assert(parts.length > 0, "no parts were found");
  for (const name of [...attributes, ...parts]) assert(text.includes(`\`${name}\``), name);
  for (const name of ["mo-copp-step", "mo-copp-outcome", "www/problems/", "link"]) assert(text.includes(name), name);
});
