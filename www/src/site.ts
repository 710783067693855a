// The page itself. What its address asks for goes to the playground as attributes, so that a frame can ask for parts:
// `index.html?problem=delivery&hide=workbench,intro`.
import "./style/site.css";
import { addressKeys } from "./element/link-address.js";
import type { MoCoppPlayground } from "./element/mo-copp-playground.js";
import { talk } from "./frame/messages.js";
import "./main.js";

const asked = new URLSearchParams(location.search);
const playground = document.querySelector<MoCoppPlayground>("mo-copp-playground");
for (const name of addressKeys) {
  const value = asked.get(name);
  if (value !== null) playground?.setAttribute(name, value);
}
const hidden = new Set((asked.get("hide") ?? "").split(/[\s,]+/));
for (const part of document.querySelectorAll<HTMLElement>("[data-page-part]")) {
  part.hidden = hidden.has(part.dataset.pagePart ?? "");
}
if (playground !== null) talk(playground);
