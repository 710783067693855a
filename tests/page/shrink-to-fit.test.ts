// The element where its box is as wide as what is in it: floats, tables, flex and grid items, dialogs, Bootstrap, Bulma.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { nodeModules } from "../../scripts/lib/paths.mjs";
import { visit } from "./support/browser.js";
import { address } from "./support/site.js";

/** What it takes where there is room for it, and the least where its box asks for as little as can be. */
const [NATURAL, LEAST] = [960, 160];

/** Markup around the element, which stands where the `slot` is. */
const wrappers: Readonly<Record<string, string>> = {
  "a float": `<div style="float: left"><slot></slot></div>`,
  "a reset that floats everything": `<style>div { float: left }</style><div><slot></slot></div>`,
  "a floated host": `<slot style="float: right"></slot>`,
  "an inline-block host": `<slot style="display: inline-block"></slot>`,
  "an inline-block": `<span style="display: inline-block"><slot></slot></span>`,
  "a flex item": `<div style="display: flex"><slot></slot></div>`,
  "a box in a flex row": `<div style="display: flex"><div><slot></slot></div></div>`,
  "a flex column that centres": `<div style="display: flex; flex-direction: column; align-items: center"><slot></slot></div>`,
  "a grid that centres": `<div style="display: grid; place-items: center"><slot></slot></div>`,
  "a centred box in a grid": `<div style="display: grid; justify-items: start"><div><slot></slot></div></div>`,
  "a table cell": `<table><tr><td><slot></slot></td></tr></table>`,
  "a box as a table": `<div style="display: table"><slot></slot></div>`,
  "a position of its own": `<div style="position: absolute"><slot></slot></div>`,
  "fit-content": `<div style="width: fit-content"><slot></slot></div>`,
  "a dialog": `<dialog open><slot></slot></dialog>`,
  "a field set in a float": `<div style="float: left"><fieldset><slot></slot></fieldset></div>`,
  "Bootstrap: d-flex": `<div class="container"><div class="d-flex"><slot></slot></div></div>`,
  "Bootstrap: col-auto": `<div class="container"><div class="row"><div class="col-auto"><slot></slot></div></div></div>`,
  "Bootstrap: d-inline-block": `<div class="container"><div class="d-inline-block"><slot></slot></div></div>`,
  "GitHub: a table": `<article class="markdown-body"><table><tr><td><slot></slot></td></tr></table></article>`,
  "a host that is an inline-flex row": `<slot style="display: inline-flex"></slot>`,
  "a host that is an inline grid": `<slot style="display: inline-grid"></slot>`,
  "a host that is a table": `<slot style="display: table"></slot>`,
  "an exact box": `<div style="width: 300px"><slot></slot></div>`,
  "a plain block": `<div><slot></slot></div>`,
};

/** Boxes that never shrink below what is in them: nothing fills the room there is, and nothing may run out of it. */
const rigid: Readonly<Record<string, string>> = {
  "a flex item that keeps its size": `<div style="display: flex"><div style="flex: none"><slot></slot></div></div>`,
  "Bulma: is-narrow": `<div class="columns is-mobile" style="display: flex"><div class="column is-narrow" style="flex: none; width: unset"><slot></slot></div></div>`,
  "max-content": `<div style="width: max-content"><slot></slot></div>`,
};

const css = (...path: string[]) => readFileSync(join(nodeModules, ...path), "utf8").replaceAll("</style", "");
const styleOf = (name: string) =>
  name.startsWith("Bootstrap")
    ? css("bootstrap", "dist", "css", "bootstrap.css")
    : name.startsWith("GitHub")
      ? css("github-markdown-css", "github-markdown.css")
      : "";

interface Measured {
  /** How wide the element is. */
  width: number;
  /** How wide a long text is in its place: it fills what is there. */
  room: number;
  overflow: number;
}

/** What a page's own rule, meant for other elements, makes of the host: it fills its place all the same. */
const hosts = [
  ...["block", "flow-root", "flex", "grid", "inline", "contents"].map((display) => `display: ${display}`),
  "display: flex; justify-content: center; align-items: center; gap: 2rem",
  "display: flex; flex-direction: column; align-items: center",
  "display: flex; flex-wrap: wrap",
  "display: grid; place-items: center",
  "display: grid; grid-template-columns: repeat(3, 1fr); gap: 1rem",
  "display: inline-flex; width: 100%",
];

/** Builds the box around a long text and then, in its place, around the one element of the page, which stays where it is. */
const measure = (page: Page, style: string, markup: string) =>
  page.evaluate(
    ([style, markup]): Measured => {
      const box = document.querySelector("#box") as HTMLElement;
      const shadow = box.shadowRoot ?? box.attachShadow({ mode: "open" });
      shadow.innerHTML = `<style>${style}</style>${markup}`;
      const place = shadow.querySelector("slot");
      const asked = place?.getAttribute("style") ?? "";
      place?.removeAttribute("style");
      const [room = 0, width = 0] = ["p", "mo-copp-playground"].map((name) => {
        for (const each of box.children) each.setAttribute("style", "display: none");
        const shown = box.querySelector(name);
        shown?.setAttribute("style", `display: block; margin: 0; ${asked}`);
        return shown?.getBoundingClientRect().width ?? 0;
      });
      return { room, width, overflow: document.documentElement.scrollWidth - innerWidth };
    },
    [style, markup] as const,
  );

