// What a course page may do with the element: make, clone and move it, hide and show it, and the styles that it has.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { dragMouse } from "./support/hands.js";
import { startHost } from "./support/host.js";

const home = await startHost();

const playground = (id: string, more = "") =>
  `<mo-copp-playground id="${id}" problem="corridor" link="off" ${more}></mo-copp-playground>`;

async function lesson(page: Page, body: string, style = "", html = ""): Promise<void> {
  home.own.set("lesson/page.html", {
    body: `<!doctype html><html lang="en" ${html}><meta charset="utf-8"><link rel="icon" href="data:,"><title>Lesson</title>
      <style>${style}</style><script type="module" src="../mo-copp-playground.js"></script>${body}`,
  });
  await page.goto(`${home.address}lesson/page.html`);
  await page.waitForFunction(() => customElements.get("mo-copp-playground") !== undefined);
}

const ready = (page: Page, id: string) => page.waitForSelector(`#${id}[data-status=optimal]`);

/** What is wrong with how a playground stands in its place: nothing is cut off, lies on another part, or is empty. */
const wrongWith = (page: Page, id: string) =>
  page.evaluate<string[]>(`(async () => {
    const host = document.querySelector("#${id}");
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const found = [];
    const box = host.getBoundingClientRect();
    const inner = [...host.shadowRoot.querySelectorAll("svg[data-board], .stepper, .panel, .legend, .workbench, .goals, .problem-bar")];
    if (inner.length < 5) found.push("parts are missing: " + inner.length);
    for (const part of inner) {
      const { left, right, width, height } = part.getBoundingClientRect();
      const name = part.getAttribute("class") ?? part.dataset.board;
      if (width < 50 || height < 10) found.push(name + " is " + width + " by " + height);
      if (left < box.left - 1 || right > box.right + 1) found.push(name + " sticks out");
    }
    const panels = [...host.shadowRoot.querySelectorAll(".panel")].map((panel) => panel.getBoundingClientRect());
    for (const [index, one] of panels.entries())
      for (const other of panels.slice(index + 1))
        if (one.left < other.right - 1 && other.left < one.right - 1 && one.top < other.bottom - 1 && other.top < one.bottom - 1)
          found.push("boards lie on one another");
    return found;
  })()`);

test("made by innerHTML, cloned from a template, cloned when it runs, or written by a script, it runs", () =>
  visit(async ({ page }) => {
    await lesson(
      page,
      `<div id="html"></div><template id="template">${playground("cloned")}</template><div id="there"></div>
       <mo-copp-playground id="first" problem="head-fake" step="2" link="off"><script type="application/json">{}</script></mo-copp-playground>`,
    );
    await page.waitForSelector('#first[data-step="2"]');
    await page.evaluate((inner) => {
      (document.querySelector("#html") as Element).innerHTML = inner;
      const { content } = document.querySelector("#template") as HTMLTemplateElement;
      const there = document.querySelector("#there") as Element;
      there.append(content.cloneNode(true), document.importNode(content, true));
      (there.lastElementChild as Element).id = "imported";
      const first = document.querySelector("#first") as Element;
      const copy = first.cloneNode(true) as Element;
      copy.id = "copy";
      there.append(copy);
      there.insertAdjacentHTML("beforeend", inner.replace("made", "adjacent"));
    }, playground("made"));
    for (const id of ["made", "cloned", "imported", "adjacent"]) {
      await ready(page, id);
      assert.deepEqual(await wrongWith(page, id), [], id);
    }
    await page.waitForSelector('#copy[data-status=optimal][data-step="2"]');
    // A part of the page that is parsed without running may come later.
    await page.evaluate((inner) => {
      const parsed = new DOMParser().parseFromString(inner, "text/html");
      document.body.append(...parsed.body.childNodes);
    }, playground("parsed"));
    await ready(page, "parsed");
  }));

