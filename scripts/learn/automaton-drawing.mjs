// The belief automaton as SVG: a row for each number of steps, a node as two small boards (the enemy's belief and the
// friend's, with the agent's place in both), an arc as an arrow. And the same in words.
import { pathOf } from "./automaton.mjs";
import { documentOf } from "./figures.mjs";
import { escaped } from "./text.mjs";

const CELL = 17;
const PAD = 5;
/** Between the two boards of a node. */
const BETWEEN = 6;
const GAP = 12;
/** Room on the left for what a row comes to, where no arrow goes. */
const MARGIN = 84;
const LINE = 20;
/** What that takes more than a low node, above and below it. */
const TOP = 12;
/** Room for arrows between a row and the next. */
const ARROWS = 48;
/** Room for a node's value. */
const VALUE = 19;

const observers = ["adversarial", "cooperative"];
const round = (number) => Math.round(number * 10) / 10;

/** Lengths of the drawing. */
function sizes(layers, { width, height }) {
  const node = { width: 2 * width * CELL + 2 * PAD + BETWEEN, height: height * CELL + 2 * PAD };
  const most = Math.max(...layers.map(({ nodes }) => nodes.length));
  const step = node.height + VALUE + ARROWS;
  const across = MARGIN + most * node.width + (most - 1) * GAP + 4;
  return { node, across, down: layers.length * step - ARROWS + TOP + 2, step };
}

/** Top left corner of a node. */
const corner = ({ node, across, step }, row, index, count) => ({
  x: (across + MARGIN - count * node.width - (count - 1) * GAP) / 2 + index * (node.width + GAP),
  y: row * step + TOP,
});

function board(scene, { state, beliefs }, observer, left, top) {
  const place = ([column, row]) => [left + column * CELL, top + row * CELL];
  const cells = [];
  for (let row = 0; row < scene.height; row += 1) {
    for (let column = 0; column < scene.width; column += 1) {
      const [x, y] = place([column, row]);
      const believed = beliefs[observer].some((cell) => cell[0] === column && cell[1] === row);
      const kind = believed ? `believed ${observer}` : "free";
      cells.push(`<rect class="${kind}" x="${x + 0.5}" y="${y + 0.5}" width="${CELL - 1}" height="${CELL - 1}"/>`);
    }
  }
  const goals = scene.goals.map(({ name, cell }) => {
    const [x, y] = place(cell);
    return `<text class="goal" x="${x + CELL / 2}" y="${y + CELL / 2 + 4.5}">${escaped(name)}</text>`;
  });
  const [x, y] = place(state);
  return `${cells.join("")}${goals.join("")}<circle class="agent" cx="${x + CELL / 2}" cy="${y + CELL / 2}" r="${CELL / 2 - 2}"/>`;
}

/** Where the true goal holds, what the node is worth. */
const worth = ({ goals, end }) =>
  end
    ? `${goals.adversarial.length} − ${goals.cooperative.length} = ${goals.adversarial.length - goals.cooperative.length}`
    : "";

function drawnNode(scene, size, node, row, index, count) {
  const { x, y } = corner(size, row, index, count);
  const [left, top] = [x + PAD, y + PAD];
  const right = left + scene.width * CELL + BETWEEN;
  const value = node.end
    ? `<text class="value" x="${round(x + size.node.width / 2)}" y="${y + size.node.height + 16}">${worth(node)}</text>`
    : "";
  return `<g class="node" data-node="${row}.${index}"><title>${escaped(words(node))}</title><rect class="frame" x="${x}" y="${y}" width="${size.node.width}" height="${size.node.height}" rx="6"/>${board(scene, node, "adversarial", left, top)}${board(scene, node, "cooperative", right, top)}${value}</g>`;
}

function drawnArc(size, layers, row, { from, to, actions }, id) {
  const above = corner(size, row - 1, from, layers[row - 1].nodes.length);
  const below = corner(size, row, to, layers[row].nodes.length);
  const half = size.node.width / 2;
  const begin = above.y + size.node.height + (layers[row - 1].nodes[from].end ? VALUE + 2 : 2);
  const line = `M${round(above.x + half)} ${round(begin)}L${round(below.x + half)} ${round(below.y - 7)}`;
  return `<path class="arc" data-arc="${row - 1}.${from}-${row}.${to}" d="${line}" marker-end="url(#${id}-arrow)"><title>${escaped(actions.join(" or "))}</title></path>`;
}

