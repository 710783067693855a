// Pictures of what is shown: from the element by script, and saved from the page.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import type { Page } from "playwright-core";
import type { MoCoppPlayground } from "../../www/src/element/mo-copp-playground.js";
import type { SvgOptions } from "../../www/src/element/svg-options.js";
import { visit } from "./support/browser.js";
import { picture, solve } from "./support/core.js";
import { grid } from "./support/documents.js";
import { saved } from "./support/downloads.js";
import { documentOf } from "./support/gallery.js";
import { startHost } from "./support/host.js";
import { openTab, press, slider, statusIs, stepIs, useDocument } from "./support/playground.js";
import { address } from "./support/site.js";

const eightByEight = documentOf("eight-by-eight");
const best = solve(eightByEight, { solver: "exact" }).outcome.plan ?? [];
/** What `mo-copp picture` writes: `tests/pictures.rs` holds the command's core against the same file. */
const golden = readFileSync(new URL("../golden/picture.svg", import.meta.url), "utf8");

const toSVG = (page: Page, options?: SvgOptions | Record<string, unknown>): Promise<string> =>
  page.evaluate(
    (options) => (document.querySelector("mo-copp-playground") as MoCoppPlayground).toSVG(options as never),
    options,
  );

/** The same text; where it is not, only the place of the difference is told: a picture fills pages. */
function assertSame(text: string, wanted: string): void {
  const at = [...text].findIndex((sign, index) => sign !== wanted[index]);
  const around = (one: string) => one.slice(Math.max(0, at - 60), at + 60);
  assert(text === wanted, `at ${at}: ${around(text)}\nin place of ${around(wanted)}`);
}

const refused = async (page: Page, options?: unknown): Promise<string> => {
  const told = toSVG(page, options as SvgOptions).then(
    () => "a picture",
    (error: Error) => error.message,
  );
  return (await told).replace(/^page\.evaluate: Error: /, "").replace(/\n.*$/s, "");
};

const sheet = (page: Page) => page.getByRole("dialog", { name: "Save a picture" });

async function openSheet(page: Page): Promise<void> {
  await press(page, "Save picture");
  await sheet(page).getByRole("img").waitFor();
}

/** The preview is this picture. */
async function shows(page: Page, svg: string): Promise<void> {
  await page.waitForFunction(
    ([svg]) => {
      const inShadow = [...document.querySelectorAll("mo-copp-playground")].map(({ shadowRoot }) => shadowRoot);
      const images = [document, ...inShadow].map((root) =>
        root?.querySelector<HTMLImageElement>("dialog.picture-sheet img"),
      );
      const image = images.find((image) => image);
      return image?.complete && image.naturalWidth > 0 && decodeURIComponent(image.src).endsWith(svg ?? "");
    },
    [`,${svg}`],
  );
}

test("the element gives the text that the command writes", () =>
  visit(async ({ page }) => {
    await page.goto(`${address}?problem=eight-by-eight&plan=north,north,east&step=2`);
    await stepIs(page, 2);
    assertSame(await toSVG(page), golden);
    assertSame(await toSVG(page, { step: 2, theme: "light", captions: true, board: "all" }), golden);
  }));

test("the options choose steps, boards, captions and colours; several pictures at once are all drawn", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    const wanted: [SvgOptions, Parameters<typeof picture>[2]][] = [
      [{}, { step: 0 }],
      [
        { step: 3, theme: "dark" },
        { step: 3, theme: "dark" },
      ],
      [{ walk: true }, { animate: true }],
      [
        { walk: true, milliseconds: 200, captions: false },
        { animate: true, milliseconds: 200, captions: false },
      ],
      [
        { board: "adversarial", captions: false },
        { step: 0, board: "adversarial", captions: false },
      ],
    ];
    const drawn = await page.evaluate(
      (options) => {
        const element = document.querySelector("mo-copp-playground") as MoCoppPlayground;
        return Promise.all(options.map((one) => element.toSVG(one)));
      },
      wanted.map(([options]) => options),
    );
    assert.equal(drawn.length, wanted.length);
    for (const [index, [, options]] of wanted.entries())
      assertSame(drawn[index] ?? "", picture(eightByEight, best, options));
  }));

