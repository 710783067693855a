// The article: what it claims is what the core finds, its words drive its figures, and it can be read by everyone, without
// scripts and in print.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { automaton, trimmed } from "../../scripts/learn/automaton.mjs";
import { documentOf, figureNames, planOf, plansOf } from "../../scripts/learn/figures.mjs";
import { assertNoBarrier } from "./support/barriers.js";
import { type Options, visit } from "./support/browser.js";
import { assertClaim, numberWords } from "./support/claims.js";
import { replay, solve } from "./support/core.js";
import { address } from "./support/site.js";

const article = `${address}learn/index.html`;

const read = (use: (page: Page, requests: string[]) => Promise<void>, options: Options = {}) =>
  visit(async ({ page, requests }) => {
    requests.length = 0;
    await page.goto(article);
    await use(page, requests);
  }, options);

const unscripted = { javaScriptEnabled: false } as const;

/** Brings a figure near and waits for its picture. */
async function live(page: Page, name: string): Promise<void> {
  await page.locator(`#figure-${name}`).scrollIntoViewIfNeeded();
  await page.waitForSelector(`#${name}[data-step][data-status]:not([data-status="solving"])`);
}

test("every number and every claim is what the core finds", () =>
  read(async (page) => {
    const claims = await page
      .locator("[data-claim]")
      .evaluateAll((parts) => parts.map((part) => [part.getAttribute("data-claim") ?? "", part.textContent ?? ""]));
    assert(claims.length > 120, `${claims.length} claims`);
    for (const [claim = "", text = ""] of claims) assertClaim(claim, text);
  }, unscripted));

test("a claim that does not hold is found out", () => {
  for (const [claim, text] of [
    ["survivors price plan=dark of=enemy", "3"],
    ["survivors price plan=dark of=enemy", "many"],
    ["survivors price plan=dark of=enemy", "4 of 5"],
    ["difference survivors plan=swerve", "1/3"],
    ["names survivors plan=straight of=enemy", "E, N"],
    ["survivors price plan=dark of=enemy < 4", "fewer"],
    ["status price solver=satisficing k=4 j=2 = solved", "a walk"],
    ["survivors price plan=dark of=enemy; survivors price plan=dark of=friend", "4"],
    ["tells sensors of=enemy vertical=north,east horizontal=south,west = yes", "vertical for north and east"],
    ["tells sensors of=enemy vertical=north,south = yes", "vertical for north and south"],
    ["belief hidden-step plan=steps step=2 of=enemy = cells-at hidden-step places=corner", "the corners"],
    ["shape sensors plan=corner step=2 of=enemy = slanted", "a slanted line"],
    ["shape sensors plan=corner step=2 of=friend = square", "a square"],
    ["place next-door at=A = middle", "in the middle"],
    ["camera head-fake of=enemy = goal head-fake", "at its goal"],
    ["camera price of=enemy = door head-fake rooms=D1,D2", "in its door"],
    ["away head-fake plan=straight step=2 from=G = yes", "away from its goal"],
    ["camera head-fake of=enemy = ends in-sight", "in its sight"],
    ["loads delivery of=friend = 1", "counts"],
  ] as const)
    assert.throws(() => assertClaim(claim, text), `${claim}: ${text}`);
});

/** What the sensors of the figures tell. */
const symbolsTold = new Set(
  figureNames().flatMap((figure) => {
    const { observers } = JSON.parse(documentOf(figure)) as { observers: Record<string, { sensor: object }> };
    const named = (part: unknown): string[] =>
      typeof part === "object" && part !== null ? Object.values(part).flatMap(named) : [String(part)];
    return Object.values(observers).flatMap(({ sensor }) => named(sensor));
  }),
);

test("what is said of a symbol is a claim", () =>
  read(async (page) => {
    const named = await page.locator("main :is(i, em)").evaluateAll((parts) =>
      parts.map((part) => ({
        text: (part.textContent ?? "").trim(),
        claim: part.closest("[data-claim]")?.getAttribute("data-claim") ?? null,
      })),
    );
    const symbols = named.filter(({ text }) => symbolsTold.has(text));
    assert(symbols.length >= 10, `${symbols.length} symbols are named`);
    for (const { text, claim } of symbols) {
      assert(claim !== null, `“${text}” stands in no claim`);
      assert(claim.includes(`${text}=`), `the claim around “${text}” is about something else: ${claim}`);
    }
  }, unscripted));

