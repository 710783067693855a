// Times the built page in headless Chromium, as a person at it would meet it:
//   node benches/page.mjs
// Needs what `npm run setup` installs and `npm run build`.
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { gzipSync } from "node:zlib";
import { chromium } from "playwright-core";
import { dist } from "../scripts/lib/paths.mjs";
import { findChromium } from "../scripts/setup/chromium.mjs";

const LOADS = 7;
const ROUNDS = 4;
/** How long a long solve is watched. */
const WATCHED_MS = 6000;
const types = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
  ".svg": "image/svg+xml",
};

/** A static host that compresses, as they do. */
const server = createServer((request, response) => {
  const path = new URL(request.url, "http://localhost").pathname;
  const file = join(dist, path.endsWith("/") ? `${path}index.html` : path);
  if (!existsSync(file)) return response.writeHead(404).end();
  const body = gzipSync(readFileSync(file), { level: 9 });
  const type = types[extname(file)] ?? "application/octet-stream";
  response.writeHead(200, { "Content-Type": type, "Content-Encoding": "gzip", "Content-Length": body.length });
  response.end(body);
});
await new Promise((done) => server.listen(0, "127.0.0.1", done));
const address = `http://127.0.0.1:${server.address().port}/`;

const browser = await chromium.launch({
  executablePath: findChromium() ?? undefined,
  args: ["--no-sandbox", "--disable-gpu"],
});

/** Runs in the page before anything else: when the first answer was drawn, tasks over 50 ms, and a clock for drags. */
function instruments() {
  window.longTasks = [];
  window.solverTimes = [];
  window.reports = 0;
  const Original = window.Worker;
  window.Worker = class extends Original {
    constructor(...args) {
      super(...args);
      this.addEventListener("message", ({ data }) => {
        if (data.kind === "progress") window.reports += 1;
        if (data.kind === "solved") solverTimes.push(data.outcome.stats.seconds * 1000);
      });
    }
  };
  new PerformanceObserver((list) => {
    for (const { duration, startTime } of list.getEntries()) longTasks.push({ duration, startTime });
  }).observe({ type: "longtask", buffered: true });
  /** Calls back after the next picture has been handed over. */
  const drawn = (then) =>
    requestAnimationFrame(() => {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => then(performance.now());
      port2.postMessage(null);
    });
  const whenSolved = (then) => {
    const element = document.querySelector("mo-copp-playground");
    const watcher = new MutationObserver(() => {
      if (element.dataset.status !== "optimal") return;
      watcher.disconnect();
      drawn(then);
    });
    watcher.observe(element, { attributes: true, attributeFilter: ["data-status"] });
  };
  window.firstDrawn = new Promise((resolve) => {
    document.addEventListener("DOMContentLoaded", () => whenSolved(resolve));
  });
  /** How long from a pointer event on a board until its optimum is drawn. */
  window.timed = (type, x, y) =>
    new Promise((resolve) => {
      const target = document.elementFromPoint(x, y);
      const begin = performance.now();
      whenSolved((now) => resolve(now - begin));
      const buttons = type === "pointerup" ? 0 : 1;
      const event = { pointerId: 1, isPrimary: true, bubbles: true, clientX: x, clientY: y, button: 0, buttons };
      target.dispatchEvent(new PointerEvent(type, event));
    });
}

async function load(options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  await page.addInitScript(instruments);
  // The page's requests and the worker's.
  const files = new Set();
  context.on("request", (request) => files.add(new URL(request.url()).pathname));
  await page.goto(address);
  return { context, page, files, first: await page.evaluate("firstDrawn") };
}

const sorted = (times) => times.slice().sort((a, b) => a - b);
const at = (times, part) => sorted(times)[Math.min(times.length - 1, Math.floor(times.length * part))];
const line = (name, figure, target) => console.log(`${name.padEnd(52)} ${figure.padStart(34)}   target ${target}`);
const ms = (value) => `${value.toFixed(1)} ms`;

