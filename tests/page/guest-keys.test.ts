// The page's keys are the playground's only while it is in sight and in reach, and no dialog of it stays open out of sight.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { startHost } from "./support/host.js";

const home = await startHost();

async function lesson(page: Page, body: string): Promise<void> {
  home.own.set("lesson/page.html", {
    body: `<!doctype html><html lang="en"><meta charset="utf-8"><link rel="icon" href="data:,"><title>Lesson</title>
      <script type="module" src="../mo-copp-playground.js"></script>${body}<p style="height: 4000px">End</p>`,
  });
  await page.goto(`${home.address}lesson/page.html`);
  await page.waitForSelector('#one[data-status="optimal"][data-step="5"]', { state: "attached" });
}

const one = '<mo-copp-playground id="one" problem="corridor" link="off" keys="page"></mo-copp-playground>';
const step = (page: Page) => page.locator("#one").getAttribute("data-step");
const dialogs = (page: Page) => page.locator("#one dialog[open]").count();

const unseen = {
  "a tab that is closed": (inside: string) => `<div style="display: none">${inside}</div>`,
  "details that are closed": (inside: string) => `<details><summary>More</summary>${inside}</details>`,
  "a part that is hidden until found": (inside: string) => `<div hidden="until-found">${inside}</div>`,
  "an inert part": (inside: string) => `<div inert>${inside}</div>`,
  "an invisible part": (inside: string) => `<div style="visibility: hidden">${inside}</div>`,
  "a panel beside the window": (inside: string) =>
    `<div style="position: fixed; left: -3000px; width: 900px">${inside}</div>`,
  "a place far below": (inside: string) => `<div style="height: 4000px">Text</div>${inside}`,
  "behind a dialog of the page": (inside: string) =>
    `${inside}<dialog id="own">Wait</dialog><script>document.getElementById("own").showModal(); document.activeElement.blur();</script>`,
  "behind a dialog in a shadow root": (inside: string) =>
    `${inside}<div id="shell"></div><script>
      const root = document.getElementById("shell").attachShadow({ mode: "closed" });
      root.innerHTML = "<dialog>Wait</dialog>";
      root.querySelector("dialog").showModal();
      document.activeElement.blur();
    </script>`,
  "beneath a menu of the page": (inside: string) =>
    `${inside}<div id="menu" popover>Menu</div><script>document.getElementById("menu").showPopover();</script>`,
  "a page that is being written": (inside: string) => `${inside}<script>document.designMode = "on"</script>`,
};

for (const [where, around] of Object.entries(unseen)) {
  test(`keys that are for nothing stay the page's: ${where}`, () =>
    visit(async ({ page }) => {
      await lesson(page, around(one));
      for (const key of ["Home", "ArrowLeft", "?"]) await page.keyboard.press(key);
      assert.equal(await step(page), "5");
      assert.equal(await dialogs(page), 0);
    }));
}

test("keys that are for nothing are for the playground in sight, and for no field that takes text", () =>
  visit(async ({ page }) => {
    await lesson(
      page,
      `<p><a id="link" href="#x">A link</a></p><div id="box" role="textbox" tabindex="0">Box</div><div id="field"></div>${one}
        <script>document.getElementById("field").attachShadow({ mode: "closed" }).innerHTML = "<input>";</script>`,
    );
    await page.keyboard.press("Home");
    await page.waitForSelector('#one[data-step="0"]');
    await page.locator("#box").focus();
    await page.keyboard.press("?");
    assert.equal(await dialogs(page), 0);
    // Into the field of a component of the page.
    const field = await page.locator("#field").boundingBox();
    assert(field, "the field is drawn");
    await page.mouse.click(field.x + 20, field.y + 8);
    await page.keyboard.press("?");
    assert.equal(await dialogs(page), 0);
    await page.locator("#link").focus();
    await page.keyboard.press("?");
    await page.locator("#one dialog[open]").waitFor();
  }));

/** How a page hides the tab, and shows it again. */
const hidings: Record<string, [hide: string, show: string]> = {
  "display: none": ["tab.style.display = 'none'", "tab.style.display = ''"],
  "closed details": ["tab.open = false", "tab.open = true"],
  "hidden until found": ["tab.hidden = 'until-found'", "tab.hidden = false"],
  "content-visibility: hidden": ["tab.style.contentVisibility = 'hidden'", "tab.style.contentVisibility = ''"],
};

test("a dialog closes where the page hides what it stands in", () =>
  visit(async ({ page }) => {
    await lesson(
      page,
      `<a id="link" href="#x" onclick="window.clicked = true">A link</a><details id="tab" open>${one}</details>`,
    );
    for (const [how, [hide, show]] of Object.entries(hidings)) {
      for (const name of ["Help", "Save picture"]) {
        await page.locator("#one").getByRole("button", { name, exact: true }).first().click();
        await page.locator("#one dialog[open]").waitFor();
        await page.evaluate(hide);
        await page.locator("#one dialog[open]").waitFor({ state: "detached" });
        await page.locator("#link").click();
        assert.equal(await page.evaluate("window.clicked"), true, how);
        await page.evaluate(`window.clicked = false; ${show}`);
      }
    }
  }));