test("moved into the document of a frame, and back, it looks and works as before", () =>
  visit(async ({ page }) => {
    home.own.set("lesson/empty.html", {
      body: `<!doctype html><html lang="en"><title>Empty</title><body></body></html>`,
    });
    await lesson(
      page,
      `<iframe id="frame" title="A frame" width="1000" height="600" src="empty.html"></iframe>${playground("one")}`,
    );
    await ready(page, "one");
    const board = () =>
      page.evaluate(() => {
        const inner = (document.querySelector("#frame") as HTMLIFrameElement).contentDocument;
        const host = document.querySelector("#one") ?? inner?.querySelector("#one");
        const panel = host?.shadowRoot?.querySelector(".panel");
        return panel ? (panel.ownerDocument.defaultView ?? window).getComputedStyle(panel).backgroundColor : "none";
      });
    const before = await board();
    await page.evaluate(() => {
      const inner = (document.querySelector("#frame") as HTMLIFrameElement).contentDocument as Document;
      inner.body.append(document.querySelector("#one") as Element);
    });
    const there = page.frameLocator("#frame").locator("#one");
    await there.getByRole("button", { name: "First step" }).click();
    await page.frameLocator("#frame").locator('#one[data-step="0"]').waitFor();
    assert.equal(await board(), before);
    await page.evaluate(() => {
      const inner = (document.querySelector("#frame") as HTMLIFrameElement).contentDocument as Document;
      document.body.append(inner.querySelector("#one") as Element);
    });
    await page.locator("#one").getByRole("button", { name: "Last step" }).click();
    await page.waitForSelector('#one[data-step="5"]');
    assert.equal(await board(), before);
    assert.deepEqual(await wrongWith(page, "one"), []);
  }));

test("hidden and then shown, in a closed details, in a dialog, it stands as anywhere", () =>
  visit(async ({ page }) => {
    await lesson(
      page,
      `<div id="hidden" style="display: none">${playground("shown")}</div>
       <details id="details"><summary>More</summary>${playground("opened")}</details>
       <dialog id="dialog" style="width: 900px">${playground("modal")}<button id="close">Close</button></dialog>
       <div id="until" hidden="until-found">${playground("found")}</div>
       <div style="content-visibility: auto">${playground("skipped")}</div>
       <div popover="manual" id="popover" style="width: 900px">${playground("popped")}</div>`,
    );
    for (const id of ["shown", "opened", "modal", "found", "popped"])
      await page.waitForSelector(`#${id}[data-status=optimal]`, { state: "attached" });
    await page.evaluate(() => {
      (document.querySelector("#hidden") as HTMLElement).style.display = "";
      (document.querySelector("#details") as HTMLDetailsElement).open = true;
      (document.querySelector("#until") as HTMLElement).hidden = false;
    });
    for (const id of ["shown", "opened", "found", "skipped"]) {
      await ready(page, id);
      assert.deepEqual(await wrongWith(page, id), [], id);
    }
    await page.evaluate(() => (document.querySelector("#popover") as HTMLElement).showPopover());
    assert.deepEqual(await wrongWith(page, "popped"), []);
    await page.evaluate(() => (document.querySelector("#popover") as HTMLElement).hidePopover());
    await page.evaluate(() => (document.querySelector("#dialog") as HTMLDialogElement).showModal());
    assert.deepEqual(await wrongWith(page, "modal"), []);
    // Its own dialogs open above the page's, and Escape closes one of them at a time.
    await page.locator("#modal").getByRole("button", { name: "Help" }).click();
    await page.locator("#modal dialog.help").waitFor();
    await page.keyboard.press("Escape");
    await page.locator("#modal dialog.help[open]").waitFor({ state: "detached" });
    assert.equal(await page.evaluate(() => (document.querySelector("#dialog") as HTMLDialogElement).open), true);
    await page.keyboard.press("ArrowLeft");
    await page.waitForSelector('#modal[data-step="4"]');
  }));

