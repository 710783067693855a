// The belief automaton of a small problem, layer by layer: a node is a state with the beliefs of both observers, an arc an
// action. What the core's replays tell apart is a node of its own.
import { Problem } from "./core.mjs";
import { documentOf } from "./figures.mjs";

const keyOf = ({ state, beliefs }) => JSON.stringify([state, beliefs.adversarial, beliefs.cooperative]);

/**
 * The nodes that plans of each length up to `horizon` lead to. A layer counts its plans and how many nodes all layers up to
 * it have in all.
 *
 * @returns {{nodes: Node[], arcs: Arc[], plans: number, known: number}[]}
 * @typedef {{state: number[], beliefs: Record<"adversarial" | "cooperative", number[][]>,
 *   goals: Record<"adversarial" | "cooperative", string[]>, difference: number, end: boolean, plan: string[], plans: number}} Node
 * @typedef {{from: number, to: number, actions: string[]}} Arc
 */
export function automaton(name, horizon) {
  const problem = new Problem(documentOf(name));
  const node = (plan) => {
    const { steps, valid } = problem.trace(plan);
    const { state, beliefs, goals, goal_difference: difference } = steps.at(-1);
    return { state, beliefs, goals, difference, end: valid, plan, plans: 0 };
  };
  const start = { ...node([]), plans: 1 };
  const known = new Set([keyOf(start)]);
  const layers = [{ nodes: [start], arcs: [], plans: 1, known: 1 }];
  while (layers.length <= horizon) {
    const { nodes, arcs } = following(problem, layers.at(-1).nodes, node);
    for (const each of nodes) known.add(keyOf(each));
    layers.push({ nodes, arcs, plans: nodes.reduce((sum, each) => sum + each.plans, 0), known: known.size });
  }
  problem.free();
  return layers;
}

function following(problem, before, node) {
  const numbers = new Map();
  const nodes = [];
  const arcs = new Map();
  for (const [from, { plan, plans }] of before.entries()) {
    for (const { action } of problem.next(plan)) {
      const next = node([...plan, action]);
      const key = keyOf(next);
      if (!numbers.has(key)) numbers.set(key, nodes.push(next) - 1);
      const to = numbers.get(key);
      nodes[to].plans += plans;
      const arc = arcs.get(`${from} ${to}`) ?? { from, to, actions: [] };
      arc.actions.push(action);
      arcs.set(`${from} ${to}`, arc);
    }
  }
  return { nodes, arcs: [...arcs.values()] };
}

/** Without the nodes from which no plan of the horizon ends at the true goal; a layer then counts the plans that go on to it. */
export function trimmed(layers) {
  const kept = layers.map(() => new Set());
  for (let step = layers.length - 1; step >= 0; step -= 1) {
    for (const [index, { end }] of layers[step].nodes.entries()) {
      const onward = layers[step + 1]?.arcs.some(({ from, to }) => from === index && kept[step + 1].has(to));
      if (step === layers.length - 1 ? end : onward) kept[step].add(index);
    }
  }
  const number = kept.map((set) => new Map([...set].map((index, place) => [index, place])));
  return layers.map(({ nodes, arcs, known }, step) => {
    const left = [...kept[step]].map((index) => nodes[index]);
    const plans = left.reduce((sum, node) => sum + node.plans, 0);
    return {
      known,
      plans,
      nodes: left,
      arcs: arcs
        .filter(({ from, to }) => number[step - 1]?.has(from) && number[step].has(to))
        .map((arc) => ({ ...arc, from: number[step - 1].get(arc.from), to: number[step].get(arc.to) })),
    };
  });
}

/** The nodes that a plan goes through, one in each layer; null where it leaves them. */
export function pathOf(layers, plan) {
  const path = [0];
  for (const [index, action] of plan.entries()) {
    const arc = layers[index + 1]?.arcs.find(({ from, actions }) => from === path[index] && actions.includes(action));
    if (arc === undefined) return null;
    path.push(arc.to);
  }
  return path;
}
