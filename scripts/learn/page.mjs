// The article as it is shown: its source names figures, plans and drawings, and what they stand for is put in their place.
import { automaton, pathOf, trimmed } from "./automaton.mjs";
import { drawing, flow, inWords } from "./automaton-drawing.mjs";
import { planOf } from "./figures.mjs";
import { pairsChart } from "./pairs-chart.mjs";
import { inlineDocument, planAttribute, poster } from "./posters.mjs";
import { escaped } from "./text.mjs";

const attributesOf = (tag) =>
  Object.fromEntries([...tag.matchAll(/([\w-]+)="([^"]*)"/g)].map(([, name, value]) => [name, value]));

/** What the article's figures leave out of the playground. */
const HIDDEN = "gallery share tools legend workbench goals";

/** `<figure data-figure data-plan data-step data-poster data-boards>`: a playground with its document and a poster. With `data-boards="adversarial actor"` it
 * is a story of one observer, without goals. */
function playground(attributes, files) {
  const { "data-figure": name, "data-plan": plan, "data-step": step = "0" } = attributes;
  const last = planOf(name, plan).length;
  const boards = (attributes["data-boards"] ?? "adversarial actor cooperative").split(" ");
  const picture = poster(name, plan, Number(attributes["data-poster"] ?? last), boards);
  for (const [file, text] of picture.files) files.set(file, text);
  const one = boards.length < 3;
  const kind = one ? ' class="one-observer"' : "";
  const hidden = one ? `${HIDDEN} friend counts` : HIDDEN;
  return `<mo-copp-playground id="${name}"${kind} plan="${planAttribute(name, plan)}" step="${step}" link="off" loading="lazy" hide="${hidden}">${inlineDocument(name)}${picture.html}</mo-copp-playground>`;
}

/** `<figure data-automaton data-horizon>`: the automaton, which grows; with `data-flows` the part of it that leads to the goal. */
function drawn(attributes) {
  const { "data-automaton": name, "data-horizon": horizon, "data-label": label, "data-flows": flows, id } = attributes;
  const all = automaton(name, Number(horizon));
  if (flows === undefined) {
    return `<div class="automaton grows" data-grows="${id}"><div class="wide" role="region" aria-label="${label}" tabindex="0">${drawing(id, name, all, label)}</div></div>${inWords(all)}`;
  }
  const layers = trimmed(all);
  const choices = flows.split(" ").map((plan) => ({ plan, ...flow(layers, planOf(name, plan)) }));
  const [first] = choices;
  const lit = pathOf(layers, planOf(name, first.plan));
  const data = escaped(
    JSON.stringify(choices.map(({ plan, arcs, said }) => ({ plan: planOf(name, plan).join(", "), arcs, said }))),
  );
  return `<div class="automaton flows" data-flows="${data}"><div class="wide" role="region" aria-label="${label}" tabindex="0">${drawing(id, name, layers, label, lit)}</div><p class="said" role="status">${escaped(first.said)}</p></div>${inWords(layers)}`;
}

/** Gives links of the prose the actions of the plan that they name, and the address of what they drive. */
function link(tag) {
  const { "data-mo-copp-for": name, "data-mo-copp-set-plan": plan, "data-document": document } = attributesOf(tag);
  if (plan === undefined) return tag;
  const actions = planAttribute(document ?? name, plan);
  return tag.replace(`data-mo-copp-set-plan="${plan}"`, `data-mo-copp-set-plan="${actions}"`);
}

/** The article's page, and the pictures that it shows, by file name. */
export function article(source) {
  const files = new Map();
  let captions = 0;
  const html = source
    .replaceAll(/<figure ([^>]*)>/g, (tag) => {
      const attributes = attributesOf(tag);
      const shown = attributes["data-figure"] === undefined ? drawn(attributes) : playground(attributes, files);
      const id = attributes.id ?? attributes["data-figure"];
      return `<figure class="lab" id="figure-${id}">${shown}`;
    })
    .replaceAll(/<div data-pairs="([\w-]+)">/g, (tag, name) => `${tag}${pairsChart(name)}`)
    .replaceAll(/<a [^>]*data-mo-copp-for[^>]*>/g, link)
    .replaceAll("<figcaption>", () => {
      captions += 1;
      return `<figcaption><p class="number">Figure ${captions}</p>`;
    });
  return { html, files };
}