test("it fills what is there up to its natural width, wherever its box shrinks to fit, and never a phone's edge", () =>
  visit(async ({ page }) => {
    await page.route(`${address}lesson/narrow.html`, (route) =>
      route.fulfill({
        contentType: "text/html",
        body: `<!doctype html><html lang="en"><head><title>Lesson</title><meta charset="utf-8">
          <script type="module" src="../mo-copp-playground.js"></script></head><body>
          <div id="box"><p>${"long text ".repeat(400)}</p><mo-copp-playground problem="corridor" hide="gallery tools stepper legend workbench goals" link="off"></mo-copp-playground></div></body></html>`,
      }),
    );
    await page.goto(`${address}lesson/narrow.html`);
    await page.waitForSelector("mo-copp-playground[data-status=optimal]");
    const wrong: string[] = [];
    for (const window of [1280, 360]) {
      await page.setViewportSize({ width: window, height: 800 });
      /** A window has so much more than the natural width, for what is around the element. */
      const natural = Math.min(NATURAL, window - 32);
      for (const [name, markup] of Object.entries({ ...wrappers, ...rigid })) {
        const { width, room, overflow } = await measure(page, styleOf(name), markup);
        const fills = name === "a plain block" ? room : name in rigid ? natural : Math.min(natural, room);
        if (Math.abs(width - fills) > 3) wrong.push(`${name} at ${window}: ${width} of ${fills}`);
        if (overflow > 0) wrong.push(`${name} at ${window}: ${overflow} too wide`);
      }
      const { width } = await measure(page, "", `<div style="width: min-content"><slot></slot></div>`);
      if (Math.abs(width - LEAST) > 3) wrong.push(`min-content at ${window}: ${width}`);
      // Less than the least is there: it is as narrow, and nothing of it sticks out.
      const little = await measure(page, "", `<div style="width: 100px; overflow: auto"><slot></slot></div>`);
      assert.equal(little.width, 100);
    }
    assert.deepEqual(wrong, []);
  }));

test("in a line of its own box it stands where a block stands", () =>
  visit(async ({ page }) => {
    await page.route(`${address}lesson/line.html`, (route) =>
      route.fulfill({
        contentType: "text/html",
        body: `<!doctype html><html lang="en"><head><title>Lesson</title>
          <script type="module" src="../mo-copp-playground.js"></script></head><body>
          <div id="box"><div id="inner"><mo-copp-playground problem="corridor" hide="workbench goals" link="off"></mo-copp-playground></div></div></body></html>`,
      }),
    );
    await page.goto(`${address}lesson/line.html`);
    await page.waitForSelector("mo-copp-playground[data-status=optimal]");
    const top = (inner: string, host: string) =>
      page.evaluate(
        ([inner, host]) => {
          document.querySelector("#inner")?.setAttribute("style", inner);
          const playground = document.querySelector("mo-copp-playground");
          playground?.setAttribute("style", host);
          const [box = 0, at = 0] = [document.querySelector("#box"), playground].map(
            (one) => one?.getBoundingClientRect().top,
          );
          return at - box;
        },
        [inner, host] as const,
      );
    for (const display of ["block", "inline-block", "inline-flex", "inline-grid", "inline-table"]) {
      for (const font of ["", "; font: 40px/2 serif"]) {
        assert.equal(await top(`display: ${display}${font}`, ""), 0, `a box of ${display}${font}`);
        assert.equal(await top(font.slice(2), `display: ${display}`), 0, `a host of ${display}${font}`);
      }
    }
  }));

test("whatever display a page gives the element, its boards are as wide as it is", () =>
  visit(async ({ page }) => {
    const one = `<mo-copp-playground problem="corridor" hide="workbench goals" link="off"></mo-copp-playground>`;
    await page.route(`${address}lesson/display.html`, (route) =>
      route.fulfill({
        contentType: "text/html",
        body: `<!doctype html><html lang="en"><head><title>Lesson</title>
          <script type="module" src="../mo-copp-playground.js"></script></head><body>${one}</body></html>`,
      }),
    );
    await page.goto(`${address}lesson/display.html`);
    await page.waitForSelector("mo-copp-playground[data-status=optimal]");
    for (const style of hosts) {
      const [part = 0, boards = 0, room = 0, overflow = 0] = await page
        .locator("mo-copp-playground")
        .evaluate((host, style) => {
          host.setAttribute("style", style);
          const sizes = [".mo-copp-part", "[data-board=actor]"].map(
            (selector) => host.shadowRoot?.querySelector(selector)?.getBoundingClientRect().width,
          );
          return [...sizes, document.body.clientWidth, document.documentElement.scrollWidth - innerWidth];
        }, style);
      assert(Math.abs(part - room) <= 1, `${style}: ${part} of ${room}`);
      assert(boards > 300, `${style}: boards of ${boards}`);
      assert(overflow <= 0, `${style}: ${overflow} too wide`);
    }
  }));

test("a playground that waits for its turn has the width that it will have", () =>
  visit(async ({ page }) => {
    await page.route("**/shadow-view-*.js", () => undefined);
    await page.route(`${address}lesson/waiting.html`, (route) =>
      route.fulfill({
        contentType: "text/html",
        body: `<!doctype html><html lang="en"><head><title>Lesson</title>
          <script type="module" src="../mo-copp-playground.js"></script></head><body>
          <div style="float: left"><mo-copp-playground problem="corridor" hide="gallery tools stepper legend workbench goals" link="off"></mo-copp-playground></div></body></html>`,
      }),
    );
    await page.goto(`${address}lesson/waiting.html`);
    await page.waitForFunction(() => document.querySelector("mo-copp-playground")?.shadowRoot);
    assert(Math.abs(((await page.locator("mo-copp-playground").boundingBox())?.width ?? 0) - NATURAL) <= 3);
  }));
