// The npm package: what it holds, what its tools say of it, and what a program gets from it.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import {
  copyFileSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { build } from "vite";
import { exerciseFiles } from "../../scripts/exercises/files.mjs";
import { childEnvironment } from "../../scripts/lib/environment.mjs";
import { dist, nodeModules, root } from "../../scripts/lib/paths.mjs";
import { serve } from "../../scripts/lib/static-server.mjs";
import { releaseFiles } from "../../scripts/release/files.mjs";
import { buildPackage, packageFolder } from "../../scripts/release/package.mjs";
import { attributes } from "../../www/src/element/attributes.js";
import { solvers } from "../../www/src/state/form.js";
import { visit } from "./support/browser.js";
import { grid } from "./support/documents.js";

const run = (command: string, args: string[], cwd: string) =>
  spawnSync(command, args, { cwd, env: childEnvironment(), encoding: "utf8", timeout: 120_000 });

const folder = mkdtempSync(join(tmpdir(), "mo-copp-package-"));
before(async () => {
  assert.equal(await buildPackage(), 0);
  mkdirSync(join(folder, "node_modules"));
  symlinkSync(packageFolder, join(folder, "node_modules", "mo-copp"));
});
after(() => rmSync(folder, { recursive: true }));

/** Runs a module that uses the package, and gives what it printed. */
function program(text: string): string {
  writeFileSync(join(folder, "program.mjs"), text);
  const { status, stdout, stderr } = run(process.execPath, ["program.mjs"], folder);
  assert.equal(status, 0, stderr);
  assert.equal(stderr, "");
  return stdout.trim();
}

test("publint and attw find nothing wrong", () => {
  const lint = run("publint", [packageFolder, "--strict"], root);
  assert.equal(lint.status, 0, lint.stdout + lint.stderr);
  const types = run("attw", ["--pack", packageFolder, "--profile", "esm-only"], root);
  assert.equal(types.status, 0, types.stdout + types.stderr);
});

test("where there is no document, the element's modules do nothing, and the program ends", () => {
  const names = program(`
    import * as element from "mo-copp";
    import "mo-copp/single";
    console.log(Object.keys(element).join(" "));`);
  assert.equal(names, "MoCoppPlayground inside");
});

test("a document that makes no elements, as some renderers have, is as none", () => {
  for (const stub of ["{}", "{ head: {}, documentElement: {} }"]) {
    const names = program(`
      globalThis.document = ${stub};
      globalThis.window = globalThis;
      const element = await import("mo-copp");
      await import("mo-copp/single");
      console.log(Object.keys(element).join(" "));`);
    assert.equal(names, "MoCoppPlayground inside", stub);
  }
});

test("the solver solves in Node, and names what is wrong", () => {
  const told = program(`
    import { load, Problem, solve } from "mo-copp/core";
    await load();
    const outcome = await solve(${grid()});
    const nothing = await solve(undefined).catch(({ message }) => message);
    const bounded = await solve(${grid()}, { k: 2 });
    const refused = await solve({ format: "chess" }).catch((error) => error.message);
    const steps = new Problem(${JSON.stringify(grid())}).trace(outcome.plan).steps.length;
    console.log(JSON.stringify({ status: outcome.status, steps, moves: outcome.plan.length, refused, nothing, bounded: bounded.solver }));`);
  const { status, steps, moves, refused, nothing, bounded } = JSON.parse(told);
  assert.equal(status, "optimal");
  assert.equal(steps, moves + 1);
  assert.match(refused, /found "chess", expected gridworld/);
  assert.equal(nothing, "“undefined” is no problem document; expected an object or its text.");
  assert.equal(bounded, "exact");
});

test("a problem may be given as an object, and what can't be read is said in a sentence", () => {
  const told = program(`
    import { load, Problem } from "mo-copp/core";
    const why = (document) => {
      try {
        return new Problem(document).scene().format;
      } catch ({ message }) {
        return message;
      }
    };
    const early = why("{}");
    await load();
    const round = {};
    round.self = round;
    const given = [undefined, 1n, round, Symbol("s"), null, 3, ${grid()}];
    console.log(JSON.stringify([early, ...given.map(why)]));`);
  const [early, nothing, big, round, symbol, none, number, whole] = JSON.parse(told);
  assert.match(early, /not loaded yet; expected “await load/);
  assert.match(nothing, /^“undefined” is no problem document; expected/);
  for (const text of [big, round]) assert.match(text, /is no problem document; expected/);
  assert.match(symbol, /^“Symbol\(s\)” is no problem document/);
  for (const text of [none, number]) assert.match(text, /found .*expected/);
  assert.equal(whole, "gridworld");
});