/** Numbers that are no claim: what is counted off in the text itself, and years. */
const uncounted = [
  /Figures? \d+/g,
  /\b(?:19|20)\d\d\b/g,
  /two (?:different beliefs|heads|observers|sets|aims|beliefs|paths|numbers|counts)/gi,
  /mean of the two|both at once|next to it/g,
  /three answers to three questions|four packages/g,
  /the two\b|two counts|D1|D2|Twenty minutes|candidates − 1/g,
];

test("no number of the text is without a claim", () =>
  read(async (page) => {
    const texts: string[] = await page.evaluate(() => {
      const left =
        "[data-claim], .references, math, figure svg, details, .poster, .about, nav, script, .number, .said, svg";
      const found: string[] = [];
      for (const block of document.querySelectorAll("main :is(p, li, td, th, caption)")) {
        if (block.closest(left) !== null) continue;
        const copy = block.cloneNode(true) as Element;
        for (const part of copy.querySelectorAll(left)) part.replaceWith(" ");
        found.push((copy.textContent ?? "").replaceAll(/\s+/g, " ").trim());
      }
      return found;
    });
    assert(texts.length > 60);
    const number = new RegExp(`\\d|\\b(?:${numberWords.slice(2).join("|")})\\b`, "i");
    const bare = texts
      .map((text) => uncounted.reduce((rest, pattern) => rest.replaceAll(pattern, ""), text))
      .filter((text) => number.test(text));
    assert.deepEqual(bare, []);
  }, unscripted));

test("each figure says one thing to do and one to notice, and is numbered as the text says", () =>
  read(async (page) => {
    const figures = await page.locator("figure.lab").evaluateAll((found) =>
      found.map((figure) => ({
        id: figure.id,
        number: figure.querySelector(".number")?.textContent,
        words: [...figure.querySelectorAll("figcaption p b:first-child")].map(({ textContent }) => textContent),
      })),
    );
    assert(figures.length >= 10);
    for (const [index, { id, number, words }] of figures.entries()) {
      assert.equal(number, `Figure ${index + 1}`, id);
      assert.deepEqual(
        words.filter((word) => word?.endsWith(":")),
        ["Do:", "Notice:"],
        id,
      );
    }
    const named = await page
      .locator('main a[href^="#figure-"]')
      .evaluateAll((links) => links.map((link) => [link.textContent, link.getAttribute("href")?.slice(1)]));
    for (const [text, id] of named) {
      assert.equal(text, figures.find((figure) => figure.id === id)?.number, id ?? "");
    }
    const shown = new Set(figures.map(({ id }) => id.replace("figure-", "")));
    const unused = figureNames().filter((name) => !shown.has(name) && !["delivery-mixed", "pause"].includes(name));
    assert.deepEqual(unused, []);
  }, unscripted));

test("each link of the text that drives a figure shows the step and the plan that it names", () =>
  read(async (page) => {
    const links = page.locator("a[data-mo-copp-for]");
    const count = await links.count();
    assert(count >= 36, `${count} links`);
    for (let index = 0; index < count; index += 1) {
      const link = links.nth(index);
      const { figure, plan, step, src } = await link.evaluate((part) => ({
        figure: part.getAttribute("data-mo-copp-for") ?? "",
        plan: part.getAttribute("data-mo-copp-set-plan"),
        step: Number(part.getAttribute("data-mo-copp-set-step")),
        src: part.getAttribute("data-mo-copp-set-src"),
      }));
      await live(page, figure);
      await link.click();
      const name = src === null ? figure : src.replace("./figures/", "").replace(".json", "");
      const actions = plan ?? (await page.locator(`#${figure}`).getAttribute("plan")) ?? "";
      const trace = replay(documentOf(name), actions.split(","));
      const expected = trace.steps[step]?.goals;
      const at = `#${figure}[data-step="${step}"]`;
      await page.waitForSelector(`${at}[data-gd="${trace.goal_difference}"]`);
      await page.waitForFunction((link) => link?.getAttribute("aria-current") === "step", await link.elementHandle());
      for (const [board, alive] of Object.entries(expected ?? assert.fail())) {
        // A story of one observer has no other board.
        if ((await page.locator(`${at} .panel.${board}`).count()) === 0 && figure === "hidden-step") continue;
        const shown = page.locator(`${at} [data-board="${board}"] [data-goal][data-${board}="alive"]`);
        const names = await shown.evaluateAll((goals) => goals.map((goal) => goal.getAttribute("data-goal")));
        assert.deepEqual([...new Set(names)].sort(), [...alive].sort(), `${figure} ${actions} ${step} ${board}`);
      }
    }
  }));