const counted = (count, one, many) => `${count} ${count === 1 ? one : many}`;

const countsOf = ({ nodes, plans }, row) => [
  row === 0 ? "Start" : counted(row, "step", "steps"),
  counted(plans, "plan", "plans"),
  counted(nodes.length, "node", "nodes"),
];

/** What a layer comes to. */
export function said(layer, row) {
  const [steps, plans, nodes] = countsOf(layer, row);
  return `${steps}: ${plans}, ${nodes}`;
}

/** The same in the margin, beside the nodes. */
function marginal(size, layer, row) {
  const top = row * size.step + TOP + size.node.height / 2 - LINE + 5;
  const lines = countsOf(layer, row).map(
    (text, index) => `<tspan x="2" y="${round(top + index * LINE)}">${text}</tspan>`,
  );
  return `<text class="row">${lines.join(" ")}</text>`;
}

/** The drawing; `lit`: the nodes that a path goes through. */
export function drawing(id, name, layers, label, lit) {
  const scene = JSON.parse(documentOf(name));
  const size = sizes(layers, scene);
  const rows = layers.map((layer, row) => {
    const arcs = layer.arcs.map((arc) => drawnArc(size, layers, row, arc, id)).join("");
    const nodes = layer.nodes
      .map((node, index) => drawnNode(scene, size, node, row, index, layer.nodes.length))
      .join("");
    const title = marginal(size, layer, row);
    const down = round((row + 1) * size.step - ARROWS + TOP + 2);
    return `<g data-row="${row}" data-said="${said(layer, row)}" data-known="${layer.known}" data-down="${down}">${arcs}${title}${nodes}</g>`;
  });
  const arrow = `<defs><marker id="${id}-arrow" viewBox="0 0 8 8" refX="6" refY="4" markerWidth="7" markerHeight="7" orient="auto"><path class="head" d="M0 0L8 4L0 8z"/></marker></defs>`;
  const svg = `<svg viewBox="0 0 ${round(size.across)} ${round(size.down)}" role="img" aria-label="${escaped(label)}">${arrow}${rows.join("")}</svg>`;
  return lit === undefined
    ? svg
    : arcsOf(lit).reduce(
        (text, arc) => text.replace(`class="arc" data-arc="${arc}"`, `class="arc lit" data-arc="${arc}"`),
        svg,
      );
}

/** The arcs of a path of nodes. */
export const arcsOf = (path) => path.slice(1).map((to, row) => `${row}.${path[row]}-${row + 1}.${to}`);

/** A cell as the page and the core name it. */
const place = ([column, row]) => `column ${column}, row ${row}`;
const set = (cells) => cells.map(place).join("; ");

function words(node) {
  const [enemy, friend] = observers.map((observer) => set(node.beliefs[observer]));
  const value = node.end ? ` Worth ${worth(node)}.` : "";
  return `The agent is in ${place(node.state)}. The enemy believes ${enemy}. The friend believes ${friend}.${value}`;
}

/** The automaton as lists, for readers who do not see it. */
export function inWords(layers) {
  const items = layers.map((layer, row) => {
    const nodes = layer.nodes.map((node, index) => {
      const onward = (layers[row + 1]?.arcs ?? [])
        .filter(({ from }) => from === index)
        .map(({ to, actions }) => `${actions.join(" or ")} to node ${to + 1}`);
      const then = onward.length === 0 ? "" : ` Then ${onward.join(", ")}.`;
      return `<li>${words(node)}${then}</li>`;
    });
    return `<li>${said(layer, row)}<ol>${nodes.join("")}</ol></li>`;
  });
  return `<details><summary>The drawing in words</summary><p>Columns count from the left, rows from the top, both from 0.</p><ul>${items.join("")}</ul></details>`;
}

/** What a plan's flow comes to: its arcs, and a sentence. */
export function flow(layers, plan) {
  const path = pathOf(layers, plan);
  if (path === null) throw new Error(`${plan.join(", ")} leaves the drawing`);
  const last = layers[path.length - 1].nodes[path.at(-1)];
  return { arcs: arcsOf(path), said: `${plan.join(", ")}: the unit arrives at a node worth ${worth(last)}.` };
}
