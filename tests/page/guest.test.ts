// The element as a guest: in pages of other people, which have styles, keys, themes and plans of their own.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { attributes, flags } from "../../www/src/element/attributes.js";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import { visit } from "./support/browser.js";
import { endless, grid } from "./support/documents.js";
import { address } from "./support/site.js";

async function lesson(page: Page, body: string, { html = "", head = "" } = {}): Promise<void> {
  await page.route(`${address}lesson/guest.html`, (route) =>
    route.fulfill({
      contentType: "text/html",
      body: `<!doctype html><html lang="en" ${html}><head><title>Lesson</title>${head}
        <script type="module" src="../mo-copp-playground.js"></script></head><body>${body}</body></html>`,
    }),
  );
  await page.goto(`${address}lesson/guest.html`);
}

const one = `<mo-copp-playground id="one" problem="corridor" link="off"></mo-copp-playground>`;
const ready = (page: Page, more = "") =>
  page.waitForSelector(`#one:is([data-status=optimal], [data-status=solved])${more}`);
const scheme = (page: Page) => page.locator("#one").getAttribute("data-scheme");

test("the theme is the page's: by its color-scheme, its tool's switch, or the attribute", () =>
  visit(
    async ({ page }) => {
      await page.route("**/dark.css", (route) =>
        route.fulfill({ contentType: "text/css", body: ":root { color-scheme: dark }" }),
      );
      await lesson(
        page,
        `<style>:root:has(#dark:checked, #button[aria-pressed=true]), [data-color-mode=dark] { color-scheme: dark }</style>
          <style id="off">:root { color-scheme: dark }</style><style id="words">body { color: #ddd; background: #222 }</style><style id="written"></style>
          <script>for (const name of ["off", "words"]) document.getElementById(name).sheet.disabled = true;</script>
          <input type="checkbox" id="dark">
          <button id="button" aria-pressed="false" onclick="this.ariaPressed = this.ariaPressed !== 'true'">Dark</button>${one}`,
      );
      await ready(page);
      // A page that says nothing is light, whatever the system.
      assert.equal(await scheme(page), "light");
      const set = (code: string) => page.evaluate(code);
      const becomes = (wanted: string) => page.waitForSelector(`#one[data-scheme=${wanted}]`);
      const root = "document.documentElement";
      const body = "document.body";
      const switches: [on: string, off: string][] = [
        [`${body}.style.background = "#191919"`, `${body}.style.background = "#fff"`],
        [`${body}.style.background = "oklch(0.25 0.02 250)"`, `${body}.style.background = "oklab(0.9 0 0)"`],
        [`${body}.style.background = "color(srgb 0.1 0.1 0.1)"`, `${body}.style.background = "lab(80 0 0)"`],
        // A ground may be a gradient, and what a picture shows is told by the text on it.
        [`${body}.style.background = "linear-gradient(45deg, #111, #334 60%, #fff)"`, `${body}.style.background = ""`],
        [
          `${body}.style.background = "linear-gradient(#0001, #0001), radial-gradient(oklch(0.2 0 0), #222) #fff"`,
          `${body}.style.background = "linear-gradient(#eee, #fff) #111"`,
        ],
        [
          `${body}.style.background = "url(data:image/png,) "; ${body}.style.color = "#eee"`,
          `${body}.style.color = "#222"`,
        ],
        // Style sheets that a script switches, adopts or writes into, which no event tells of.
        [
          `${body}.removeAttribute("style"); document.querySelector("#off").sheet.disabled = false`,
          `document.querySelector("#off").sheet.disabled = true`,
        ],
        [
          `document.querySelector("#words").sheet.disabled = false`,
          `document.querySelector("#words").sheet.disabled = true`,
        ],
        [
          `document.adoptedStyleSheets = [new CSSStyleSheet()]; document.adoptedStyleSheets[0].replaceSync(":root { color-scheme: dark }")`,
          `document.adoptedStyleSheets = []`,
        ],
        [
          `document.querySelector("#written").sheet.insertRule("html { color-scheme: dark }")`,
          `document.querySelector("#written").sheet.deleteRule(0)`,
        ],
        // Switches that no attribute tells of: a ground that fades, and a field that styles ask for.
        [
          `${body}.style.transition = "background-color 50ms"; ${body}.style.background = "#111"`,
          `${body}.style.background = "#fff"`,
        ],
        [
          `${body}.style.transition = ""; document.querySelector("#dark").click()`,
          `document.querySelector("#dark").click()`,
        ],
        [`${root}.style.colorScheme = "dark"`, `${root}.style.colorScheme = ""`],
        // Any attribute may be one that styles ask for, and a sheet may stand anywhere or come late.
        [`${root}.dataset.colorMode = "dark"`, `${root}.dataset.colorMode = "light"`],
        [
          `${body}.append(Object.assign(document.createElement("style"), { id: "late", textContent: ":root { color-scheme: dark }" }))`,
          `document.querySelector("#late").remove()`,
        ],
        [
          `document.head.append(Object.assign(document.createElement("link"), { id: "sheet", rel: "stylesheet", href: "dark.css" }))`,
          `document.querySelector("#sheet").remove()`,
        ],
        [
          `document.head.append(Object.assign(document.createElement("meta"), { id: "meta", name: "color-scheme", content: "dark" }))`,
          `document.querySelector("#meta").content = "light"`,
        ],
        [`document.querySelector("#button").click()`, `document.querySelector("#button").click()`],
        [`${root}.style.colorScheme = "light dark"`, `${root}.style.colorScheme = "light"`],
        [`${root}.dataset.bsTheme = "dark"`, `delete ${root}.dataset.bsTheme`],
        [`${root}.dataset.theme = "dark"`, `${root}.dataset.theme = "light"`],
        [
          `delete ${root}.dataset.theme; ${body}.dataset.mdColorScheme = "slate"`,
          `${body}.dataset.mdColorScheme = "default"`,
        ],
        [
          `delete ${body}.dataset.mdColorScheme; ${body}.className = "fullcontent quarto-dark"`,
          `${body}.className = "fullcontent quarto-light"`,
        ],
        [
          `document.querySelector("#one").setAttribute("theme", "dark")`,
          `document.querySelector("#one").setAttribute("theme", "light")`,
        ],
      ];
      for (const [on, off] of switches) {
        await set(on);
        await becomes("dark");
        await set(off);
        await becomes("light");
      }
      const ground = () =>
        page
          .locator("#one .panel")
          .first()
          .evaluate((panel) => getComputedStyle(panel).backgroundColor);
      const light = await ground();
      await set(`document.querySelector("#one").setAttribute("theme", "dark")`);
      assert.notEqual(await ground(), light);
      await set(`document.querySelector("#one").setAttribute("theme", "pink")`);
      await page.getByText("“pink” can’t be used for the attribute theme; expected light, dark, auto").waitFor();
    },
    { colorScheme: "dark" },
  ));