test("the first figure shows one observer", () =>
  read(async (page) => {
    await live(page, "hidden-step");
    const board = (name: string) => page.locator(`#hidden-step svg[data-board="${name}"]`);
    assert.deepEqual(
      [
        await board("adversarial").isVisible(),
        await board("actor").isVisible(),
        await board("cooperative").isVisible(),
      ],
      [true, true, false],
    );
  }));

test("the first figure speaks of one observer, before goals are counted, and so does its poster", () =>
  read(async (page) => {
    const poster = (await page.locator("#hidden-step div.poster").innerHTML()).replaceAll(/src="[^"]*"/g, "");
    assert.match(poster, /What the observer believes/);
    assert(!/enemy|friend|goal/i.test(poster), poster);
    await live(page, "hidden-step");
    for (const step of [1, 3]) {
      await page.locator(`a[data-mo-copp-for="hidden-step"][data-mo-copp-set-step="${step}"]`).first().click();
      await page.waitForSelector(`#hidden-step[data-step="${step}"]`);
      const words = await page.locator("#hidden-step .stage").innerText();
      assert.match(words, /What the observer believes/);
      assert(!/enemy|friend|possible|difference/i.test(words), words);
    }
  }));

for (const [width, height, links] of [
  [1280, 800, ['[data-mo-copp-for="price"]', '[data-mo-copp-for="survivors"][data-mo-copp-set-step="1"]']],
  [390, 844, ['[data-mo-copp-for="hidden-step"]', '[data-mo-copp-for="delivery"]', '[data-mo-copp-for="price"]']],
] as const)
  test(`a figure that a sentence drives comes into sight, and there is a way back, ${width} by ${height}`, () =>
    read(
      async (page) => {
        for (const selector of links) {
          const link = page.locator(`a${selector}`).last();
          const name = (await link.getAttribute("data-mo-copp-for")) ?? "";
          await live(page, name);
          // The last line that can be seen.
          await link.evaluate((part) => part.scrollIntoView({ block: "end" }));
          await link.focus();
          await page.keyboard.press("Enter");
          const seen = () =>
            page.locator(`#${name}`).evaluate((figure) => {
              const { top, bottom, height } = figure.getBoundingClientRect();
              return (Math.min(bottom, innerHeight) - Math.max(top, 0)) / Math.min(height, innerHeight);
            });
          assert((await seen()) > 0.74, `${name}: ${await seen()}`);
          const back = page.getByRole("button", { name: "Back to the text" });
          const hidden = await link.evaluate((part) => part.getBoundingClientRect().top > innerHeight);
          if (!hidden) continue;
          await back.waitFor();
          await page.keyboard.press("Tab");
          assert(await back.evaluate((button) => document.activeElement === button));
          await page.keyboard.press("Enter");
          assert(await link.evaluate((part) => document.activeElement === part));
          const top = await link.evaluate((part) => part.getBoundingClientRect().top);
          assert(top >= 0 && top < height, `${name}: ${top}`);
          assert.equal(await back.count(), 0);
        }
      },
      { viewport: { width, height }, reducedMotion: "reduce" },
    ));

test("no letter of a formula is left to a variant that browsers pass over", () =>
  read(async (page) => {
    const variants = await page
      .locator("math [mathvariant]")
      .evaluateAll((parts) => parts.map((part) => part.getAttribute("mathvariant")));
    assert.deepEqual([...new Set(variants)], ["normal"]);
    const letters = await page.locator("math mi").allTextContents();
    for (const letter of ["𝒢", "ℬ", "𝒪", "𝒯"]) assert(letters.includes(letter), letter);
  }, unscripted));

