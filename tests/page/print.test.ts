// The page on paper: boards whole, nothing for a hand, colours that survive, and the table of the steps.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { type Options, visit } from "./support/browser.js";
import { solve } from "./support/core.js";
import { documentOf, entries } from "./support/gallery.js";
import { openTab, press, slider, statusIs, stepIs } from "./support/playground.js";
import { address } from "./support/site.js";

/** What A4 leaves between margins of 12 mm, in pixels. */
const sheet = { width: 702, height: 1032 };

/** What is fetched in the first pause is there: the code of the table, and on the stand-alone page the styles. */
const prepared = (page: Page) =>
  page.waitForFunction(() => {
    const alone = document.querySelector("mo-copp-playground[root=page]") !== null;
    const styled = [...document.styleSheets].some(({ href }) => /\/print-[^/]*\.css$/.test(href ?? ""));
    return (
      styled === alone &&
      performance.getEntriesByType("resource").some(({ name }) => /\/steps-table-[^/]*\.js$/.test(name))
    );
  });

async function onPaper(page: Page): Promise<void> {
  await page.emulateMedia({ media: "print" });
  await page.getByRole("heading", { name: "The steps" }).waitFor();
}

const printed = (use: (page: Page) => Promise<void>, options: Options = {}) =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      await use(page);
    },
    { viewport: sheet, ...options },
  );

/** An element in a dark page, with colours of its own for it. */
async function inDarkPage(page: Page): Promise<void> {
  await page.route(`${address}lesson/print.html`, (route) =>
    route.fulfill({
      contentType: "text/html",
      body: `<!doctype html><html lang="en"><head><title>Lesson</title>
        <style>html { color-scheme: dark } body { margin: 0; background: #111 }
          mo-copp-playground { --mo-copp-paper: #000; --mo-copp-ink: #eee; --mo-copp-enemy: #fbb }</style>
        <script type="module" src="../mo-copp-playground.js"></script></head><body>
        <mo-copp-playground problem="eight-by-eight" link="off"></mo-copp-playground></body></html>`,
    }),
  );
  await page.goto(`${address}lesson/print.html`);
  await statusIs(page, "optimal");
}

/** What the stylesheet makes of the first of each of these. */
const looks = (page: Page, selectors: readonly string[], properties: readonly string[]) =>
  page.evaluate(
    ([selectors, properties]) => {
      const root = document.querySelector("mo-copp-playground")?.shadowRoot ?? document;
      return selectors.map((selector) => {
        const part = root.querySelector(selector);
        if (part === null) throw new Error(`there is no ${selector}`);
        const style = getComputedStyle(part);
        return properties.map((property) => style.getPropertyValue(property));
      });
    },
    [selectors, properties] as const,
  );

const [ENEMY, FRIEND, INK, WHITE] = ["rgb(179, 64, 26)", "rgb(10, 98, 163)", "rgb(34, 38, 46)", "rgb(255, 255, 255)"];

for (const [place, go] of [
  ["the page in dark", async () => undefined],
  ["an element in a dark page with its own colours", inDarkPage],
] as const) {
  test(`${place} is printed dark on white, and what is told apart is told apart by lines`, () =>
    printed(
      async (page) => {
        await go(page);
        await slider(page).fill("9");
        await stepIs(page, 9);
        await prepared(page);
        await onPaper(page);
        const panels = [".panel.adversarial", ".panel.actor", ".panel.cooperative"];
        assert.deepEqual(
          await looks(page, panels, ["background-color", "border-top-color", "color", "print-color-adjust"]),
          [ENEMY, INK, FRIEND].map((colour) => [WHITE, colour, INK, "exact"]),
        );
        const believed = panels.filter((_, index) => index !== 1).map((panel) => `${panel} .floor[data-believed]`);
        assert.deepEqual((await looks(page, believed, ["stroke"])).flat(), [ENEMY, FRIEND]);
        const [[floor], [tint]] = (await looks(
          page,
          [".panel.adversarial .floor:not([data-believed])", believed[0] ?? ""],
          ["fill"],
        )) as [[string], [string]];
        assert.notEqual(floor, tint);
        const [[line] = []] = await looks(page, [".paper tr[aria-current=step]"], ["outline-style"]);
        assert.equal(line, "solid");
      },
      { colorScheme: "dark" },
    ));
}

