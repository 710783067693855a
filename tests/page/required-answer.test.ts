// A required answer that is missing: the form says so where its question is, or is to be, and asks for none that no question asks for.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import { visit } from "./support/browser.js";
import { exerciseText } from "./support/exercises.js";
import { startHost } from "./support/host.js";

const host = await startHost();
host.own.set("favicon.ico", { body: "" });
host.own.set("goals.json", { body: exerciseText("01-possible-goals") });
host.own.set("broken.json", { body: "{" });
host.own.set("sent.html", { body: `<!doctype html><html lang="en"><title>Sent</title><p>Sent.</p>` });

/** A form whose button is far above its playground. */
async function course(page: Page, attributes: string, poster = ""): Promise<void> {
  host.own.set("page.html", {
    body: `<!doctype html><html lang="en"><title>Course</title><script type="module" src="mo-copp-playground.js"></script>
      <form action="sent.html"><button>Hand in</button><div style="height: 6000px"></div>
      <mo-copp-playground ${attributes} name="q" link="off" required>${poster}</mo-copp-playground></form>
      <div style="height: 3000px"></div>`,
  });
  await page.goto(`${host.address}page.html`);
  await page.waitForFunction(() => customElements.get("mo-copp-playground") !== undefined);
}

const handIn = (page: Page) => page.getByRole("button", { name: "Hand in" }).click();
const element = (page: Page) => page.locator("mo-copp-playground");
const message = (page: Page) => element(page).evaluate((node) => (node as MoCoppPlayground).validationMessage);
const isSent = (page: Page) => page.waitForURL(/sent\.html/);
/** What has the focus within the element. */
const focusIs = (page: Page, text: string) =>
  page.waitForFunction(
    (text) => document.querySelector("mo-copp-playground")?.shadowRoot?.activeElement?.textContent?.trim() === text,
    text,
  );
const isInSight = (page: Page) =>
  element(page).evaluate((node) => {
    const { top, bottom } = node.getBoundingClientRect();
    return top < innerHeight && bottom > 0;
  });

for (const [name, poster] of [
  ["nothing", ""],
  ["a poster", "<p>A question about goals.</p>"],
] as const)
  test(`a question that waits behind ${name} is loaded and pointed at when its required answer is missing`, () =>
    visit(async ({ page, requests }) => {
      await course(page, `src="goals.json" seed="7" loading="lazy"`, poster);
      await page.waitForTimeout(300);
      // Whether it is valid may be asked without having it loaded.
      assert.equal(await element(page).evaluate((node) => (node as MoCoppPlayground).checkValidity()), false);
      assert.deepEqual(
        requests.filter((one) => one.includes("goals.json")),
        [],
      );
      await handIn(page);
      await focusIs(page, "Check the answer");
      assert.equal(await isInSight(page), true);
      assert.equal(await message(page), "Check an answer to this question first: its code is what the form sends.");
      await page.locator(".choices input").first().check();
      await page.getByRole("button", { name: "Check the answer" }).click();
      await page.getByText("2 attempts left.").waitFor();
      await handIn(page);
      await isSent(page);
    }));

test("reportValidity has a question that waits drawn as well", () =>
  visit(async ({ page }) => {
    await course(page, `src="goals.json" seed="7" loading="lazy"`);
    assert.equal(await element(page).evaluate((node) => (node as MoCoppPlayground).reportValidity()), false);
    await focusIs(page, "Check the answer");
    assert.equal(await isInSight(page), true);
  }));

test("where no question is asked, that is said on the element, and the form is sent", () =>
  visit(async ({ page }) => {
    const said = "“required” is for a question, and none is asked here: a form is sent without an answer.";
    await course(page, `problem="corridor"`);
    await page.locator("mo-copp-playground[data-step]").waitFor();
    await page.getByText(said).waitFor();
    // It follows the attribute, and the document that a script gives.
    const set = (change: object) => element(page).evaluate((node, change) => void Object.assign(node, change), change);
    await set({ required: false });
    await page.getByText(said).waitFor({ state: "detached" });
    await set({ required: true });
    await page.getByText(said).waitFor();
    await set({ document: exerciseText("01-possible-goals") });
    await page.locator(".choices input").first().waitFor();
    assert.equal(await page.getByText(said).count(), 0);
    await handIn(page);
    await focusIs(page, "Check the answer");
    await set({ problem: "delivery" });
    await page.getByText(said).waitFor();
    await handIn(page);
    await isSent(page);
    await course(page, `problem="corridor" loading="lazy"`);
    await handIn(page);
    await page.getByText(said).waitFor();
    await handIn(page);
    await isSent(page);
  }));

test("where the question did not come, a required answer points at the second try, and the question follows it", () =>
  visit(
    async ({ page }) => {
      await course(page, `src="later.json" seed="7"`);
      await page.getByRole("button", { name: "Try again" }).waitFor();
      await handIn(page);
      await focusIs(page, "Try again");
      assert.equal(await isInSight(page), true);
      assert.match(
        await message(page),
        /^An answer is required here, and its question did not come\. The problem document “later\.json” could not be loaded/,
      );
      host.own.set("later.json", { body: exerciseText("01-possible-goals") });
      await page.keyboard.press("Enter");
      await page.locator(".choices input").first().waitFor();
      await handIn(page);
      await focusIs(page, "Check the answer");
      // Without a second try the place itself is pointed at.
      await course(page, `src="broken.json" loading="lazy"`);
      await handIn(page);
      await page.locator(".error p").waitFor();
      await page.waitForFunction(() =>
        /^An answer is required here, and its question did not come\. ./.test(
          document.querySelector<MoCoppPlayground>("mo-copp-playground")?.validationMessage ?? "",
        ),
      );
      await handIn(page);
      assert.equal(await isInSight(page), true);
      assert.equal(
        await element(page).evaluate((node) => node.shadowRoot?.activeElement?.getAttribute("aria-label")),
        "Question",
      );
    },
    { quiet: false },
  ));