/** Styles of a page, and what is around the element. */
const pages: Record<string, { style?: string; html?: string; around?: [before: string, after: string] }> = {
  "a flex column of 300 pixels": {
    around: [`<div style="display: flex"><div style="width: 300px">`, "</div><p>Beside</p></div>"],
  },
  "a grid column of 300 pixels": {
    around: [`<div style="display: grid; grid-template-columns: 300px 1fr">`, "<p>Beside</p></div>"],
  },
  "a grid column that may shrink": {
    around: [
      `<div style="display: grid; grid-template-columns: minmax(0, 1fr) 200px; width: 700px">`,
      "<p>Beside</p></div>",
    ],
  },
  "a page from right to left": { html: `dir="rtl"` },
  "zoom: 1.5": { style: "body { zoom: 1.5 }" },
  "a zoom of the element": { style: "mo-copp-playground { zoom: 0.75 }" },
  "a root of 10 pixels": { style: "html { font-size: 10px } body { font-size: 1.6rem }" },
  "a root of 24 pixels": { style: "html { font-size: 24px }" },
  "a root of 62.5 %": { style: "html { font-size: 62.5% }" },
  "user-select: none": { style: "* { user-select: none }" },
  "content boxes": { style: "*, ::before, ::after { box-sizing: content-box !important }" },
  "every div a grid": { style: ":where(div) { display: grid }" },
  "every div a flex row": { style: "div { display: flex; gap: 3rem; align-items: center }" },
  "a transform": { around: [`<div style="transform: translateZ(0)">`, "</div>"] },
  "columns around it": { around: [`<div style="columns: 2; column-gap: 1rem; width: 1200px">`, "<p>More.</p></div>"] },
  "images and svg of a reset": {
    style: "img, svg, video, canvas { display: block; max-width: 100%; height: auto } svg { fill: red; width: 20px }",
  },
  "no words break": { style: "* { white-space: nowrap; overflow-wrap: normal; hyphens: none }" },
  "text-size-adjust and line-height": {
    style: "body { line-height: 3; text-size-adjust: none; font-variant: small-caps; text-wrap: balance }",
  },
  "all text justified": { style: "body { text-align: justify; text-align-last: justify; hyphens: auto }" },
  "an outline for everything": { style: "* { outline: 1px solid red; min-width: 0; min-height: 0 }" },
};

test("styles that course pages have leave it whole in its place", () =>
  visit(async ({ page }) => {
    const wrong: string[] = [];
    for (const [name, { style = "", html = "", around: [before, after] = ["", ""] }] of Object.entries(pages)) {
      await lesson(page, `${before}${playground("one")}${after}`, style, html);
      await ready(page, "one");
      for (const found of await wrongWith(page, "one")) wrong.push(`${name}: ${found}`);
      const over = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      );
      if (over > 0) wrong.push(`${name}: the page is ${over} wider than its window`);
    }
    assert.deepEqual(wrong, []);
  }));

test("where a page is zoomed or turned, a hand still finds the cells", () =>
  visit(async ({ page }) => {
    const missed: string[] = [];
    for (const style of [
      "",
      "body { zoom: 1.5 }",
      "mo-copp-playground { zoom: 0.75 }",
      "body { transform: scale(0.8); transform-origin: 0 0 }",
      "body { transform: rotate(3deg) }",
      "body { direction: rtl }",
    ]) {
      await lesson(page, playground("one", `hide="workbench goals legend"`), style);
      await ready(page, "one");
      const [column, row] = await start(page);
      const to = [column + 1, row] as const;
      await dragMouse(page, "actor", [[column, row], to]);
      await page.waitForTimeout(50);
      if (String(await start(page)) !== String(to)) missed.push(`${style}: ${await start(page)}, and not ${to}`);
    }
    assert.deepEqual(missed, []);
  }));

const start = (page: Page) =>
  page
    .locator("#one")
    .evaluate((one) => (one as HTMLElement & { document: { start: [number, number] } }).document.start);

test("its dialogs fit the window, however the page is zoomed", () =>
  visit(async ({ page }) => {
    const outside: string[] = [];
    for (const style of [
      "",
      "body { zoom: 1.5 }",
      "html { zoom: 1.25 }",
      "mo-copp-playground { zoom: 2 }",
      "body { zoom: 0.6 }",
    ]) {
      await lesson(page, playground("one"), style);
      await ready(page, "one");
      for (const [opener, dialog] of [
        [".problem-bar .current", "dialog.gallery"],
        ["button[aria-label=Help]", "dialog.help"],
        [".save-picture", "dialog.picture-sheet"],
      ] as const) {
        await page.locator(`#one ${opener}`).first().click();
        await page.locator(`#one ${dialog}[open]`).waitFor();
        await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
        const { left, right, top, bottom } = await page
          .locator(`#one ${dialog}`)
          .evaluate((open) => open.getBoundingClientRect().toJSON());
        if (left < 0 || top < 0 || right > 1280 || bottom > 800)
          outside.push(`${style}: ${dialog} is at ${[left, top, right, bottom]}`);
        await page.keyboard.press("Escape");
        await page.locator(`#one ${dialog}[open]`).waitFor({ state: "detached" });
      }
    }
    assert.deepEqual(outside, []);
  }));