test("keys that the playground handles never reach the page, and the others do", () =>
  visit(async ({ page }) => {
    await page.addInitScript(`
      window.heard = [];
      window.early = [];
      for (const type of ["keydown", "keyup", "keypress"]) {
        document.addEventListener(type, (event) => window.heard.push(event.type + " " + event.key));
        // As the guide has it.
        document.addEventListener(type, (event) => {
          if (!event.target.closest("mo-copp-playground")) window.early.push(event.type + " " + event.key);
        }, true);
      }`);
    const heard = () => page.evaluate("window.heard.splice(0)") as Promise<string[]>;
    await lesson(page, `<button id="own">Own</button>${one}`);
    await ready(page, '[data-step="5"]');
    // Nothing has the focus: with link="off" the keys are the page's.
    await page.keyboard.press("ArrowLeft");
    assert.deepEqual(await heard(), ["keydown ArrowLeft", "keyup ArrowLeft"]);
    assert.equal(await page.locator("#one").getAttribute("data-step"), "5");
    await page.locator("#one").getByRole("button", { name: "Help" }).focus();
    await page.keyboard.press("ArrowLeft");
    await ready(page, '[data-step="4"]');
    await page.keyboard.press("PageDown");
    assert.deepEqual(await heard(), ["keydown PageDown", "keyup PageDown"]);
    // What is typed is not the page's either.
    await page.locator("#one").getByLabel("Enemy keeps at least").focus();
    await page.keyboard.press("2");
    assert.deepEqual(await heard(), []);
    await page.evaluate(() => document.querySelector("#one")?.setAttribute("keys", "off"));
    await page.locator("#one").getByRole("button", { name: "Help" }).focus();
    await page.keyboard.press("ArrowLeft");
    assert.deepEqual(await heard(), ["keydown ArrowLeft", "keyup ArrowLeft"]);
    await page.evaluate(() => {
      document.querySelector("#one")?.setAttribute("keys", "page");
      (document.activeElement as HTMLElement).blur();
    });
    await page.keyboard.press("Home");
    await ready(page, '[data-step="0"]');
    assert.deepEqual(await heard(), []);
    await page.locator("#own").focus();
    await page.keyboard.press("End");
    assert.deepEqual(await heard(), ["keydown End", "keyup End"]);
    const early = (await page.evaluate("window.early")) as string[];
    assert.deepEqual(early, ["keydown ArrowLeft", "keyup ArrowLeft", "keydown End", "keyup End"]);
  }));