test("no words of the drawings lie on arrows, and no walk of the table is broken word by word", () =>
  read(async (page) => {
    const covered = await page.locator(".automaton svg").evaluateAll((drawings) =>
      drawings.flatMap((drawing) => {
        const boxes = [...drawing.querySelectorAll<SVGGraphicsElement>("text.row, text.value")].map((text) => ({
          text: text.textContent,
          box: text.getBBox(),
        }));
        const arcs = [...drawing.querySelectorAll<SVGPathElement>(".arc")];
        const heads = 7;
        return boxes.filter(({ box }) =>
          arcs.some((arc) =>
            Array.from({ length: 41 }, (_, part) => arc.getPointAtLength((arc.getTotalLength() * part) / 40)).some(
              ({ x, y }) =>
                x > box.x - heads && x < box.x + box.width + heads && y > box.y && y < box.y + box.height - 2,
            ),
          ),
        );
      }),
    );
    assert.deepEqual(covered, []);
    const cut = await page.locator(".automaton svg").evaluateAll((drawings) =>
      drawings.flatMap((drawing) => {
        const { height } = (drawing as SVGSVGElement).viewBox.baseVal;
        const boxes = [...drawing.querySelectorAll<SVGGraphicsElement>("text")].map((text) => text.getBBox());
        return boxes.filter((box) => box.y < 0 || box.x < 0 || box.y + box.height > height);
      }),
    );
    assert.equal(cut.length, 0);
    const left = await page.locator(".automaton svg text.row").evaluateAll(
      (texts) =>
        texts.filter((text) => {
          const nodes = text.parentElement?.querySelectorAll<SVGGraphicsElement>(".frame") ?? [];
          const { x, width } = (text as SVGGraphicsElement).getBBox();
          return [...nodes].some((node) => node.getBBox().x < x + width);
        }).length,
    );
    assert.equal(left, 0);
    const lines = await page.locator('.beside th[scope="row"] a').evaluateAll((links) =>
      links.map((link) => ({
        words: link.textContent?.split(" ").length ?? 0,
        lines: new Set([...link.getClientRects()].map(({ top }) => Math.round(top))).size,
      })),
    );
    for (const { words, lines: count } of lines)
      assert(count <= Math.ceil(words / 2), `${words} words, ${count} lines`);
  }, unscripted));

test("in print the pictures are the light ones, and there at once", () =>
  read(
    async (page) => {
      await page.waitForLoadState("networkidle");
      await page.emulateMedia({ media: "print", colorScheme: "dark" });
      // On paper every figure may be near enough to run, and is drawn in the place of its pictures then.
      const figures = await page.locator("div.poster").evaluateAll((posters) =>
        posters.map((poster) => ({
          name: poster.parentElement?.id,
          seen: poster.checkVisibility() || poster.parentElement?.dataset.step !== undefined,
          pictures: [...poster.querySelectorAll("img")].map((image) => ({
            theme: image.className,
            there: image.complete && image.naturalWidth > 0,
            shown: image.checkVisibility(),
          })),
        })),
      );
      assert.deepEqual(
        figures.filter(({ seen }) => !seen),
        [],
      );
      const pictures = figures.flatMap(({ pictures }) => pictures);
      const light = pictures.filter(({ theme }) => theme === "light");
      assert(light.length >= 26, `${light.length} pictures`);
      assert.deepEqual(
        light.filter(({ there }) => !there),
        [],
      );
      assert.deepEqual(
        pictures.filter(({ theme, shown }) => shown && theme !== "light"),
        [],
      );
    },
    { colorScheme: "dark" },
  ));

test("the automaton grows by the keyboard and says what it has come to", () =>
  read(async (page) => {
    const figure = page.locator("#figure-belief-automaton");
    const layers = automaton("next-door", 5);
    const rows = () =>
      figure
        .locator("svg [data-row]")
        .evaluateAll((all) => all.filter((row) => !row.classList.contains("later")).length);
    const said = figure.getByRole("status");
    const on = figure.getByRole("button", { name: "Grow one step" });
    await on.focus();
    for (const [step, { plans, nodes, known }] of layers.entries()) {
      assert.equal(await rows(), step + 1);
      const text = (await said.textContent()) ?? "";
      for (const part of [`${plans} plan`, `${nodes.length} node`, `so far: ${known}.`])
        assert(text.includes(part), text);
      assert.equal(await on.getAttribute("aria-disabled"), String(step === layers.length - 1));
      await page.keyboard.press("Enter");
    }
    assert.equal(await rows(), layers.length);
    await page.keyboard.press("Shift+Tab");
    await page.keyboard.press("Enter");
    assert.equal(await rows(), layers.length - 1);
  }));