test("nothing that is for a hand is printed", () =>
  printed(async (page) => {
    await prepared(page);
    for (const tab of ["Edit", "Play", "Steps"]) await openTab(page, tab);
    await onPaper(page);
    const hands = page.locator("mo-copp-playground :is(button, input, select, textarea, a, summary, [role=tab])");
    const left = await hands.evaluateAll((all) =>
      all
        .filter((one) => one.checkVisibility())
        .map((one) => {
          const { borderTopWidth, backgroundColor, textDecorationLine } = getComputedStyle(one);
          return [borderTopWidth, backgroundColor, textDecorationLine].join() === "0px,rgba(0, 0, 0, 0),none"
            ? "text"
            : one.outerHTML;
        }),
    );
    // Buttons that are words on the page are words on paper.
    assert.deepEqual(new Set(left), new Set(["text"]));
    for (const hidden of [".toolbar", ".workbench", ".share", ".about-page"])
      assert.equal(await page.locator(hidden).isVisible(), false, hidden);
    for (const kept of ["The paper’s gridworld", "What the enemy believes", "What the friend believes", "Step 0 of 16"])
      await page.getByText(kept).first().waitFor();
    // On the screen it is as it was.
    await page.emulateMedia({ media: "screen" });
    await page.getByRole("heading", { name: "The steps" }).waitFor({ state: "detached" });
    assert.equal(await page.locator(".workbench").isVisible(), true);
  }));

/** One of each picture, and those of most goals. */
const drawn = [
  "eight-by-eight",
  "city",
  "delivery",
  "delivery-larger",
  "box-pushing",
  "recycling-robot",
  "blocks",
  "driverlog",
];

for (const { name } of entries.filter(({ name }) => drawn.includes(name))) {
  test(`the boards stand side by side on the first sheet, whole: ${name}`, () =>
    printed(async (page) => {
      await page.goto(`${address}?problem=${name}`);
      await statusIs(page, "optimal");
      await page.locator(".panel.actor [data-board]").waitFor();
      await slider(page).fill("2");
      await stepIs(page, 2);
      await prepared(page);
      await onPaper(page);
      const { panels, torn, wide } = await page.evaluate(() => ({
        panels: [...document.querySelectorAll(".stage > .panel")].map((panel) => {
          const { top, bottom, left, right } = panel.getBoundingClientRect();
          const { breakInside } = getComputedStyle(panel);
          const boards = [...panel.querySelectorAll("[data-board], .verdict")].map((part) =>
            part.getBoundingClientRect(),
          );
          const inside = boards.every(
            (box) => box.left >= left - 1 && box.right <= right + 1 && box.bottom <= bottom + 1,
          );
          return { top, bottom, left, right, breakInside, inside, cut: panel.scrollWidth > panel.clientWidth + 1 };
        }),
        torn: [...document.querySelectorAll(".paper tr")].filter((row) => getComputedStyle(row).breakInside !== "avoid")
          .length,
        wide: document.documentElement.scrollWidth - innerWidth,
      }));
      assert.equal(panels.length, 3);
      assert.equal(new Set(panels.map(({ top }) => Math.round(top))).size, 1);
      for (const { bottom, breakInside, inside, cut } of panels) {
        assert(bottom <= sheet.height && inside && !cut, `${name}: ${JSON.stringify(panels)}`);
        assert.equal(breakInside, "avoid");
      }
      const [first, second, third] = [...panels].sort((one, other) => one.left - other.left);
      assert(first && second && third && first.right <= second.left && second.right <= third.left);
      assert.equal(torn, 0);
      assert(wide <= 0, `${wide} pixels too wide`);
    }));
}

test("in a column or a narrow box the boards are printed one below the other", () =>
  printed(async (page) => {
    for (const style of ["width: 300px", "columns: 2"]) {
      await page.route(`${address}lesson/print.html`, (route) =>
        route.fulfill({
          contentType: "text/html",
          body: `<!doctype html><html lang="en"><title>Lesson</title><script type="module" src="../mo-copp-playground.js"></script>
            <div style="${style}"><mo-copp-playground problem="corridor" link="off" hide="workbench"></mo-copp-playground></div></html>`,
        }),
      );
      await page.goto(`${address}lesson/print.html`);
      await statusIs(page, "optimal");
      await page.emulateMedia({ media: "print" });
      const widths = await page
        .locator(".panel svg.board")
        .evaluateAll((boards) => boards.map((board) => board.getBoundingClientRect().width));
      assert.equal(widths.length, 3, style);
      for (const width of widths) assert(width > 200, `${style}: ${widths}`);
      await page.emulateMedia({ media: null });
      await page.unroute(`${address}lesson/print.html`);
    }
  }));