async function firstLoads() {
  const times = [];
  let sizes = 0;
  let working = 0;
  let later = 0;
  let longest = 0;
  for (let count = 0; count < LOADS; count += 1) {
    const { context, page, first, files } = await load();
    times.push(first);
    sizes = transfer(files);
    longest = Math.max(longest, await longestTask(page));
    // The answer to the first problem comes with the page, the core after the picture.
    while (![...files].some((file) => file.endsWith(".wasm"))) await context.waitForEvent("request");
    working = transfer(files);
    await page.getByLabel("Solver").selectOption("ip");
    await page.getByRole("button", { name: "Solve", exact: true }).click();
    await page.getByText(/^Integer program: proved best/).waitFor();
    later = transfer(files) - working;
    await context.close();
  }
  line("first load to solved and drawn, median", ms(at(times, 0.5)), "500 ms");
  line("transfer until the first solved picture, gzipped", `${(sizes / 1000).toFixed(1)} kB`, "280 kB");
  line("  with the core that answers the first edit", `${(working / 1000).toFixed(1)} kB`, "–");
  line("  fetched later, for the first integer program", `${(later / 1000).toFixed(1)} kB`, "–");
  line("longest task while loading", overLimit(longest), "50 ms");
}

/** What these files weigh as they are sent. */
const transfer = (files) =>
  [...files].reduce((sum, file) => {
    const name = join(dist, file.endsWith("/") ? "index.html" : file);
    return sum + (existsSync(name) ? gzipSync(readFileSync(name), { level: 9 }).length : 0);
  }, 0);

/** The browser tells of tasks over 50 ms alone; 0 is none. */
const longestTask = (page) => page.evaluate("longTasks.reduce((most, { duration }) => Math.max(most, duration), 0)");
const overLimit = (longest) => (longest === 0 ? "none over 50 ms" : ms(longest));

/** Begins to edit the document as text, and waits until the core has said whether the text is right. */
async function writeDocument(page, document) {
  await page.getByRole("tab", { name: "Document" }).click();
  await page.getByLabel("Problem document (JSON)").fill(JSON.stringify(document));
  await page.waitForTimeout(WATCHED_MS);
}

async function useDocument(page, document, status = "optimal") {
  await page.getByRole("tab", { name: "Document" }).click();
  await page.getByLabel("Problem document (JSON)").fill(JSON.stringify(document));
  await useText(page, status);
}

async function useText(page, status) {
  await page.getByRole("button", { name: "Use this problem" }).click();
  await page.waitForSelector(`mo-copp-playground[data-status=${status}]`);
}

/** Watches the page's thread during solves that take long and report how far they are. */
async function longSolves(document) {
  const { context, page } = await load();
  await useDocument(page, document);
  // An enemy who knows nothing of the start: an exact search without end, which reports ten times a second.
  const walls = document.walls.map(String);
  const cells = Array.from({ length: side * side }, (_, index) => [index % side, Math.floor(index / side)]);
  const anywhere = { initial_belief: cells.filter((cell) => !walls.includes(String(cell))), ...paper.adversarial };
  const endless = {
    ...document,
    observers: { adversarial: anywhere, cooperative: { ...anywhere, ...paper.cooperative } },
  };
  const button = (name) => page.getByRole("button", { name, exact: true });
  const watch = async (name, begin) => {
    await page.evaluate("longTasks.length = reports = 0");
    await begin();
    await page.waitForTimeout(WATCHED_MS);
    const [longest, reports] = [await longestTask(page), await page.evaluate("reports")];
    if (await button("Cancel").isVisible()) await button("Cancel").click();
    await page.waitForSelector("mo-copp-playground:not([data-status=solving])");
    line(`longest task while solving: ${name}`, `${overLimit(longest)}, ${reports} reports`, "50 ms");
  };
  await writeDocument(page, endless);
  await watch("32×32, exact, everybody in doubt", () => useText(page, "solving"));
  await useDocument(page, document);
  await page.getByRole("tab", { name: "Solve", exact: true }).click();
  for (const encoding of ["belief-flow", "paper"]) {
    await page.getByLabel("Solver").selectOption("ip");
    await page.getByLabel("Encoding").selectOption(encoding);
    await watch(`32×32, ip, ${encoding}`, () => button("Solve").click());
  }
  await page.getByRole("tab", { name: "Compare", exact: true }).click();
  await watch("32×32, compare", () => button("Compare all solvers").click());
  await context.close();
}