test("what is drawn of the automaton is what the core's replays lead to", () =>
  read(async (page) => {
    const layers = automaton("next-door", 5);
    const figure = page.locator("#figure-belief-automaton");
    const nodes = await figure
      .locator("[data-node]")
      .evaluateAll((all) =>
        all.map((node) => [
          node.getAttribute("data-node"),
          node.querySelectorAll(".believed.adversarial").length,
          node.querySelectorAll(".believed.cooperative").length,
          node.querySelector(".value")?.textContent ?? null,
        ]),
      );
    const expected = layers.flatMap((layer, row) =>
      layer.nodes.map(({ plan }, index) => {
        const { steps, valid } = replay(documentOf("next-door"), plan);
        const { beliefs, goals } = steps.at(-1) ?? assert.fail();
        const [enemy, friend] = [goals.adversarial.length, goals.cooperative.length];
        const value = valid ? `${enemy} − ${friend} = ${enemy - friend}` : null;
        return [`${row}.${index}`, beliefs.adversarial.length, beliefs.cooperative.length, value];
      }),
    );
    assert.deepEqual(nodes, expected);
    const arcs = await figure.locator("[data-arc]").count();
    assert.equal(
      arcs,
      layers.reduce((sum, layer) => sum + layer.arcs.length, 0),
    );
  }, unscripted));

test("the chart of pairs shows each pair where it belongs, and the table lists the same", () =>
  read(async (page) => {
    const { outcome } = solve(documentOf("price"), { solver: "exact", pairs: true });
    const chart = page.locator("svg.pairs");
    const centres = (kind: string) =>
      chart.locator(kind).evaluateAll((parts) =>
        parts.map((part) => {
          const { x, y, width, height } = (part as SVGGraphicsElement).getBBox();
          return [x + width / 2, y + height / 2] as const;
        }),
      );
    const squares = await centres(".square");
    const order = (place: 0 | 1) =>
      [...new Set(squares.map((square) => square[place]))].sort((one, other) => one - other);
    const [columns, rows] = [order(0), order(1).reverse()];
    const shown = (dots: (readonly [number, number])[]) =>
      dots.map(([x, y]) => `${rows.indexOf(y) + 1} ${columns.indexOf(x) + 1}`);
    const text = (pair: { adversarial: number; cooperative: number }) => `${pair.adversarial} ${pair.cooperative}`;
    assert.deepEqual(shown(await centres("circle")).sort(), outcome.pairs?.map(text).sort());
    assert.deepEqual(shown(await centres(".front")).sort(), outcome.front?.map(text).sort());
    const listed = await page
      .locator("tbody tr")
      .evaluateAll((all) => all.map((row) => [2, 3].map((cell) => row.children[cell]?.textContent).join(" ")));
    assert.deepEqual(listed.sort(), outcome.pairs?.map(text).sort());
  }, unscripted));

test("the unit takes the way of the plan that is chosen, to a node of its goal difference", () =>
  read(async (page) => {
    const figure = page.locator("#figure-belief-flow");
    const buttons = figure.getByRole("button");
    const layers = trimmed(automaton("next-door", 3));
    assert.equal(await buttons.count(), layers.at(-1)?.plans);
    const named = new Set(Object.values(plansOf("next-door")).map((plan) => plan.join(", ")));
    for (const button of await buttons.all()) {
      await button.click();
      const plan = (await button.textContent()) ?? "";
      assert(named.has(plan), plan);
      assert.equal(await button.getAttribute("aria-pressed"), "true");
      assert.equal(await figure.locator('[aria-pressed="true"]').count(), 1);
      const lit = await figure
        .locator(".arc.lit")
        .evaluateAll((arcs) => arcs.map((arc) => arc.getAttribute("data-arc")));
      assert.equal(lit.length, plan.split(", ").length);
      // Each arc begins where the one before ends.
      for (const [index, arc] of lit.slice(1).entries()) assert.equal(arc?.split("-")[0], lit[index]?.split("-")[1]);
      const { goals } = replay(documentOf("next-door"), plan.split(", ")).steps.at(-1) ?? assert.fail();
      const value = `${goals.adversarial.length} − ${goals.cooperative.length} = `;
      const end = figure.locator(`[data-node="${lit.at(-1)?.split("-")[1]}"] .value`);
      assert((await end.textContent())?.startsWith(value), plan);
      assert((await figure.getByRole("status").textContent())?.includes(value), plan);
    }
  }));