test("keys in its dialogs and on its boards are the playground's alone, pressed and released", () =>
  visit(async ({ page }) => {
    await lesson(
      page,
      `<mo-copp-playground id="one" link="off"></mo-copp-playground>
      <script>
        window.heard = [];
        for (const type of ["keydown", "keyup", "keypress"])
          document.addEventListener(type, (event) => window.heard.push(event.type + " " + event.key));
      </script>`,
    );
    await ready(page);
    const step = await page.locator("#one").getAttribute("data-step");
    const heard = () => page.evaluate("window.heard.splice(0)") as Promise<string[]>;
    const button = (name: string) => page.locator("#one").getByRole("button", { name, exact: true });
    const openers: [opener: string, key: string, dialog: string][] = [
      ["Help", "?", "dialog.help"],
      ["Save picture", "Enter", "dialog.picture-sheet"],
    ];
    for (const [opener, key, dialog] of openers) {
      await button(opener).focus();
      await page.keyboard.press(key);
      await page.locator(dialog).waitFor();
      for (const pressed of ["ArrowLeft", "ArrowRight", "n", "Control+z"]) await page.keyboard.press(pressed);
      // Where the focus is on nothing, too.
      await page.locator(`${dialog} :focus`).evaluate((focused) => (focused as HTMLElement).blur());
      for (const pressed of ["ArrowLeft", "n"]) await page.keyboard.press(pressed);
      await page.keyboard.press("Escape");
      await page.locator(`${dialog}[open]`).waitFor({ state: "detached" });
      assert.deepEqual(await heard(), [], dialog);
    }
    await page
      .locator("#one")
      .getByRole("application", { name: /^The agent on a grid/ })
      .focus();
    for (const pressed of ["ArrowRight", "ArrowLeft", " ", " "]) await page.keyboard.press(pressed);
    assert.deepEqual(await heard(), []);
    assert.equal(await page.locator("#one").getAttribute("data-step"), step);
    // What nothing here is for is the page's, down and up.
    await page.keyboard.press("PageDown");
    assert.deepEqual(await heard(), ["keydown PageDown", "keyup PageDown"]);
  }));

test("twenty lazy playgrounds fetch nothing but the script until they near the view", () =>
  visit(async ({ page, requests }) => {
    await page.goto("about:blank");
    await page.waitForTimeout(500);
    requests.length = 0;
    const many = `<mo-copp-playground problem="corridor" loading="lazy" link="off"></mo-copp-playground>`.repeat(20);
    await lesson(page, `<p style="height: 4000px">Far above.</p>${many}`);
    await page.waitForFunction(() => customElements.get("mo-copp-playground") !== undefined);
    await page.waitForLoadState("networkidle");
    const own = () => requests.filter((request) => request.startsWith(address) && !/guest\.html|favicon/.test(request));
    assert.deepEqual(own(), [`${address}mo-copp-playground.js`]);
    assert.equal(page.workers().length, 0);
    await page.locator("mo-copp-playground").nth(1).scrollIntoViewIfNeeded();
    await page.locator("mo-copp-playground[data-status=optimal]").first().waitFor();
    const shown = await page.locator("mo-copp-playground:not([data-status=idle])").count();
    assert(shown < 10, `${shown} of 20 were begun`);
  }));

test("the element's children stand for it until it runs, and where it can't", () =>
  visit(
    async ({ page }) => {
      const poster = `<mo-copp-playground id="one" problem="corridor" link="off"><p id="poster">A picture</p></mo-copp-playground>`;
      await page.route("**/shadow-view-*.js", (route) => route.abort());
      await lesson(page, poster);
      const again = page.locator("#one").getByRole("button", { name: "Try again" });
      await again.waitFor();
      assert(await page.locator("#poster").isVisible());
      assert.equal(await page.locator("#one").getAttribute("data-status"), "error");
      // It is as ready as it gets, and its methods say why they can't.
      const refused = await page.locator("#one").evaluate(async (element) => {
        await (element as MoCoppPlayground).ready;
        return (element as MoCoppPlayground).goTo(1).catch((error: Error) => error.message);
      });
      assert.equal(refused, "The playground could not be loaded.");
      // What fails twice may be kept by the browser: then the page itself is loaded again.
      const anew = page.locator("#one").getByRole("button", { name: "Load the page again" });
      assert.equal(await anew.count(), 0);
      await again.click();
      await anew.waitFor();
      await page.unroute("**/shadow-view-*.js");
      await again.click();
      await ready(page);
      await page.route("**/shadow-view-*.js", (route) => route.abort());
      await lesson(page, poster);
      await again.click();
      await anew.waitFor();
      await page.unroute("**/shadow-view-*.js");
      await anew.click();
      await ready(page);
      assert(!(await page.locator("#poster").isVisible()));
    },
    { quiet: false },
  ));

test("loaded twice, inside of another shadow root, and with its dialogs above the page", () =>
  visit(async ({ page }) => {
    await lesson(
      page,
      `<div id="host"></div><div style="position: fixed; inset: 0 0 auto; height: 3rem; z-index: 9999"></div>`,
      {
        head: `<script type="module" src="../mo-copp-playground.js?version=2"></script><script src="../mo-copp-playground.single.js"></script>`,
      },
    );
    await page.evaluate((inner) => {
      const shadow = document.querySelector("#host")?.attachShadow({ mode: "open" });
      if (shadow) shadow.innerHTML = inner;
    }, one);
    await page.locator("#one[data-status=optimal]").waitFor();
    const top = (selector: string) =>
      page.locator(selector).evaluate((dialog) => {
        const { left, top, width } = dialog.getBoundingClientRect();
        let at = document.elementFromPoint(left + width / 2, top + 4);
        while (at?.shadowRoot) at = at.shadowRoot.elementFromPoint(left + width / 2, top + 4);
        return at !== null && dialog.contains(at);
      });
    await page.locator("#one .problem-bar .current").press("Enter");
    await page.locator("dialog.gallery").waitFor();
    assert(await top("dialog.gallery"));
    await page.keyboard.press("Escape");
    await page.locator("#one").getByRole("button", { name: "Help" }).press("Enter");
    await page.locator("dialog.help").waitFor();
    assert(await top("dialog.help"));
    assert.equal(
      await page.locator("dialog.help").evaluate((dialog) => getComputedStyle(dialog).boxSizing),
      "border-box",
    );
  }));