/** Drags a goal along cells and times each. */
async function drags(name, document, goal, cells, target) {
  const { context, page } = await load();
  if (document !== null) {
    await useDocument(page, document);
    await page.getByRole("tab", { name: "Solve" }).click();
  }
  await page.evaluate("scrollTo(0, 0)");
  const middle = ([column, row]) =>
    page.locator(`[data-board=actor] [data-cell="${column},${row}"]`).evaluate((cell) => {
      const { x, y, width, height } = cell.getBoundingClientRect();
      return [x + width / 2, y + height / 2];
    });
  await page.mouse.move(...(await middle(goal)));
  await page.mouse.down();
  const points = [];
  for (const cell of cells) points.push(await middle(cell));
  const session = await context.newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  const busy = async () => {
    const { metrics } = await session.send("Performance.getMetrics");
    return metrics.find((metric) => metric.name === "TaskDuration").value * 1000;
  };
  const round = async () => {
    const times = [];
    for (const [x, y] of points) times.push(await page.evaluate(([x, y]) => timed("pointermove", x, y), [x, y]));
    return times;
  };
  await round();
  await page.evaluate("longTasks.length = solverTimes.length = 0");
  const before = await busy();
  const times = [];
  for (let count = 0; count < ROUNDS; count += 1) times.push(...(await round()));
  const cpu = (await busy()) - before;
  await page.mouse.up();
  const longest = await longestTask(page);
  const solver = await page.evaluate("solverTimes");
  line(`${name}, event to optimum drawn, median / p95`, `${ms(at(times, 0.5))} / ${ms(at(times, 0.95))}`, target);
  line("  of that the solver, median / p95", `${ms(at(solver, 0.5))} / ${ms(at(solver, 0.95))}`, "–");
  line("  processor time of the page’s thread for one move", ms(cpu / times.length), "–");
  line("  longest task on the page’s thread", overLimit(longest), "50 ms");
  await context.close();
}

const paper = {
  adversarial: { sensor: { north: "vertical", south: "vertical", east: "horizontal", west: "horizontal" } },
  cooperative: { sensor: { north: "north-east", east: "north-east", south: "south-west", west: "south-west" } },
};
const every = { sensor: { north: "north", south: "south", east: "east", west: "west" } };

/** The page's first problem, with observers who know the start: the exact search is short, so the time is the page's. */
const example = JSON.parse(readFileSync(new URL("../www/problems/eight-by-eight.json", import.meta.url), "utf8"));
const knowing = { ...example, observers: paper };

/** A grid of the largest size, with an enemy who sees every move: a short search again. */
const side = 32;
const large = {
  format: "gridworld",
  width: side,
  height: side,
  walls: Array.from({ length: side * side }, (_, index) => [index % side, Math.floor(index / side)]).filter(
    ([column, row]) => (column * 7 + row * 5) % 9 === 4,
  ),
  start: [0, 31],
  goals: [
    { name: "G1", cell: [29, 3] },
    { name: "G2", cell: [30, 28] },
    { name: "G3", cell: [4, 2] },
    { name: "G4", cell: [16, 15] },
  ],
  true_goal: "G1",
  observers: { ...paper, adversarial: every },
};
const isWall = ([column, row]) => (column * 7 + row * 5) % 9 === 4;

await firstLoads();
const row = [
  [5, 7],
  [4, 7],
  [3, 7],
  [3, 6],
  [3, 7],
  [4, 7],
  [5, 7],
  [6, 7],
];
await drags("8×8, observers who know the start", knowing, [6, 7], row, "16 / 33 ms");
await drags("8×8, the page’s example", null, [6, 7], row, "16 / 33 ms");
const around = [-2, -1, 0, 1, 2].flatMap((down) => [17, 18, 19, 20].map((column) => [column, 15 + down]));
await drags(
  "32×32",
  large,
  [16, 15],
  around.filter((cell) => !isWall(cell)),
  "100 ms",
);

await longSolves(large);

await browser.close();
server.close();
