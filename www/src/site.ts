// The page itself. What its address asks for goes to the playground as attributes, so that a frame can ask for parts:
// `index.html?problem=delivery&hide=workbench,intro`.
import "./style/site.css";
import { settingNames } from "./element/settings.js";
import "./main.js";

const asked = new URLSearchParams(location.search);
const playground = document.querySelector("mo-copp-playground");
for (const name of [...settingNames, "hide"]) {
  const value = asked.get(name);
  if (value !== null) playground?.setAttribute(name, value);
}
const hidden = new Set((asked.get("hide") ?? "").split(/[\s,]+/));
for (const part of document.querySelectorAll<HTMLElement>("[data-page-part]")) {
  part.hidden = hidden.has(part.dataset.pagePart ?? "");
}