test("without a theme the colours are those that the playground has", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      assertSame(await toSVG(page), picture(eightByEight, best, { step: 0, theme: "dark" }));
      await page.evaluate(() => document.querySelector("mo-copp-playground")?.setAttribute("theme", "light"));
      assertSame(await toSVG(page), picture(eightByEight, best, { step: 0, theme: "light" }));
    },
    { colorScheme: "dark" },
  ));

test("an option that does not fit is refused with a sentence", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    assert.equal(await refused(page, { step: 99 }), "step: found 99, expected a whole number from 0 to 16");
    assert.match(await refused(page, { theme: "pink" }), /^theme: found "pink", expected light or dark/);
    assert.match(await refused(page, { size: 3 }), /^“size” is no option of a picture; expected step, walk, .*theme/);
    assert.match(await refused(page, { animate: true }), /^“animate” is no option of a picture; expected step, walk/);
    assert.equal(await refused(page, { walk: "yes" }), "“yes” can’t be used for walk; expected true or false.");
    assert.match(await refused(page, ["walk"]), /^“walk” can’t be used as options; expected an object/);
    // The playground itself is as it was.
    assert.equal(await page.getByRole("alert").textContent(), "");
    assertSame(await toSVG(page), picture(eightByEight, best, { step: 0 }));
  }));

test("it waits for the first picture, and says where there is none", () =>
  visit(
    async ({ page }) => {
      await page.goto("about:blank");
      await page.goto(address, { waitUntil: "commit" });
      await page.waitForFunction(() => customElements.get("mo-copp-playground") !== undefined);
      assert.match(await toSVG(page), /^<svg [^>]+><title>[^<]+<\/title><desc>Start, /);
      await page.goto(`${address}?src=missing.json`);
      await statusIs(page, "error");
      assert.equal(await refused(page), "There is nothing to draw.");
    },
    { quiet: false },
  ));

test("a step is saved as SVG, all steps as an animated one, under the name of problem and step", () =>
  visit(async ({ page, requests }) => {
    await statusIs(page, "optimal");
    const fetched = () => requests.filter((request) => /picture-sheet/.test(request)).length;
    assert.equal(fetched(), 0);
    await slider(page).fill("5");
    await stepIs(page, 5);
    await openSheet(page);
    assert.equal(fetched(), 1);
    const step = picture(eightByEight, best, { step: 5 });
    await shows(page, step);
    const image = sheet(page).getByRole("img", { name: /^Step 5 of 16: .+ for the enemy/ });
    assert.equal(await image.count(), 1);
    const still = await saved(page, "Step 5 as SVG");
    assert.equal(still.name, "eight-by-eight-step-5.svg");
    assertSame(still.text, step);
    await sheet(page).getByText("Saved: eight-by-eight-step-5.svg").waitFor();
    const all = await saved(page, "All 16 steps as animated SVG");
    assert.equal(all.name, "eight-by-eight-walk.svg");
    assertSame(all.text, picture(eightByEight, best, { animate: true }));
  }));

test("boards alone, without captions and in other colours, as the preview shows them", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openSheet(page);
    await sheet(page).getByLabel("Boards").selectOption({ label: "What the friend believes" });
    await sheet(page).getByLabel("Colours").selectOption({ label: "Dark" });
    await sheet(page).getByLabel("Headings, symbols and goals").uncheck();
    const wanted = picture(eightByEight, best, { step: 0, board: "cooperative", theme: "dark", captions: false });
    await shows(page, wanted);
    const { name, text } = await saved(page, "Step 0 as SVG");
    assert.equal(name, "eight-by-eight-friend-step-0.svg");
    assertSame(text, wanted);
  }));

/** How large the picture in a file is, and which of these colours it holds. */
const pixels = (page: Page, bytes: Buffer, colours: readonly string[]) =>
  page.evaluate(
    async ([data, colours]) => {
      const image = new Image();
      image.src = `data:image/png;base64,${data}`;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = canvas.getContext("2d");
      context?.drawImage(image, 0, 0);
      const all = context?.getImageData(0, 0, image.width, image.height).data ?? [];
      const found = new Set<string>();
      for (let at = 0; at < all.length; at += 4) {
        const channels = [all[at], all[at + 1], all[at + 2]].map((value = 0) => value.toString(16).padStart(2, "0"));
        found.add(`#${channels.join("")}`);
      }
      return { width: image.width, height: image.height, found: colours.filter((colour) => found.has(colour)) };
    },
    [bytes.toString("base64"), colours] as const,
  );