test("every link leads somewhere", () =>
  read(async (page) => {
    const links = await page
      .locator("a")
      .evaluateAll((all) =>
        all.map((link) => [(link as HTMLAnchorElement).href, link.getAttribute("data-mo-copp-set-src")]),
      );
    const text = await page.content();
    for (const [href = "", src] of links) {
      if (src) assert.equal((await page.request.get(new URL(src, article).href)).status(), 200, src);
      if (!href?.startsWith(address)) continue;
      const [file = "", hash] = href.split("#");
      if (file !== article) assert.equal((await page.request.get(file)).status(), 200, href);
      else if (hash) assert(text.includes(`id="${hash}"`), href);
    }
    await page.goto(address);
    await page.getByRole("contentinfo").getByRole("link", { name: "The idea, told with live figures" }).click();
    await page.waitForURL(article);
  }, unscripted));

for (const height of [500, 800])
  test(`before it is read on in a window ${height} px high, the article is at most 400 kB`, () =>
    read(
      async (page) => {
        await page.waitForLoadState("networkidle");
        const figure = await page.locator("mo-copp-playground").first().boundingBox();
        assert(figure !== null && figure.y > height, "no figure is in sight");
        assert.equal(await page.locator("mo-copp-playground[data-step]").count(), 0);
        const sizes: number[] = await page.evaluate(() =>
          [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")].map(
            (entry) => (entry as PerformanceResourceTiming).encodedBodySize,
          ),
        );
        const bytes = sizes.reduce((sum, size) => sum + size, 0);
        assert(sizes.length > 20 && bytes > 100_000, "what was loaded was measured");
        assert(bytes <= 400_000, `${bytes} bytes`);
        // Who reads on finds the first figure ready, half a window before it is in sight.
        await page.mouse.wheel(0, Math.max(1, figure.y - 1.45 * height));
        await page.locator("mo-copp-playground[data-step]").first().waitFor();
        const after = await page.locator("mo-copp-playground").first().boundingBox();
        assert(after !== null && after.y > height, "it is not in sight yet");
      },
      { viewport: { width: 1280, height } },
    ));

test("without scripts there is a picture of each figure, with words", () =>
  read(async (page) => {
    assert.equal(
      await page
        .locator("figure.lab")
        .filter({ has: page.locator(".poster, svg") })
        .count(),
      await page.locator("figure.lab").count(),
    );
    const pictures = await page.locator(".poster img").evaluateAll((images) =>
      images.map((image) => ({
        alt: (image as HTMLImageElement).alt,
        width: (image as HTMLImageElement).naturalWidth,
      })),
    );
    assert(pictures.length >= 26, `${pictures.length} pictures`);
    for (const { alt, width } of pictures) assert(alt.length > 10 && width > 0, alt);
    const [first] = await page
      .locator("#hidden-step .adversarial img")
      .evaluateAll((images) => images.map((image) => (image as HTMLImageElement).alt));
    assert.match(first ?? "", /The observer believes 4 states possible/);
    assert.equal(
      await page
        .locator(".poster")
        .evaluateAll((all) => all.filter((poster) => (poster as HTMLElement).offsetHeight === 0).length),
      0,
    );
    assert.equal(await page.locator("svg .later").count(), 0);
    assert.equal(await page.locator(".arc.lit").count(), planOf("next-door", "past-and-back").length);
  }, unscripted));

test("in print the automaton is whole and figures show their end, and after it all is as it was", () =>
  read(async (page) => {
    await live(page, "head-fake");
    await live(page, "price");
    await page.locator('a[data-mo-copp-for="price"][data-mo-copp-set-plan]').first().click();
    await page.waitForSelector('#price[data-step="7"]');
    await page.locator("#price").getByRole("button", { name: "Back one step" }).click();
    await page.waitForSelector('#price[data-step="6"]');
    const steps = () =>
      page.evaluate(() => ["head-fake", "price"].map((id) => document.getElementById(id)?.dataset.step));
    assert.deepEqual(await steps(), ["0", "6"]);
    const later = () => page.locator("svg .later").count();
    const before = await later();
    assert(before > 0);
    await page.evaluate(() => {
      addEventListener("beforeprint", () => {
        const steps = ["head-fake", "price"].map((id) => document.getElementById(id)?.dataset.step);
        document.body.dataset.printed = [document.querySelectorAll("svg .later").length, ...steps].join(" ");
        document.body.dataset.said = document.querySelector(".grows .said")?.textContent ?? "";
      });
    });
    const pdf = await page.pdf({ format: "A4" });
    assert.equal(await page.locator("body").getAttribute("data-printed"), "0 6 6");
    assert.match((await page.locator("body").getAttribute("data-said")) ?? "", /^5 steps: /);
    assert.match((await page.locator(".grows .said").textContent()) ?? "", /^Start: /);
    assert.equal(await later(), before);
    await page.waitForSelector('#head-fake[data-step="0"]');
    assert.deepEqual(await steps(), ["0", "6"]);
    const pages = pdf.toString("latin1").match(/\/Type \/Page\b/g)?.length ?? 0;
    assert(pages >= 8 && pages <= 20, `${pages} pages`);
  }));

