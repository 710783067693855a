// The article: what its own drawings do. The playgrounds in it come with `embed.ts`.
import type { MoCoppPlayground } from "./element/mo-copp-playground.js";
import { flows } from "./learn/flows.js";
import { grows } from "./learn/grows.js";
import { printEnds } from "./learn/print.js";
import { waysBack } from "./learn/ways-back.js";

for (const drawing of document.querySelectorAll<HTMLElement>("[data-grows]")) grows(drawing);
for (const drawing of document.querySelectorAll<HTMLElement>("[data-flows]")) flows(drawing);
waysBack();
printEnds(document.querySelectorAll<MoCoppPlayground>("mo-copp-playground"));