test("a PNG is the same picture at twice its size", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await openSheet(page);
    const { name, bytes } = await saved(page, "Step 0 as PNG");
    assert.equal(name, "eight-by-eight-step-0.png");
    const [, width, height] =
      / width="([\d.]+)" height="([\d.]+)"/.exec(picture(eightByEight, best, { step: 0 })) ?? [];
    const byScript = await page.evaluate(async () => {
      const blob = await (document.querySelector("mo-copp-playground") as MoCoppPlayground).toPNG({
        captions: true,
        theme: "light",
      });
      const address = await new Promise<string>((read) => {
        const reader = new FileReader();
        reader.onload = () => read(String(reader.result));
        reader.readAsDataURL(blob);
      });
      return { type: blob.type, bytes: address.replace(/^.*,/, "") };
    });
    assert.equal(byScript.type, "image/png");
    assert(byScript.bytes === bytes.toString("base64"), "the element gives the picture that the page saves");
    const walk = page.evaluate(() =>
      (document.querySelector("mo-copp-playground") as MoCoppPlayground)
        .toPNG({ walk: true } as never)
        .then(String, String),
    );
    assert.equal(await walk, "Error: A PNG shows one step; expected no walk. All steps are for toSVG.");
    // What the enemy and the friend believe, and walls; the last is the paper of the other theme.
    const colours = ["#f5cdb8", "#b9d9f1", "#4a505b", "#14171c"];
    assert.deepEqual(await pixels(page, bytes, colours), {
      width: 2 * Number(width),
      height: 2 * Number(height),
      found: colours.slice(0, 3),
    });
  }));

test("a walk of the person is drawn as it was walked, and while a goal is guessed there is no picture", () =>
  visit(async ({ page }) => {
    await statusIs(page, "optimal");
    await useDocument(page, grid());
    await statusIs(page, "optimal");
    await openTab(page, "Play");
    await press(page, "Take over");
    for (const [step, move] of ["north", "north"].entries()) {
      await press(page, move);
      await stepIs(page, step + 1);
    }
    assertSame(await toSVG(page), picture(grid(), ["north", "north"], { step: 2 }));
    await openSheet(page);
    const { name, text } = await saved(page, "All 2 steps as animated SVG");
    assert.equal(name, "problem-walk.svg");
    assertSame(text, picture(grid(), ["north", "north"], { animate: true }));
    await page.keyboard.press("Escape");
    await press(page, "Stop walking");
    await press(page, "Start guessing");
    await page.getByText("Which goal is it after?").waitFor();
    assert.equal(await page.getByRole("button", { name: "Save picture" }).isDisabled(), true);
    assert.match(await refused(page), /^There is no picture while a goal is being guessed/);
    // Then it is of the goal that was drawn, whichever that was.
    await page.locator(".next button").first().click();
    await page.getByText("The boards now show the whole way.").waitFor();
    const drawn = await toSVG(page);
    const secret = ["G1", "G2"].map((goal) => {
      const document = grid({ true_goal: goal });
      return picture(document, solve(document, { solver: "exact" }).outcome.plan ?? [], {});
    });
    assert(secret.includes(drawn));
    assert(secret[0] !== secret[1]);
  }));

test("by keys alone: opened, chosen, saved, closed, and back at the button", () =>
  visit(
    async ({ page }) => {
      await statusIs(page, "optimal");
      const button = page.getByRole("button", { name: "Save picture" });
      await button.focus();
      await page.keyboard.press("Enter");
      await sheet(page).getByRole("img").waitFor();
      await sheet(page).getByLabel("Boards").focus();
      await page.keyboard.press("ArrowDown");
      await shows(page, picture(eightByEight, best, { step: 0, board: "actor" }));
      await page.keyboard.press("Tab");
      await page.keyboard.press("Tab");
      await page.keyboard.press("Space");
      await shows(page, picture(eightByEight, best, { step: 0, board: "actor", captions: false }));
      await page.keyboard.press("Tab");
      const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Enter")]);
      assert.equal(download.suggestedFilename(), "eight-by-eight-agent-step-0.svg");
      await page.keyboard.press("Escape");
      await sheet(page).waitFor({ state: "detached" });
      assert(await button.evaluate((element) => element === document.activeElement));
      // Nothing of it is left, and it opens again as it did.
      assert.equal(await page.locator("body > .mo-copp-part").count(), 0);
      await openSheet(page);
      await shows(page, picture(eightByEight, best, { step: 0 }));
    },
    { viewport: { width: 390, height: 844 } },
  ));