test("a print has the table of all steps, by the time the browser lays it out", () =>
  printed(async (page) => {
    await prepared(page);
    await page.evaluate(() => {
      const playground = document.querySelector("mo-copp-playground") as Element;
      new MutationObserver(() => {
        const rows = [...document.querySelectorAll(".paper tbody tr")].map(({ textContent }) => textContent);
        if (rows.length > 0) Object.assign(window, { rows });
      }).observe(playground, { childList: true, subtree: true });
    });
    const pdf = await page.pdf({ format: "A4", preferCSSPageSize: true });
    const pages = pdf.toString("latin1").match(/\/Type\s*\/Page\b(?!s)/g)?.length;
    assert.equal(pages, 2);
    const { trace } = solve(documentOf("eight-by-eight"), { solver: "exact" });
    const rows = await page.evaluate(() => (window as unknown as { rows: string[] }).rows);
    assert.equal(rows.length, trace.steps.length);
    for (const [step, { action, symbols }] of trace.steps.entries())
      for (const word of [String(step), action ?? "start", symbols.adversarial ?? "", symbols.cooperative ?? ""])
        assert(rows[step]?.includes(word), `${rows[step]}: ${word}`);
    assert.equal(await page.locator(".paper").count(), 0);
  }));

test("what can be opened is printed where it was opened, without its triangle", () =>
  printed(async (page) => {
    await page.goto(`${address}?problem=blocks-unseen`);
    await statusIs(page, "optimal");
    const more = page.locator(".panel.adversarial details", { hasText: "More of what may be so" });
    const single = page.locator(".panel.adversarial details.single");
    for (const details of [more, single]) await details.waitFor();
    await more.locator("summary").click();
    await prepared(page);
    await onPaper(page);
    assert.deepEqual(await page.locator("summary:visible").allTextContents(), ["More of what may be so"]);
    assert.equal(await more.locator("li").first().isVisible(), true);
    assert.equal(await single.isVisible(), false);
    const marker = await more.locator("summary").evaluate((summary) => getComputedStyle(summary).listStyleType);
    assert.equal(marker, "none");
  }));

test("the headings of the steps are words: a browser repeats no button on the next sheet", () =>
  printed(async (page) => {
    await prepared(page);
    await openTab(page, "Steps");
    const headings = (table: string) => page.locator(`${table} thead th`).allTextContents();
    const onScreen = await headings(".workbench .steps");
    await onPaper(page);
    assert.equal(onScreen.length, 11);
    assert.deepEqual(await headings(".paper"), onScreen);
    assert.equal(await page.locator(".paper thead :is(button, a, svg)").count(), 0);
  }));

test("the enemy’s player prints what the enemy knows, and a part that is left out is not printed", () =>
  printed(async (page) => {
    await prepared(page);
    await openTab(page, "Play");
    await press(page, "Start guessing");
    await page.getByText("Which goal is it after?").waitFor();
    await press(page, "Forward one step");
    await onPaper(page);
    assert.equal(await page.locator(".paper tbody tr").count(), 2);
    assert.equal(await page.locator(".paper thead").getByText("The friend").count(), 0);
    await page.emulateMedia({ media: "screen" });
    await page.goto(`${address}?hide=workbench`);
    await statusIs(page, "optimal");
    await prepared(page);
    await page.emulateMedia({ media: "print" });
    await page.waitForFunction(
      () => getComputedStyle(document.querySelector(".toolbar") as Element).display === "none",
    );
    assert.equal(await page.locator(".paper").count(), 0);
  }));

/** On which pages of a PDF its links stand: object numbers of pages, by address. */
function pagesOfLinks(pdf: Buffer): Map<string, string> {
  const objects = new Map(
    [...pdf.toString("latin1").matchAll(/(\d+) 0 obj\b(.*?)\bendobj/gs)].map(([, number = "", body = ""]) => [
      number,
      body,
    ]),
  );
  const found = new Map<string, string>();
  for (const [number, body] of objects) {
    if (!/\/Type\s*\/Page\b/.test(body)) continue;
    const [, list = ""] = /\/Annots\s*\[([^\]]*)\]/.exec(body) ?? [];
    for (const [, annotation = ""] of list.matchAll(/(\d+) 0 R/g)) {
      const [, address] = /\/URI\s*\(([^)]*)\)/.exec(objects.get(annotation) ?? "") ?? [];
      if (address !== undefined) found.set(address, number);
    }
  }
  return found;
}