test("on the whole screen all of it can be scrolled to", () =>
  visit(async ({ page }) => {
    await lesson(page, `<button id="full">Whole screen</button>${playground("one")}`);
    await ready(page, "one");
    await page.evaluate(() => {
      const full = document.querySelector("#full") as HTMLElement;
      full.onclick = () => void document.querySelector("#one")?.requestFullscreen();
    });
    await page.locator("#full").click();
    await page.waitForFunction(() => document.fullscreenElement !== null);
    const left = await page.locator("#one").evaluate((one) => {
      one.scrollTop = one.scrollHeight;
      const { bottom = 0 } = one.shadowRoot?.querySelector(".mo-copp-part")?.getBoundingClientRect() ?? {};
      return [one.scrollTop > 0, Math.max(0, Math.floor(bottom - innerHeight))];
    });
    assert.deepEqual(left, [true, 0], "how far below the screen it ends");
    await page.evaluate(() => document.exitFullscreen());
  }));

test("in a card that can be dragged, what is dragged on a board leaves the card where it is", () =>
  visit(async ({ page }) => {
    await lesson(
      page,
      `<div draggable="true" id="card"><p id="text">A card</p>${playground("one", `hide="workbench goals legend"`)}</div>`,
    );
    await ready(page, "one");
    await page.evaluate(() => {
      Object.assign(window, { dragged: 0 });
      document.querySelector("#card")?.addEventListener("dragstart", () => {
        (window as unknown as { dragged: number }).dragged += 1;
      });
    });
    const [column, row] = await start(page);
    for (const to of [column + 1, column]) {
      const [from] = await start(page);
      await dragMouse(page, "actor", [
        [from, row],
        [to, row],
      ]);
      await page.waitForFunction(
        (to) =>
          (document.querySelector("#one") as HTMLElement & { document: { start: number[] } }).document.start[0] === to,
        to,
      );
    }
    assert.equal(await page.evaluate("window.dragged"), 0);
    await page.locator("#text").dragTo(page.locator("body"), { targetPosition: { x: 5, y: 5 } });
    assert.equal(await page.evaluate("window.dragged"), 1, "the card itself is dragged as ever");
  }));

test("with no problem open the way to all of them has a name", () =>
  visit(
    async ({ page }) => {
      await lesson(page, playground("one").replace("corridor", "nowhere"));
      await page.waitForSelector("#one[data-status=error]");
      await page
        .locator("#one")
        .getByRole("button", { name: "All problems No problem is open yet", exact: true })
        .waitFor();
    },
    { quiet: false },
  ));

test("without motion, and with colours of the system alone, there is all that there was", () =>
  visit(
    async ({ page }) => {
      await lesson(page, playground("one"));
      await ready(page, "one");
      assert.deepEqual(await wrongWith(page, "one"), []);
      await page.emulateMedia({ forcedColors: "active", reducedMotion: "reduce" });
      assert.deepEqual(await wrongWith(page, "one"), []);
      // What has the focus is seen.
      const button = page.locator("#one").getByRole("button", { name: "Help" });
      await button.focus();
      await page.keyboard.press("Shift+Tab");
      await page.keyboard.press("Tab");
      assert.notEqual(await button.evaluate((one) => getComputedStyle(one).outlineStyle), "none");
      await page.locator("#one").getByRole("button", { name: "First step" }).click();
      await page.waitForSelector('#one[data-step="0"]');
      const moving = await page
        .locator("#one")
        .evaluate(
          (one) =>
            (one.shadowRoot as ShadowRoot).getAnimations().filter(({ playState }) => playState === "running").length,
        );
      assert.equal(moving, 0, "nothing moves");
    },
    { reducedMotion: "reduce" },
  ));