test("the solver's types need no browser", () => {
  writeFileSync(
    join(folder, "solver.ts"),
    `import { load, Problem, solve, type Outcome } from "mo-copp/core";
     void load(new Uint8Array());
     // @ts-expect-error no bytes, and no address
     void load(3);
     const run = new Problem({ format: "gridworld" }).solve({ k: 2 });
     export const outcome: Promise<Outcome> = run.advance(1) ? solve("{}", { j: 1 }) : solve({}, { solver: "ip" });`,
  );
  const types = join(nodeModules, "@types");
  const options = ["--noEmit", "--strict", "--module", "nodenext", "--target", "es2022", "--lib", "es2022"];
  for (const others of [
    ["--types", "node", "--typeRoots", types],
    ["--types", ""],
    ["--types", "", "--lib", "es2022,dom"],
  ]) {
    const { status, stdout } = run("tsc", [...options, ...others, "solver.ts"], folder);
    assert.equal(status, 0, stdout);
  }
});

test("its types fit, and are those that the element has", () => {
  writeFileSync(
    join(folder, "use.ts"),
    `import { inside, MoCoppPlayground, type Answered, type ElementSolveOptions, type StepDetail, type SvgOptions } from "mo-copp";
     import { solve, type Outcome } from "mo-copp/core";
     import "mo-copp/single";
     const element = document.querySelector("mo-copp-playground");
     if (element instanceof MoCoppPlayground) {
       element.document = { format: "gridworld" };
       element.state = element.state;
       void element.goTo(2).then(() => element.ready);
       const options: SvgOptions = { walk: true, board: "actor", captions: false, theme: "dark", milliseconds: 500 };
       void element.toSVG(options).then((svg) => svg.length);
       void element.toPNG({ step: 1, true_goal: false, ended: true }).then((blob) => blob.size);
       // @ts-expect-error a PNG shows one step
       void element.toPNG({ walk: true });
       const asked: ElementSolveOptions = { encoding: "paper", horizon: "any", horizon_step: null };
       void element.solve(asked).then((answered: Answered) => answered.stats);
       const told = (event: CustomEvent<StepDetail>) => event.detail.symbols.cooperative;
       element.addEventListener("mo-copp-step", told);
       inside(element).querySelector("[data-goal]");
       void element.solve({ solver: "search", k: 2, j: null }).then(({ plan }) => plan?.length);
       // @ts-expect-error the form has no such field
       void element.solve({ cost_limit: 3 });
       element.loading = "lazy";
       element.step = 2;
       element.plan = ["north", "east"];
       element.watch = element.workerUrl === null;
       element.addEventListener("mo-copp-step", ({ detail }) => detail.goals.adversarial.length + detail.step);
       element.addEventListener("mo-copp-outcome", ({ detail }) => detail.plan?.length);
       element.addEventListener("mo-copp-answer", ({ detail }) => detail.code.length);
       window.addEventListener("mo-copp-score", ({ detail }) => detail.score.toFixed());
     }
     export const outcome: Promise<Outcome> = solve("{}");`,
  );
  const options = [
    "--noEmit",
    "--strict",
    "--module",
    "nodenext",
    "--target",
    "es2022",
    "--lib",
    "es2022,dom",
    "--types",
    "",
  ];
  const { status, stdout } = run("tsc", [...options, "use.ts"], folder);
  assert.equal(status, 0, stdout);
});