test("several playgrounds in a page keep their titles with their boards, and one that waits leaves no gap", () =>
  printed(async (page) => {
    const names = ["corridor", "delivery", "three-rooms", "eight-by-eight"];
    const text = (height: number) => `<p style="height: ${height}px; margin: 0">Text.</p>`;
    // Where the boards of each come to the end of a sheet.
    const body = names
      .map(
        (name) =>
          `${text(700)}<mo-copp-playground problem="${name}" link="off" hide="workbench goals"></mo-copp-playground>`,
      )
      .join("");
    const waiting = `<mo-copp-playground id="waits" loading="lazy" problem="corridor" link="off">`;
    await page.route(`${address}lesson/print.html`, (route) =>
      route.fulfill({
        contentType: "text/html",
        body: `<!doctype html><html lang="en"><title>Lesson</title><style>body { margin: 0 }</style>
          <script type="module" src="../mo-copp-playground.js"></script>${body}${text(4000)}
          ${waiting}</mo-copp-playground>${waiting.replace("waits", "poster")}<p>A picture.</p></mo-copp-playground></html>`,
      }),
    );
    await page.goto(`${address}lesson/print.html`);
    await page.waitForFunction(
      (count) => document.querySelectorAll("mo-copp-playground[data-status=optimal]").length === count,
      names.length,
    );
    assert.equal(await page.locator("#waits").getAttribute("data-status"), "idle");
    // Links are what tells in a PDF on which sheet something stands.
    await page.evaluate(() => {
      for (const [index, host] of [...document.querySelectorAll("mo-copp-playground")].entries())
        for (const [part, name] of [
          [".title", "title"],
          [".about", "about"],
          [".stage h2", "boards"],
        ] as const)
          host.shadowRoot
            ?.querySelector(part)
            ?.insertAdjacentHTML("beforeend", `<a href="https://example.org/${index}/${name}">Link</a>`);
    });
    const pages = pagesOfLinks(await page.pdf({ format: "A4", margin: { top: "12mm", bottom: "12mm" } }));
    for (const index of names.keys()) {
      const at = ["title", "about", "boards"].map((name) => pages.get(`https://example.org/${index}/${name}`));
      assert(at[0] !== undefined);
      assert.deepEqual(new Set(at).size, 1, `${names[index]}: ${at}`);
    }
    assert(new Set(pages.values()).size > 2);
    // What waited is printed as words or by its poster, and is there for the next print.
    await page.waitForSelector("#waits[data-status=optimal]");
  }));

test("a script that prints has the table at once, and one that waits tells what is missing", () =>
  printed(async (page) => {
    await prepared(page);
    // What has come is there a moment later.
    const rows = await page.waitForFunction(`(() => {
      const counted = () => document.querySelectorAll(".paper tbody tr").length;
      dispatchEvent(new Event("beforeprint"));
      const printed = counted();
      dispatchEvent(new Event("afterprint"));
      return printed > 0 && [printed, counted()];
    })()`);
    assert.deepEqual(await rows.jsonValue(), [17, 0]);
    await page.route(`${address}lesson/waits.html`, (route) =>
      route.fulfill({
        contentType: "text/html",
        body: `<!doctype html><html lang="en"><title>Lesson</title><script type="module" src="../mo-copp-playground.js"></script>
          <p style="height: 4000px">Text.</p><mo-copp-playground loading="lazy" link="off"></mo-copp-playground></html>`,
      }),
    );
    // Nothing of it comes: it is as it is in the moment of the print.
    await page.route("**/shadow-view-*.js", () => {});
    await page.goto(`${address}lesson/waits.html`);
    await page.waitForSelector("mo-copp-playground[data-status=idle]");
    await page.emulateMedia({ media: "print" });
    const { height, words } = await page.locator("mo-copp-playground").evaluate((host) => ({
      height: host.getBoundingClientRect().height,
      words: getComputedStyle(host.shadowRoot?.querySelector(".mo-copp-part") as Element, "::before").content,
    }));
    assert(height > 10 && height < 60, `${height}`);
    assert.match(words, /was not loaded when the page was printed/);
  }));
