// The comparison as a file: a row for each solver, with what it was asked for and what it answered.
import type { Gallery } from "../../gallery/gallery.js";
import type { Comparison, Row } from "../../state/comparison.js";
import type { Cell } from "../../view/csv.js";
import type { Table } from "../../view/save-table.js";

interface Stores {
  comparison: Comparison;
  gallery: Gallery;
}

const HEAD = [
  "solver",
  "encoding",
  "k",
  "j",
  "horizon",
  "state",
  "status",
  "goal difference",
  "enemy goals",
  "friend goals",
];

export const comparisonFile = ({ comparison, gallery }: Stores): Table => ({
  name: `${gallery.fileName.value}-comparison`,
  rows: () => [[...HEAD, "moves", "seconds", "ended", "plan"], ...comparison.rows.value.map(cells)],
  json: () => comparison.rows.value.map(record),
});

function cells({ entrant, state, result, ended, seconds }: Row): Cell[] {
  const { options, outcome } = result ?? {};
  return [
    entrant.chosen.solver,
    entrant.chosen.encoding ?? null,
    options?.k ?? null,
    options?.j ?? null,
    options?.horizon ?? null,
    state,
    outcome?.status ?? null,
    outcome?.goal_difference ?? null,
    outcome?.goals?.adversarial.length ?? null,
    outcome?.goals?.cooperative.length ?? null,
    outcome?.plan?.length ?? null,
    seconds ?? null,
    ended ?? null,
    outcome?.plan?.join(" ") ?? null,
  ];
}

/** `outcome` is as the command's `solve --json` prints it. */
function record({ entrant, state, result, ended, seconds, message }: Row): unknown {
  const { title, chosen } = entrant;
  return { title, state, options: result?.options ?? chosen, outcome: result?.outcome, seconds, ended, message };
}