test("the manifest lists what the element follows, offers and tells, and licences of all that is bundled are there", () => {
  const { modules } = JSON.parse(readFileSync(join(packageFolder, "custom-elements.json"), "utf8"));
  const [element] = modules[0].declarations;
  const names = (list: { name: string }[]) => list.map(({ name }) => name);
  assert.equal(element.tagName, "mo-copp-playground");
  assert.deepEqual(names(element.attributes).sort(), [...attributes].sort());
  const [solver] = element.attributes.filter(({ name }: { name: string }) => name === "solver");
  assert.deepEqual(solver.type.text.match(/\w+/g).sort(), Object.keys(solvers).sort());
  const types = readFileSync(join(packageFolder, "element", "index.d.ts"), "utf8");
  for (const { name, attribute } of element.members.filter(({ reflects }: { reflects?: true }) => reflects)) {
    const found = element.attributes.find(({ fieldName }: { fieldName: string }) => fieldName === name);
    assert.equal(found?.name, attribute);
    assert.match(types, new RegExp(`^  (?:get )?${name}(?:\\(\\))?: `, "m"));
  }
  assert.equal(element.members.filter(({ reflects }: { reflects?: true }) => reflects).length, attributes.length);
  const others = element.members.filter(({ reflects }: { reflects?: true }) => !reflects);
  // What other fields of a form have, and what this element has.
  const ofFields = "checkValidity form reportValidity type validationMessage validity value willValidate".split(" ");
  const own = ["document", "goTo", "ready", "solve", "state", "toPNG", "toSVG"];
  assert.deepEqual(names(others).sort(), [...ofFields, ...own].sort());
  for (const name of ofFields) assert.match(types, new RegExp(`^  (?:readonly )?${name}(?:\\(\\))?: `, "m"));
  const told = ["mo-copp-step", "mo-copp-outcome", "mo-copp-answer", "mo-copp-score"];
  assert.deepEqual(names(element.events), [...told, "input", "change"]);
  const guide = readFileSync(new URL("../../docs/embedding.md", import.meta.url), "utf8");
  for (const { name } of [...element.cssParts, ...element.cssProperties]) assert(guide.includes(`\`${name}\``), name);
  const bundled = readFileSync(join(packageFolder, "THIRD-PARTY.txt"), "utf8");
  for (const name of ["lit-html", "@codemirror/view", "@preact/signals-core", "serde_json", "microlp", "wasm-bindgen"])
    assert(bundled.includes(`\n${name} `), name);
  for (const name of ["LICENSE-MIT", "LICENSE-APACHE", "README.md"])
    assert(existsSync(join(packageFolder, name)), name);
});

