// The ways to load the element, each of which solves a problem: any host, any frame, no server.
import { copyFileSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { dist } from "../../scripts/lib/paths.mjs";
import { grid } from "../page/support/documents.js";
import { startHost } from "../page/support/host.js";
import { type Driver, waitFor } from "./drivers/driver.js";

const SOLVED = "[data-status=optimal][data-gd]";
const element = `<mo-copp-playground id="one" link="off"><script type="application/json">${grid()}</script></mo-copp-playground>`;
const page = (body: string) => `<!doctype html><html lang="en"><meta charset="utf-8"><title>Way</title>${body}</html>`;
const script = (address: string) =>
  address.includes("single")
    ? `<script src="${address}"></script>`
    : `<script type="module" src="${address}"></script>`;

export async function ways(driver: Driver): Promise<void> {
  const home = await startHost();
  const other = await startHost({ "Access-Control-Allow-Origin": "*" });
  const from = (host: { address: string }, file = "mo-copp-playground.js") => script(host.address + file);
  const opened = async (name: string, body: string, solved = `document.querySelector("#one${SOLVED}")`) => {
    home.own.set("way.html", { body: page(body) });
    // Each is a page of its own, and none is taken from a cache.
    await driver.open(`${home.address}way.html?${encodeURIComponent(name)}`);
    await waitFor(driver, solved, name);
  };
  await opened("the same host", from(home) + element);
  await opened("another host", from(other) + element);
  await opened("one file", from(home, "mo-copp-playground.single.js") + element);
  await opened("twice", from(home) + from(other) + from(other, "mo-copp-playground.single.js") + element);
  await opened(
    "inside of a shadow root",
    `${from(home)}<div id="host"></div><script>
      document.querySelector("#host").attachShadow({ mode: "open" }).innerHTML = ${JSON.stringify(element).replaceAll("</script", "<\\/script")};
    </script>`,
    `document.querySelector("#host").shadowRoot.querySelector("#one${SOLVED}")`,
  );
  await opened(
    "a script from a blob",
    `${element}<script type="module">
      const text = await (await fetch("mo-copp-playground.single.js")).text();
      await import(URL.createObjectURL(new Blob([text], { type: "text/javascript" })));
    </script>`,
  );
  // What is in such a frame, the page around it cannot see: the frame tells it.
  const tell = `<script>addEventListener("mo-copp-outcome", ({ detail }) => parent.postMessage(detail.status, "*"));</script>`;
  const listen = `<script>addEventListener("message", ({ data }) => { window.told = data; });</script>`;
  for (const [name, file] of [
    ["a sandboxed frame, from another host", "mo-copp-playground.js"],
    ["a sandboxed frame, one file", "mo-copp-playground.single.js"],
  ] as const) {
    const inner = page(tell + from(other, file) + element)
      .replaceAll("&", "&amp;")
      .replaceAll('"', "&quot;");
    await opened(
      name,
      `${listen}<iframe sandbox="allow-scripts" srcdoc="${inner}"></iframe>`,
      `window.told === "optimal"`,
    );
  }
  await fromDisk(driver);
}

async function fromDisk(driver: Driver): Promise<void> {
  const folder = mkdtempSync(join(tmpdir(), "mo-copp-"));
  try {
    copyFileSync(join(dist, "mo-copp-playground.single.js"), join(folder, "playground.js"));
    writeFileSync(join(folder, "page.html"), page(`<script src="playground.js"></script>${element}`));
    await driver.open(pathToFileURL(join(folder, "page.html")).href);
    await waitFor(driver, `document.querySelector("#one${SOLVED}")`, "a file from disk");
    await driver.open("about:blank");
  } finally {
    rmSync(folder, { recursive: true });
  }
}