test("a document in the element, properties and promises", () =>
  visit(async ({ page }) => {
    await lesson(
      page,
      `<mo-copp-playground id="one" link="off"><script type="application/json">${grid()}</script></mo-copp-playground>`,
    );
    await ready(page);
    const told = await page.locator("#one").evaluate(async (element) => {
      const playground = element as MoCoppPlayground;
      await playground.ready;
      const width = (playground.document as { width?: number }).width;
      await playground.goTo(1);
      const outcome = await playground.solve({ solver: "search", k: 1, j: 2 });
      const { state } = playground;
      const refused = await playground.solve({ k: 99 }).then(
        () => "",
        (error: Error) => error.message,
      );
      return { width, status: outcome.status, plan: state?.plan?.length, form: state?.form, state, refused };
    });
    assert.equal(told.width, JSON.parse(grid()).width);
    assert.equal(told.status, "solved");
    assert.deepEqual(told.form, { solver: "search", k: "1", j: "2" });
    assert.notEqual(told.refused, "");
    // What is kept and set again is as it was.
    await lesson(page, `<mo-copp-playground id="one" link="off"></mo-copp-playground>`);
    await page.locator("#one").evaluate((element, state) => {
      (element as MoCoppPlayground).state = state as MoCoppPlayground["state"];
    }, told.state);
    await page.waitForSelector("#one[data-status=solved]");
    assert.equal(await page.locator("#one").getByLabel("Solver").inputValue(), "search");
    await page.locator("#one").evaluate(
      (element, document) => {
        (element as MoCoppPlayground).document = document;
      },
      JSON.parse(grid({ width: 6 })),
    );
    await page.locator('#one [data-board=actor] [data-cell="5,0"]').waitFor({ state: "attached" });
  }));

test("methods wait for what was asked for before them", () =>
  visit(async ({ page }) => {
    await page.route("**/never.json", () => undefined);
    await lesson(page, one);
    await ready(page);
    const told = await page.locator("#one").evaluate(
      async (element, wide) => {
        const playground = element as MoCoppPlayground;
        const pictures = { corridor: await playground.toSVG() } as Record<string, string>;
        const { state } = playground;
        Object.assign(playground, { plan: "east,east,west" });
        await playground.goTo(1);
        const step = playground.state?.step;
        playground.document = wide;
        pictures.document = await playground.toSVG();
        Object.assign(playground, { plan: null, problem: "head-fake" });
        pictures.problem = await playground.toSVG();
        playground.state = state;
        pictures.state = await playground.toSVG();
        playground.document = wide;
        const { status } = await playground.solve({ solver: "search" });
        // What never comes holds nothing up once something else is asked for.
        Object.assign(playground, { src: "never.json" });
        const waits = playground.toSVG();
        playground.document = wide;
        pictures.waited = await waits;
        return { pictures, step, status };
      },
      JSON.parse(grid({ width: 6 })),
    );
    const { corridor, document, problem, state, waited } = told.pictures;
    assert.equal(told.step, 1);
    assert.equal(new Set([corridor, document, problem]).size, 3, "three problems have three pictures");
    assert.equal(state, corridor);
    assert.equal(waited, document);
    assert.equal(told.status, "solved");
  }));

test("methods wait for a problem that takes long until it is open, and not until it is solved", () =>
  visit(async ({ page }) => {
    await lesson(page, one);
    await ready(page);
    const told = await page.locator("#one").evaluate(async (element, document) => {
      const playground = element as MoCoppPlayground;
      const before = await playground.toSVG();
      playground.document = document;
      const after = await playground.toSVG();
      return { other: before !== after, status: playground.dataset.status };
    }, JSON.parse(endless()));
    assert.deepEqual(told, { other: true, status: "solving" });
  }));