const strict = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'";

for (const [policy, allowed] of [
  [`${strict}; img-src 'self' data:`, true],
  [`${strict}; img-src 'self'`, false],
] as const) {
  test(`in a shadow root under the policy ${policy.split("; ").at(-1)}, ${allowed ? "all is saved" : "all but PNG"}`, () =>
    visit(
      async ({ page }) => {
        const home = await startHost();
        home.own.set("lesson.html", {
          body: `<!doctype html><html lang="en"><head><link rel="icon" href="data:,"><title>Lesson</title>
            <script type="module" src="mo-copp-playground.js"></script></head><body>
            <mo-copp-playground problem="corridor" theme="dark" link="off"></mo-copp-playground></body></html>`,
          headers: { "Content-Security-Policy": policy },
        });
        await page.goto(`${home.address}lesson.html`);
        await statusIs(page, "optimal");
        const { plan } = solve(documentOf("corridor"), { solver: "exact" }).outcome;
        const wanted = picture(documentOf("corridor"), plan ?? [], { theme: "dark" });
        const last = plan?.length;
        await press(page, "Save picture");
        if (allowed) await shows(page, wanted);
        else await sheet(page).getByText("shows no preview").waitFor();
        assertSame((await saved(page, `Step ${last} as SVG`)).text, wanted);
        if (allowed) {
          const { bytes } = await saved(page, `Step ${last} as PNG`);
          assert.deepEqual((await pixels(page, bytes, ["#14171c", "#ffffff"])).found, ["#14171c"]);
        } else {
          await press(page, `Step ${last} as PNG`);
          await sheet(page).getByText("content policy allows no PNG").waitFor();
          const told = page.evaluate(() =>
            (document.querySelector("mo-copp-playground") as MoCoppPlayground).toPNG().then(String, String),
          );
          assert.match(await told, /^Error: This page’s content policy allows no PNG/);
        }
      },
      { quiet: allowed },
    ));
}

test("the sheet fits the window, and its picture the sheet", async () => {
  for (const viewport of [
    { width: 320, height: 640 },
    { width: 844, height: 390 },
    { width: 1280, height: 800 },
  ]) {
    await visit(
      async ({ page }) => {
        await statusIs(page, "optimal");
        await openSheet(page);
        const boxes = await page.evaluate(() =>
          ["dialog.picture-sheet", ".picture-sheet .preview", ".picture-sheet img"].map(
            (selector) => document.querySelector(selector)?.getBoundingClientRect().toJSON() as DOMRect,
          ),
        );
        const [dialog = assert.fail(), frame = assert.fail(), image = assert.fail()] = boxes;
        assert(dialog.left >= 0 && dialog.right <= viewport.width && dialog.bottom <= viewport.height);
        assert(
          image.bottom <= frame.bottom + 0.5 && image.right <= frame.right + 0.5 && image.height > 80,
          JSON.stringify(boxes),
        );
        const wide = await sheet(page).evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth);
        assert(wide <= 0);
      },
      { viewport },
    );
  }
});

test("its button takes no room from the problem’s title and plans", () =>
  visit(async ({ page }) => {
    await page.goto(`${address}?problem=corridor`);
    await statusIs(page, "optimal");
    await page.getByText("Past and back").waitFor();
    for (const width of [840, 1000, 1030, 1150, 1160, 1280]) {
      await page.setViewportSize({ width, height: 700 });
      const cut = await page
        .locator(".problem-bar :is(.plans button, .title, .save-picture)")
        .evaluateAll((all) =>
          all
            .filter((one) => one.scrollWidth > one.clientWidth + 1 || one.clientHeight > 45)
            .map((one) => one.outerHTML),
        );
      assert.deepEqual(cut, [], `${width}`);
      const button = (await page.getByRole("button", { name: "Save picture" }).boundingBox()) ?? assert.fail();
      assert(button.width >= 40 && button.height >= 40, `${width}: ${JSON.stringify(button)}`);
    }
  }));