test("a release is written into one folder, with what it promises: checksums, hashes, and a crate that has all its files", async () => {
  const to = join(folder, "release");
  assert.equal(await releaseFiles(to, join(folder, "target")), 0);
  const { version } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const files = [
    ...["SHA256SUMS", "integrity.json", `mo-copp-${version}.crate`, `mo-copp-${version}.tgz`],
    ...[`mo-copp-page-${version}.tar.gz`, `mo-copp-playground.single-${version}.js`],
  ];
  assert.deepEqual(readdirSync(to).sort(), files.sort());
  const sums = readFileSync(join(to, "SHA256SUMS"), "utf8").trim().split("\n");
  const hash = (kind: string, path: string) => createHash(kind).update(readFileSync(path));
  const others = files.filter((file) => !/^(?:SHA256SUMS|integrity\.json)$/.test(file));
  const expected = others.map((file) => `${hash("sha256", join(to, file)).digest("hex")}  ${file}`);
  assert.deepEqual(sums.sort(), expected.sort());
  const integrity = JSON.parse(readFileSync(join(to, "integrity.json"), "utf8"));
  for (const file of ["mo-copp-playground.js", "mo-copp-playground.single.js"])
    assert.equal(integrity[file], `sha384-${hash("sha384", join(dist, file)).digest("base64")}`, file);
  const listed = (file: string) =>
    run("tar", ["-tzf", join(to, file)], to)
      .stdout.trim()
      .split("\n");
  assert(listed(`mo-copp-page-${version}.tar.gz`).includes("dist/index.html"), "the archive has the page");
  assert(listed(`mo-copp-${version}.tgz`).includes("package/element/index.js"), "the package has the element");
  // What the crate's own code reads when it is compiled; its tests read the repository.
  const crate = new Set(listed(`mo-copp-${version}.crate`).map((file) => file.replace(/^[^/]*\//, "")));
  for (const file of [...crate].filter((name) => /^src\/(?!.*\btests?\.rs$).*\.rs$/.test(name))) {
    const text = readFileSync(join(root, file), "utf8");
    for (const [, path = ""] of text.matchAll(/include_(?:str|bytes)!\("([^"]+)"\)/g)) {
      const read = join(dirname(file), path);
      assert(crate.has(read), `${file} reads ${read}, which the crate lacks: "include" in Cargo.toml`);
    }
  }
  for (const file of ["Cargo.lock", "README.md", "LICENSE-MIT", "LICENSE-APACHE", "src/main.rs"])
    assert(crate.has(file), `the crate has ${file}`);
});

test("the exercises are in it, as files and by import", () => {
  const files = exerciseFiles();
  assert.deepEqual(
    readdirSync(join(packageFolder, "exercises")).sort(),
    files.map(([name]) => name),
  );
  for (const [name, text] of files) assert.equal(readFileSync(join(packageFolder, "exercises", name), "utf8"), text);
  const kind = program(`
    import { createRequire } from "node:module";
    console.log(createRequire(import.meta.url)("mo-copp/exercises/01-possible-goals.json").exercise.kind);`);
  assert.equal(kind, "possible-goals");
});

test("the article is in it, with live figures and no link that leads nowhere", async () => {
  const { server, address } = await serve(packageFolder);
  try {
    await visit(async ({ page, requests }) => {
      await page.goto("about:blank");
      requests.length = 0;
      await page.goto(`${address}learn/index.html`);
      await page.locator("#figure-next-door").scrollIntoViewIfNeeded();
      await page.waitForSelector("#next-door[data-step]");
      await page.locator("#figure-belief-automaton").getByRole("button", { name: "Grow one step" }).click();
      const links = await page
        .locator("a, link")
        .evaluateAll((all) => all.map((link) => (link as HTMLAnchorElement).href));
      const own = [
        ...new Set(links.filter((link) => link.startsWith(address)).map((link) => link.split("#")[0] ?? "")),
      ];
      assert(own.length > 4, String(own));
      for (const link of own) assert.equal((await page.request.get(link)).status(), 200, link);
      assert.deepEqual(
        requests.filter((request) => !request.startsWith(address)),
        [],
      );
    });
  } finally {
    server.close();
    server.closeAllConnections();
  }
});

test("a bundler may give its files other names: every one of them is found, and the problem is solved", async () => {
  const bundled = join(folder, "bundled");
  writeFileSync(
    join(folder, "index.html"),
    `<!doctype html><title>Bundled</title><script type="module">import "mo-copp";</script>
     <mo-copp-playground><script type="application/json">${grid()}</script></mo-copp-playground>`,
  );
  await build({
    configFile: false,
    logLevel: "error",
    root: folder,
    resolve: { preserveSymlinks: true },
    build: { outDir: bundled, modulePreload: { polyfill: false }, chunkSizeWarningLimit: 5000 },
  });
  const { server, address } = await serve(bundled);
  try {
    await visit(async ({ page }) => {
      await page.goto("about:blank");
      const missing: string[] = [];
      page.on("response", (response) => {
        if (response.status() >= 400) missing.push(response.url());
      });
      const full = page.waitForResponse((response) => /mo_copp_bg.*\.wasm$/.test(response.url()));
      await page.goto(address);
      await page.waitForSelector('mo-copp-playground[data-status="optimal"]');
      // Tabs are chunks of their own.
      for (const tab of ["Edit", "Document"]) await page.getByRole("tab", { name: tab, exact: true }).click();
      await page.getByLabel("Problem document (JSON)", { exact: true }).waitFor();
      // Somebody is at work: the full core comes in a pause.
      assert.equal((await full).status(), 200);
      assert.deepEqual(missing, []);
    });
  } finally {
    server.close();
    server.closeAllConnections();
  }
});

test("a bundler that leaves files behind is helped by a copy, as the guide says, and without it they are named", async () => {
  const bundled = join(folder, "left");
  writeFileSync(join(folder, "element.js"), `import "mo-copp";`);
  const made = run("rolldown", ["element.js", "-d", bundled, "--format", "esm"], folder);
  assert.equal(made.status, 0, made.stderr);
  writeFileSync(
    join(bundled, "index.html"),
    `<!doctype html><title>Bundled</title><script type="module" src="element.js"></script>
     <mo-copp-playground><script type="application/json">${grid()}</script></mo-copp-playground>`,
  );
  const { server, address } = await serve(bundled);
  try {
    await visit(
      async ({ page }) => {
        await page.goto("about:blank");
        await page.goto(address);
        const missing = page.getByText(/could not be started: http.*solver\.worker-.*\.js was answered with 404/);
        await missing.waitFor();
        const assets = join(packageFolder, "element", "assets");
        for (const file of readdirSync(assets).filter((name) => /\.wasm$|^solver\.worker-/.test(name)))
          copyFileSync(join(assets, file), join(bundled, file));
        await page.getByRole("button", { name: "Try again" }).click();
        await page.waitForSelector('mo-copp-playground[data-status="optimal"]');
      },
      { quiet: false },
    );
  } finally {
    server.close();
    server.closeAllConnections();
  }
});