for (const width of [1280, 320]) {
  test(`it can be read by everyone, ${width} px, light and dark`, () =>
    read(
      async (page) => {
        const wide = () => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        assert((await wide()) <= 0, `${await wide()} px too wide`);
        for (const name of ["hidden-step", "delivery", "price", "three-more"]) await live(page, name);
        assert((await wide()) <= 0, `${await wide()} px too wide with live figures`);
        await assertNoBarrier(page, "the article", { dark: true });
      },
      { viewport: { width, height: 800 } },
    ));
}

test("the keyboard comes to every link and button, and the focus shows", () =>
  read(async (page) => {
    const wanted = await page.evaluate(() => {
      const parts = [...document.querySelectorAll("a, button, summary, [tabindex='0']")].filter((part) =>
        part.checkVisibility(),
      );
      for (const [index, part] of parts.entries()) part.setAttribute("data-wanted", String(index));
      return parts.length;
    });
    const reached = new Set<string>();
    // The figures become live on the way, and have keys of their own.
    for (let presses = 0; presses < 600; presses += 1) {
      await page.keyboard.press("Tab");
      const { name, outline, light } = await page.evaluate(() => {
        let part = document.activeElement ?? document.body;
        const name = part.getAttribute("data-wanted");
        while (part.shadowRoot?.activeElement) part = part.shadowRoot.activeElement;
        const light = part === document.activeElement && part !== document.body;
        return { name, outline: getComputedStyle(part).outlineStyle, light };
      });
      if (light) assert.notEqual(outline, "none", `press ${presses}`);
      if (name === "0" && reached.size > 1) break;
      if (name !== null) reached.add(name);
    }
    const missed = await page
      .locator("[data-wanted]")
      .evaluateAll(
        (parts, names) =>
          parts
            .filter((part) => !names.includes(part.getAttribute("data-wanted") ?? ""))
            .map(({ outerHTML }) => outerHTML),
        [...reached],
      );
    assert.deepEqual(missed, []);
    assert.equal(reached.size, wanted);
  }));

test("the columns of the contents begin on one line", () =>
  read(async (page) => {
    const places = await page.locator(".contents li").evaluateAll((items) =>
      items.map((item) => {
        const { left, top } = (item.firstElementChild ?? item).getBoundingClientRect();
        return { left, top };
      }),
    );
    const tops = new Map<number, number>();
    for (const { left, top } of places) if (!tops.has(left)) tops.set(left, top);
    assert.equal(tops.size, 2, "two columns");
    assert.equal(new Set(tops.values()).size, 1, `they begin at ${[...tops.values()]}`);
  }));

test("a goal difference is written as a fraction in the text, in the pictures and in the figures", () =>
  read(async (page) => {
    const steps = await page.locator(".poster .step").allTextContents();
    assert(
      steps.some((text) => text.includes("Goal difference 1/3.")),
      "the poster of a figure says 1/3",
    );
    await live(page, "price");
    await page.locator('a[data-mo-copp-for="price"]', { hasText: "in the dark" }).click();
    await page.locator("#price .difference .value", { hasText: "1/3" }).waitFor();
    const text = (await page.locator("main :is(p, td, figcaption)").allInnerTexts()).join("\n");
    assert.deepEqual(text.match(/\b\d\.\d+\b/g) ?? [], [], "a number is written in decimals");
  }));

test("of two links to one step of different plans, the one that was followed is marked", () =>
  read(async (page) => {
    await live(page, "delivery");
    const links = page.locator('#figure-delivery a[data-mo-copp-for="delivery"]');
    for (const index of [1, 0]) {
      await links.nth(index).click();
      await page.waitForFunction(
        ([link, other]) =>
          link?.getAttribute("aria-current") === "step" && other?.hasAttribute("aria-current") === false,
        [await links.nth(index).elementHandle(), await links.nth(1 - index).elementHandle()],
      );
    }
  }));