test("prose wakes a playground that waits below, brings it into sight, and follows it from wherever it stands", () =>
  visit(async ({ page }) => {
    const far = one.replace("<mo-copp-playground", '<mo-copp-playground loading="lazy"');
    const show = (name: string) => `<b class="${name}" data-mo-copp-for="one" data-mo-copp-show="${name}">?</b>`;
    await lesson(
      page,
      `<p><a id="to" href="#one" data-mo-copp-for="one" data-mo-copp-set-step="2">Two steps</a>
        <button id="short" data-mo-copp-for="one" data-mo-copp-set-plan="Straight there">Straight</button>
        <button id="wrong" data-mo-copp-for="one" data-mo-copp-set-problem="nowhere">Elsewhere</button>
        <input id="field" type="number" data-mo-copp-for="one" data-mo-copp-show="step">
        ${show("gd")} ${show("status")}</p><div style="height: 4000px"></div>${far}<div style="height: 4000px"></div>`,
    );
    await page.waitForSelector("#one[data-status=idle]");
    const says = (name: string, text: string) =>
      page
        .locator(`b.${name}`, { hasText: new RegExp(`^${text}$`) })
        .first()
        .waitFor();
    const told = () => page.evaluate(() => document.querySelector(".gd")?.textContent);
    assert.equal(await told(), "?");
    // A link to another tab is the browser's.
    const prevented = await page.locator("#to").evaluate((link) => {
      const click = new MouseEvent("click", { ctrlKey: true, bubbles: true, cancelable: true });
      let prevented = false;
      addEventListener(
        "click",
        (event) => {
          prevented = event.defaultPrevented;
          event.preventDefault();
        },
        { once: true },
      );
      link.dispatchEvent(click);
      return prevented;
    });
    assert.equal(prevented, false);
    assert.equal(await page.locator("#one").getAttribute("step"), null);
    await page.locator("#to").click();
    await ready(page, '[data-step="2"]');
    const inSight = () =>
      page.locator("#one").evaluate((host) => {
        const { top, bottom } = host.getBoundingClientRect();
        return Math.min(bottom, innerHeight) - Math.max(top, 0);
      });
    while ((await inSight()) <= 240) await page.waitForTimeout(20);
    // It comes gently: what follows begins where that has ended.
    await page.evaluate(async () => {
      for (let last = -1; last !== scrollY; ) {
        last = scrollY;
        await new Promise((done) => setTimeout(done, 200));
      }
    });
    assert.equal(await page.evaluate(() => location.hash), "");
    // What is in sight already stays where it is.
    await page.evaluate(() => document.querySelector("#one")?.scrollIntoView({ block: "start" }));
    const at = await page.evaluate(() => scrollY);
    await page.locator("#short").dispatchEvent("click");
    await says("gd", "1/3");
    assert.equal(await page.evaluate(() => scrollY), at);
    // Prose that comes later, and whose attributes come later.
    await page.evaluate(
      (late) => document.body.insertAdjacentHTML("beforeend", late),
      `<p>${show("steps")} <b class="count">?</b></p>`,
    );
    await says("steps", "3");
    await page.locator("b.count").evaluate((part) => {
      Object.assign((part as HTMLElement).dataset, { moCoppFor: "one", moCoppShow: "adversarial-count" });
    });
    await says("count", "0");
    // A number that is being typed asks for nothing yet.
    for (const typed of ["", "-1", "1.5", "99"]) await page.locator("#field").fill(typed);
    assert.equal(await page.locator("#one").getByRole("alert").textContent(), "");
    await page.locator("#field").fill("1");
    await ready(page, '[data-step="1"]');
    // A mistake is a status as well.
    await page.locator("#wrong").click();
    await says("status", "error");
  }));

test("links, fields and numbers in the prose drive the playground and follow it", () =>
  visit(async ({ page }) => {
    await lesson(
      page,
      `<p>At <a id="to" href="#one" data-mo-copp-for="one" data-mo-copp-set-step="2">the second step</a> the enemy has
        <b id="count" data-mo-copp-for="one" data-mo-copp-show="adversarial-count">?</b> goals left; the difference is
        <b id="gd" data-mo-copp-for="one" data-mo-copp-show="gd">?</b>.
        <button id="other" data-mo-copp-for="one" data-mo-copp-set-problem="head-fake" data-mo-copp-set-step="1">Another</button>
        <input id="field" type="range" min="0" value="0" data-mo-copp-for="one" data-mo-copp-show="step"></p>${one}`,
    );
    await ready(page, '[data-step="5"]');
    assert.equal(await page.locator("#gd").textContent(), "1");
    assert.equal(await page.locator("#field").inputValue(), "5");
    assert.equal(await page.locator("#count").textContent(), "4");
    await page.locator("#to").click();
    await ready(page, '[data-step="2"]');
    assert.equal(await page.locator("#to").getAttribute("aria-current"), "step");
    assert.notEqual(await page.locator("#count").textContent(), "4");
    assert.equal(await page.evaluate(() => location.hash), "");
    await page.locator("#field").fill("4");
    await ready(page, '[data-step="4"]');
    assert.equal(await page.locator("#to").getAttribute("aria-current"), null);
    await page.locator("#to").click();
    await ready(page, '[data-step="2"]');
    await page.locator("#other").click();
    await ready(page, '[data-step="1"]');
  }));

