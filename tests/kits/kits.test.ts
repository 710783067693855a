// The author kits: each page is built by its own tool where that is to be had, and tried in a browser.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { inRoot, nodeModules } from "../../scripts/lib/paths.mjs";
import { visit } from "../page/support/browser.js";
import { startHost } from "../page/support/host.js";
import { addPage, attributes, copyOf, kit, python, ready, served } from "./support/site.js";

test("every kit has a page, and those that list the element's attributes have all of them", () => {
  for (const kit of readdirSync(inRoot("kits"))) {
    const files = readdirSync(inRoot("kits", kit));
    assert(files.includes("README.md"), kit);
    assert(
      files.some((file) => /^(page|index|slides|playground|docs)\b/.test(file)),
      `${kit} has no page`,
    );
  }
  const all = attributes().sort();
  assert(all.length >= 20 && all.includes("exercise"), all.join());
  const listed = (file: string, list: RegExp, name: RegExp) =>
    [...(list.exec(readFileSync(inRoot("kits", ...file.split("/")), "utf8"))?.[1] ?? "").matchAll(name)]
      .map(([name]) => name)
      .sort();
  assert.deepEqual(listed("quarto/mo-copp-element.lua", /known = \{([^}]*)\}/, /[a-z-]+/g), all);
  // A directive's name is docutils' own.
  assert.deepEqual(
    listed("sphinx/mo_copp.py", /ATTRIBUTES = \(([^)]*)\)/, /[a-z-]+/g),
    all.filter((name) => name !== "name"),
  );
  // The widget's own are the plan and the step; it never has the page's address.
  const ofWidget = all.filter((name) => !["plan", "step", "link"].includes(name));
  assert.deepEqual(listed("anywidget/mo_copp_widget.js", /attributes = (.*?);/s, /[a-z]+(-[a-z]+)*(?=")/g), ofWidget);
});

test("plain HTML: the page, its prose, and the playground far below", () =>
  visit(async ({ page }) => {
    const folder = copyOf("html");
    addPage(join(folder, "mo-copp"));
    await page.goto(`${await served(folder)}page.html`);
    await ready(page, '[data-step="5"]');
    assert.equal(await page.locator("#later").getAttribute("data-status"), "idle");
    await page.getByRole("link", { name: "two steps" }).click();
    await ready(page, '[data-step="2"]');
    await page.locator("#later").scrollIntoViewIfNeeded();
    await ready(page, "", "#later");
  }, kit));

test("reveal.js: an arrow key turns the slide or the step, and never both", () =>
  visit(
    async ({ page }) => {
      const folder = copyOf("reveal");
      addPage(join(folder, "mo-copp"));
      cpSync(join(nodeModules, "reveal.js", "dist"), join(folder, "reveal"), { recursive: true });
      await page.goto(`${await served(folder)}slides.html`);
      const slide = () =>
        page.evaluate(() =>
          [...document.querySelectorAll(".slides > section")].findIndex((one) => one.classList.contains("present")),
        );
      await page.waitForSelector(".reveal.ready");
      await ready(page, '[data-step="5"]');
      await page.keyboard.press("ArrowRight");
      assert.equal(await slide(), 1);
      assert.equal(await page.locator("#lab").getAttribute("data-step"), "5");
      await page.locator("#lab").getByRole("button", { name: "Back one step" }).click();
      await ready(page, '[data-step="4"]');
      await page.keyboard.press("ArrowLeft");
      await ready(page, '[data-step="3"]');
      assert.equal(await slide(), 1);
      // The help is above the slide: its keys are its own.
      await page.keyboard.press("?");
      await page.locator("dialog.help[open]").waitFor();
      await page.keyboard.press("ArrowLeft");
      await page.keyboard.press("Escape");
      await page.locator("dialog.help[open]").waitFor({ state: "detached" });
      assert.equal(await slide(), 1);
      assert.equal(await page.locator(".reveal.overview").count(), 0);
    },
    { ...kit, quiet: false },
  ));

test("Docusaurus: the component's page, and its switch", () =>
  visit(async ({ page }) => {
    const folder = copyOf("docusaurus");
    addPage(join(folder, "mo-copp"));
    // Stand-ins for React and Docusaurus, which write what the site's build would.
    writeFileSync(
      join(folder, "stand-ins.mjs"),
      `const escape = (text) => String(text).replaceAll("&", "&amp;").replaceAll('"', "&quot;");
       export const heads = [];
       export const createElement = (tag, props, ...children) => {
         const inner = children.flat().filter((child) => child != null).join("");
         if (typeof tag === "function") return tag({ ...props, children: inner });
         const given = Object.entries(props ?? {}).filter(([, value]) => value != null);
         return "<" + tag + given.map(([name, value]) => " " + name + '="' + escape(value) + '"').join("") + ">" + inner + "</" + tag + ">";
       };
       export const Head = ({ children }) => { heads.push(children); return ""; };
       export const useBaseUrl = (path) => "/site" + path;`,
    );
    const component = readFileSync(join(folder, "MoCopp.js"), "utf8")
      .replace('import Head from "@docusaurus/Head"', 'import { Head } from "./stand-ins.mjs"')
      .replace('import useBaseUrl from "@docusaurus/useBaseUrl"', 'import { useBaseUrl } from "./stand-ins.mjs"')
      .replace('from "react"', 'from "./stand-ins.mjs"');
    writeFileSync(join(folder, "component.mjs"), component);
    const { default: MoCopp } = await import(join(folder, "component.mjs"));
    const { heads } = await import(join(folder, "stand-ins.mjs"));
    const [, given = "", children = ""] =
      /<MoCopp([^>]*)>(.*?)<\/MoCopp>/s.exec(readFileSync(join(folder, "page.mdx"), "utf8")) ?? [];
    const props = Object.fromEntries([...given.matchAll(/(\S+)="([^"]*)"/g)].map(([, name, value]) => [name, value]));
    assert.equal(props.id, "lab");
    const body = MoCopp({ ...props, children });
    writeFileSync(
      join(folder, "page.html"),
      `<!doctype html><html lang="en" data-theme="dark"><title>Docs</title>${heads.join("")}${body}</html>`,
    );
    await page.goto(`${await served(folder)}page.html`);
    await ready(page, "[data-scheme=dark]");
    await page.evaluate(() => document.documentElement.setAttribute("data-theme", "light"));
    await page.waitForSelector("#lab[data-scheme=light]");
  }, kit));

test("MyST: the directive's widget, without Python and from another host", () =>
  visit(async ({ page }) => {
    const [, address = "", model = ""] =
      /^:::\{anywidget\} (\S+)\n(.*?)\n:::$/ms.exec(readFileSync(inRoot("kits", "myst", "page.md"), "utf8")) ?? [];
    const widget = readFileSync(inRoot("kits", "anywidget", "mo_copp_widget.js"));
    const [host, site] = await Promise.all([startHost({ "Access-Control-Allow-Origin": "*" }), startHost()]);
    host.own.set("mo_copp_widget.js", { body: widget, headers: { "Content-Type": "text/javascript" } });
    site.own.set("widget.js", { body: widget, headers: { "Content-Type": "text/javascript" } });
    // A stand-in for the theme: its model sends nothing back.
    const mount = (
      widget: string,
      model: object,
    ) => `<!doctype html><html lang="en"><title>Book</title><div id="out"></div>
      <script type="module">
        import widget from ${JSON.stringify(widget)};
        const values = ${JSON.stringify(model)};
        const target = new EventTarget();
        const fail = () => { throw new Error("not implemented"); };
        const el = document.createElement("div");
        document.querySelector("#out").attachShadow({ mode: "open" }).append(el);
        await widget.render({ el, model: {
          get: (name) => values[name],
          set: (name, value) => { values[name] = value; target.dispatchEvent(new CustomEvent("change:" + name)); },
          on: (name, listener) => target.addEventListener(name, listener),
          off: fail, save_changes: fail, send: fail,
        } });
      </script></html>`;
    const given = JSON.parse(model);
    const pages = [
      mount(address.replace("https://example.org/mo-copp/", host.address), given),
      // A widget that the theme has copied elsewhere is told where the script is.
      mount("./widget.js", { ...given, script: `${host.address}mo-copp-playground.js` }),
    ];
    for (const body of pages) {
      site.own.set("book.html", { body });
      await page.goto(`${site.address}book.html`);
      await ready(page, '[data-step="2"][data-scheme=dark]', "mo-copp-playground");
      await page.locator("mo-copp-playground").getByRole("button", { name: "Forward one step" }).click();
      await ready(page, '[data-step="3"]', "mo-copp-playground");
    }
  }, kit));

test("SCORM 1.2: the package, its score and what it keeps", () =>
  visit(
    async ({ page }) => {
      const folder = copyOf("scorm");
      const zip = join(folder, "course.zip");
      const built = spawnSync(process.execPath, [inRoot("kits", "scorm", "build.mjs"), zip], { encoding: "utf8" });
      assert.equal(built.status, 0, built.stderr);
      mkdirSync(join(folder, "course"));
      python(["-m", "zipfile", "-e", zip, join(folder, "course")], folder);
      const manifest = readFileSync(join(folder, "course", "imsmanifest.xml"), "utf8");
      for (const [, file = ""] of manifest.matchAll(/<file href="([^"]+)"/g))
        readFileSync(join(folder, "course", file));
      // A stand-in for the course system.
      writeFileSync(
        join(folder, "course", "system.html"),
        `<!doctype html><html lang="en"><title>Course</title><script>
          window.kept = JSON.parse(sessionStorage.kept ?? "{}");
          const API = {
            LMSInitialize: () => "true",
            LMSGetValue: (name) => window.kept[name] ?? "",
            LMSSetValue: (name, value) => { window.kept[name] = value; return "true"; },
            LMSCommit: () => { sessionStorage.kept = JSON.stringify(window.kept); return "true"; },
            LMSFinish: () => {
              if (window.kept["cmi.core.exit"] !== "suspend") delete window.kept["cmi.suspend_data"];
              delete window.kept["cmi.core.exit"];
              sessionStorage.kept = JSON.stringify(window.kept);
              return "true";
            },
          };
        </script><script>window.API = API;</script><iframe src="playground.html" title="Course" width="1200" height="900"></iframe></html>`,
      );
      await page.goto(`${await served(join(folder, "course"))}system.html`);
      const lab = page.frameLocator("iframe").locator("mo-copp-playground");
      await page.frameLocator("iframe").locator('mo-copp-playground[data-status="optimal"]').waitFor();
      await lab.getByRole("tab", { name: "Play" }).click();
      await lab.getByRole("button", { name: "Take over" }).click();
      // The plan that the solver found, walked by hand.
      for (const key of ["ArrowRight", "ArrowRight", "ArrowRight", "ArrowLeft", "ArrowUp"]) {
        await lab.locator(".walkable").press(key);
      }
      await page.waitForFunction('window.kept["cmi.core.score.raw"] === "100"');
      assert.equal(await page.evaluate('window.kept["cmi.core.lesson_status"]'), "passed");
      await page.waitForFunction('(window.kept["cmi.suspend_data"] ?? "").includes(\'"mode":"walk"\')');
      await page.reload();
      await page.frameLocator("iframe").locator('mo-copp-playground[data-step="5"]').waitFor();
      // An exercise in its place: its score, and the answer at the next visit.
      const exercise = readFileSync(inRoot("examples", "exercises", "01-possible-goals.json"), "utf8");
      writeFileSync(join(folder, "course", "exercise.json"), exercise);
      const lesson = join(folder, "course", "playground.html");
      const changed = readFileSync(lesson, "utf8").replace('problem="corridor"', 'src="exercise.json"');
      writeFileSync(lesson, changed);
      await page.evaluate("sessionStorage.clear(); window.API.LMSFinish = window.API.LMSCommit = () => 'true';");
      await page.reload();
      await lab.getByLabel("G1", { exact: true }).check();
      await lab.getByRole("button", { name: "Check the answer" }).click();
      await page.waitForFunction('window.kept["cmi.core.score.raw"] === "0"');
      assert.equal(await page.evaluate('window.kept["cmi.core.lesson_status"]'), "incomplete");
      await lab.getByLabel("G2", { exact: true }).check();
      await lab.getByRole("button", { name: "Check the answer" }).click();
      await page.waitForFunction('window.kept["cmi.core.score.raw"] === "100"');
      assert.equal(await page.evaluate('window.kept["cmi.core.lesson_status"]'), "passed");
      const code = await lab.getByLabel("Answer code").inputValue();
      await page.waitForFunction('(window.kept["cmi.suspend_data"] ?? "").includes(\'"answer"\')');
      await page.reload();
      await lab.getByLabel("Answer code").waitFor();
      assert.equal(await lab.getByLabel("Answer code").inputValue(), code);
    },
    { ...kit, quiet: false },
  ));
