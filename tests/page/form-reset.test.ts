// A form with a question that is reset: it sends no code until another answer is checked.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { visit } from "./support/browser.js";
import { exerciseText } from "./support/exercises.js";
import { startHost } from "./support/host.js";
import { press } from "./support/playground.js";

const sent = (page: Page) => page.evaluate(() => new FormData(document.querySelector("form") ?? undefined).get("q"));

test("a form that is reset sends no code until another answer is checked, and attempts stay", async () => {
  const host = await startHost();
  host.own.set("favicon.ico", { body: "" });
  host.own.set("goals.json", { body: exerciseText("01-possible-goals") });
  host.own.set("page.html", {
    body: `<!doctype html><html lang="en"><title>Course</title><script type="module" src="mo-copp-playground.js"></script>
      <main><form><mo-copp-playground src="goals.json" seed="7" link="off" name="q"></mo-copp-playground></form></main>`,
  });
  await visit(async ({ page }) => {
    await page.goto(`${host.address}page.html`);
    const choice = page.locator(".choices input");
    await choice.nth(0).check();
    await press(page, "Check the answer");
    await page.getByText("2 attempts left.").waitFor();
    const code = page.getByLabel("Answer code");
    const first = await code.inputValue();
    assert.equal(await sent(page), first, "the code is sent");
    await page.evaluate(() => document.querySelector("form")?.reset());
    assert.equal(await sent(page), null, "nothing is sent after the reset");
    assert.equal(await page.getByText("2 attempts left.").count(), 1, "the attempt stays made");
    await choice.nth(1).check();
    await press(page, "Check the answer");
    await page.getByText("1 attempt left.").waitFor();
    assert.notEqual(await code.inputValue(), first, "the code of the other answer");
    assert.equal(await sent(page), await code.inputValue(), "it is sent again");
  });
});