test("each attribute is a property that reflects it, and no other name of the element is one of theirs", () =>
  visit(async ({ page }) => {
    const guide = readFileSync(new URL("../../docs/embedding.md", import.meta.url), "utf8");
    const tables = guide.match(/^\| attribute \|.*\n(?:\|.*\n)+/gm) ?? [];
    const names = tables.flatMap((table) =>
      [...table.matchAll(/^\| (`[^|]+) \|/gm)].flatMap(([, cell = ""]) => cell.match(/[a-z-]+/g) ?? []),
    );
    assert.deepEqual(names.sort(), [...attributes].sort());
    await lesson(page, "");
    await page.waitForFunction(() => customElements.get("mo-copp-playground") !== undefined);
    const wrong = await page.evaluate(
      ([names, flags]) => {
        const element = document.createElement("mo-copp-playground");
        const wrong: string[] = [];
        for (const name of names) {
          const property = name.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase());
          const holders: object[] = [];
          for (let at: object = element; at !== HTMLElement.prototype; at = Object.getPrototypeOf(at))
            if (Object.hasOwn(at, property)) holders.push(at);
          const { get, set } = Object.getOwnPropertyDescriptor(holders[0] ?? {}, property) ?? {};
          if (holders.length !== 1 || !get || !set) wrong.push(`${name}: ${holders.length}`);
          const flag = flags.includes(name);
          const nothing = flag ? false : null;
          if (Reflect.get(element, property) !== nothing) wrong.push(`${name} at first`);
          element.setAttribute(name, "2");
          if (Reflect.get(element, property) !== (flag ? true : "2"))
            wrong.push(`${name} does not follow its attribute`);
          Reflect.set(element, property, flag ? false : 3);
          if (element.getAttribute(name) !== (flag ? null : "3")) wrong.push(`${name} does not set its attribute`);
          Reflect.set(element, property, undefined);
          if (element.hasAttribute(name) || Reflect.get(element, property) !== nothing)
            wrong.push(`${name} is not taken away`);
        }
        // What is the element's own business has private names.
        const own = Object.getOwnPropertyNames(element);
        if (own.join() !== "ready") wrong.push(`its own: ${own}`);
        Reflect.set(element, "exercise", { kind: "best" });
        Reflect.set(element, "plan", ["north", "east"]);
        return [...wrong, element.getAttribute("exercise"), element.getAttribute("plan")];
      },
      [names, flags] as const,
    );
    assert.deepEqual(wrong, ['{"kind":"best"}', "north,east"]);
  }));

test("what a framework sets before there is an element, or before it is in the page, counts", () =>
  visit(async ({ page }) => {
    await page.route("**/mo-copp-playground.js", async (route) => {
      await page.waitForFunction(() => "early" in window);
      await route.continue();
    });
    await lesson(
      page,
      `<mo-copp-playground id="one" link="off"></mo-copp-playground>
       <p style="height: 4000px"></p><mo-copp-playground id="two" link="off"></mo-copp-playground>
       <script>
         Object.assign(document.querySelector("#one"), { document: ${grid()}, step: 1, plan: ["north", "north"], theme: "dark" });
         document.querySelector("#two").loading = "lazy";
         window.early = true;
       </script>`,
    );
    await page.waitForSelector('#one[data-step="1"][data-scheme=dark]');
    const element = (selector: string) => page.locator(selector);
    const plan = await element("#one").evaluate((one) => (one as MoCoppPlayground).state?.plan);
    assert.deepEqual(plan, ["north", "north"]);
    assert.equal(await element("#two").getAttribute("data-status"), "idle");
    // The way of React 19 and of anywidget: made, set, and only then put into the page.
    const read = await page.evaluate((text) => {
      const made = document.createElement("mo-copp-playground") as MoCoppPlayground;
      const given = { id: "three", link: "off", step: 1, solver: "search", k: 1, j: 2, document: JSON.parse(text) };
      for (const [name, value] of Object.entries(given)) {
        if (name in made) Reflect.set(made, name, value);
        else made.setAttribute(name, String(value));
      }
      document.body.prepend(made);
      return made.document;
    }, grid());
    assert.deepEqual(read, JSON.parse(grid()));
    await page.waitForSelector('#three[data-status=solved][data-step="1"]');
    assert.equal(await element("#three").getByLabel("Solver").inputValue(), "search");
    // Later on as well: what was set is what is read, at once, and attributes are of that document from then on.
    const later = await element("#three").evaluate(
      (three, text) => {
        const playground = three as MoCoppPlayground;
        playground.document = text as unknown as MoCoppPlayground["document"];
        return (playground.document as { width?: number } | null)?.width;
      },
      grid({ width: 6 }),
    );
    assert.equal(later, 6);
    const board = element('#three [data-board=actor] [data-cell="5,0"]');
    await board.waitFor({ state: "attached" });
    await element("#three").evaluate((three) => Object.assign(three, { solver: "exact", step: null }));
    await page.waitForSelector("#three[data-status=optimal]");
    assert.equal(await board.count(), 1);
    await element("#three").evaluate((three) =>
      Object.assign(three, { problem: "corridor", solver: null, k: null, j: null }),
    );
    await page.waitForSelector('#three[data-status=optimal][data-step="5"]');
  }));

test("methods reject with a sentence what can't be used, and change nothing by it", () =>
  visit(async ({ page }) => {
    await lesson(page, one);
    await ready(page, '[data-step="5"]');
    const said = await page.evaluate<{
      refused: string[];
      before: DOMStringMap;
      done: string[];
      step: string;
    }>(`(async () => {
      const playground = document.querySelector("#one");
      const apart = document.createElement("mo-copp-playground");
      const told = async (promises) => (await Promise.allSettled(promises)).map(({ reason }) => String(reason ?? "did"));
      const refused = await told([
        ...["abc", NaN, 1.5, null].map((step) => playground.goTo(step)),
        playground.solve({ solver: "nonsense" }),
        playground.solve({ encoding: "toString" }),
        playground.solve({ k: "x" }),
        playground.solve({ k: 99 }),
        playground.solve({ solver: "exact", cost_limit: 3 }),
        ...[{ pairs: true }, { lengths: 4 }, { horizon_limit: 3 }, { hroizon: 3 }].map((options) => playground.solve(options)),
        playground.solve({ forbid: [{ observer: "adversarial", goal: "G1" }] }),
        ...["exact", ["exact"], 3].map((options) => playground.solve(options)),
        apart.goTo(1),
        apart.toSVG(),
        apart.solve(),
        playground.goTo(-1),
        playground.goTo(-Infinity),
      ]);
      const before = { ...playground.dataset };
      // The core's own word; what it is said of is forgotten.
      refused.push(...(await told([playground.solve({ k: 0 })])));
      const done = [];
      for (const call of [
        () => playground.solve({ solver: "ip", horizon: 5, cost_limit: undefined }),
        () => playground.solve({ solver: "ip", horizon: null, horizon_step: 5 }),
        () => playground.solve({ solver: "exact" }),
        () => playground.solve(null),
        () => playground.toSVG(null),
        () => playground.goTo(Infinity),
        () => playground.goTo("2"),
      ]) done.push(...(await told([call()])));
      await new Promise(requestAnimationFrame);
      return { refused, before, done, step: playground.dataset.step };
    })()`);
    const sentence = /^Error: (?!.*undefined).+ .+/;
    for (const text of said.refused) assert.match(text, sentence);
    assert.match(said.refused[0] ?? "", /“abc” is no step; expected a whole number from 0 to 5/);
    assert.match(said.refused[4] ?? "", /“nonsense” can’t be used as the solver; expected exact, ip/);
    assert.match(said.refused[6] ?? "", /k must be a whole number; found “x”/);
    assert.match(
      said.refused[8] ?? "",
      /“cost_limit” is no option that a playground knows; expected solver, encoding, k/,
    );
    assert.match(said.refused[12] ?? "", /“hroizon” is no option/);
    assert.match(said.refused[14] ?? "", /“exact” can’t be used as options; expected an object/);
    assert.deepEqual([said.before.status, said.before.step], ["optimal", "5"]);
    assert.deepEqual(said.done, Array(7).fill("did"));
    assert.equal(said.step, "2");
    assert.equal(
      await page
        .locator("#one")
        .getByRole("alert")
        .first()
        .textContent()
        .then((text) => text?.trim()),
      "",
    );
  }));

test("a poster leaves no gap, is there while nothing else is, and goes with an exercise, too", () =>
  visit(
    async ({ page }) => {
      const height = () => page.locator("#one").evaluate((element) => element.getBoundingClientRect().height);
      const lazy = `<div style="height: 4000px"></div><mo-copp-playground id="one" problem="corridor" loading="lazy" link="off">`;
      await lesson(page, `${lazy}A picture in words.</mo-copp-playground>`);
      await page.waitForSelector("#one[data-status=idle]");
      assert((await height()) < 100);
      // A classic script has the element made before its children are read.
      await lesson(page, `${lazy}<p>A picture</p></mo-copp-playground>`, {
        head: `<script src="../mo-copp-playground.single.js"></script>`,
      });
      await page.waitForSelector("#one[data-status=idle]");
      assert((await height()) < 100);
      await lesson(page, `${lazy}</mo-copp-playground>`);
      await page.waitForSelector("#one[data-status=idle]");
      assert((await height()) > 400);
      await page.route("**/problem.json", (route) => route.fulfill({ contentType: "application/json", body: grid() }));
      // Nothing could be opened: the picture, and the word of why.
      await lesson(page, one.replace('problem="corridor"', 'src="missing.json"').replace("></", "><p>A picture</p></"));
      await page.locator("#one").getByText("was answered with 404").waitFor();
      assert(await page.getByText("A picture").isVisible());
      assert((await height()) < 200, String(await height()));
      await page.evaluate(() => document.querySelector("#one")?.setAttribute("exercise", '{"kind": "best"}'));
      await page.evaluate(() => document.querySelector("#one")?.setAttribute("src", "../problem.json"));
      await page.locator("#one .exercise").waitFor();
      assert(!(await page.getByText("A picture").isVisible()));
    },
    { quiet: false },
  ));

test("a base of the page leaves its address the page's own", () =>
  visit(async ({ page }) => {
    for (const base of ["/docs/", "https://elsewhere.example/"]) {
      await lesson(
        page,
        `<script>history.replaceState(null, "", "?x=1")</script><base href="${base}">
          <mo-copp-playground id="one" problem="corridor"></mo-copp-playground>`,
      );
      await ready(page);
      await page.waitForFunction("location.hash.length > 1");
      assert.equal(page.url().replace(/#.*$/s, ""), `${address}lesson/guest.html?x=1`);
    }
  }));

test("libraries that put lists of their own in the place of the browser's leave the playground as it is", () =>
  visit(async ({ page }) => {
    // As libraries of the time before iterators do: what has a length is a list, and nothing else.
    const library = `<script>
      Array.from = (given) => Object.assign([], { length: given.length || 0 }, given);
      Array.prototype.entries = function () { return [...this]; };
    </script>`;
    for (const [problem, board] of [
      ["corridor", "[data-cell='1,0']"],
      ["delivery", ".truck"],
      ["blocks", "rect"],
    ] as const) {
      await lesson(page, one.replace("corridor", problem), { head: library });
      await ready(page);
      await page.locator(`#one [data-board=actor] ${board}`).first().waitFor({ state: "attached" });
      await page.locator("#one").getByRole("tab", { name: "Trade-off" }).click();
      await page.locator("#one .charts .point").first().waitFor({ state: "attached" });
    }
  }));

test("where parts stand goes by the size that all goes by, and not by the page's root", () =>
  visit(async ({ page }) => {
    // Between the widths at which parts of the playground are laid out in another way.
    for (const width of [350, 600, 800, 1000, 1100]) {
      const layouts = new Set<string>();
      for (const root of [10, 16, 20]) {
        await lesson(
          page,
          `<div style="width: ${width}px; --mo-copp-font-size: 16px"><mo-copp-playground id="one" problem="corridor" link="off"></mo-copp-playground></div>`,
          { html: `style="font-size: ${root}px"` },
        );
        await ready(page);
        const places = await page.locator("#one").evaluate((element) => {
          const { left, top } = element.getBoundingClientRect();
          return [...(element.shadowRoot?.querySelectorAll(".panel, .stepper, .legend, .below > *, button") ?? [])].map(
            (part) => {
              const box = part.getBoundingClientRect();
              return [box.left - left, box.top - top, box.width].map(Math.round);
            },
          );
        });
        assert(places.length > 10, "parts are there");
        layouts.add(JSON.stringify(places));
      }
      assert.equal(layouts.size, 1, `one layout at ${width} pixels, whatever the root`);
    }
  }));

test("whichever way a page writes, the boards are as large as ever, and its letters are set as ever", () =>
  visit(async ({ page }) => {
    const hostile = `visibility: visible; letter-spacing: 5px; word-spacing: 9px; line-height: 4; text-indent: 50px; text-transform: uppercase;
      white-space: pre; text-orientation: upright; hyphens: auto; tab-size: 20; font: italic 700 40px/3 serif; text-align: right; direction: rtl;
      border-spacing: 20px; caption-side: bottom; quotes: none; orphans: 9; overflow-wrap: anywhere; word-break: break-all; line-break: anywhere`;
    const measured = async (style: string, head = "") => {
      await lesson(page, `<div style="${style}"><div style="width: 800px">${one}</div></div>`, { head });
      await ready(page);
      return page.locator("#one").evaluate((playground) => {
        const found = [...(playground.shadowRoot?.querySelectorAll("svg[data-board], h2, .stepper") ?? [])];
        const sizes = found
          .map((part) => part.getBoundingClientRect())
          .map(({ width, height }) => [width, height].map(Math.round));
        return { sizes, width: Math.round(playground.getBoundingClientRect().width) };
      });
    };
    const plain = await measured("");
    assert.equal(plain.width, 800);
    assert(plain.sizes.length > 3, "boards and headings are found");
    for (const mode of ["vertical-rl", "vertical-lr", "sideways-rl"])
      assert.deepEqual(await measured(`writing-mode: ${mode}`), plain, mode);
    assert.deepEqual(await measured(`writing-mode: vertical-rl; ${hostile}`), plain, "all that is inherited");
    // A rule may be for the element itself, or for all.
    const broken = "columns: 3; contain: strict; container: page / size; text-orientation: upright; direction: rtl";
    for (const rule of ["writing-mode: vertical-rl", "writing-mode: sideways-lr !important", broken])
      for (const selector of ["mo-copp-playground", ...(rule === broken ? [] : ["*", "body *"])])
        assert.deepEqual(
          await measured("", `<style>${selector} { ${rule} }</style>`),
          plain,
          `${selector} { ${rule} }`,
        );
    // Where the place has no width of its own, there are boards all the same.
    await lesson(page, `<div style="writing-mode: vertical-rl; height: 600px">${one}</div>`);
    await ready(page);
    const board = await page.locator("#one svg[data-board=actor]").first().boundingBox();
    assert((board?.width ?? 0) > 100 && (board?.height ?? 0) > 30, `the board is ${JSON.stringify(board)}`);
  }));
