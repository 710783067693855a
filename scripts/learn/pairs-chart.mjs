// The reachable pairs of survivor counts as a chart: the friend's count across, the enemy's upwards, the Pareto front as a line.
import { Problem } from "./core.mjs";
import { documentOf } from "./figures.mjs";

const UNIT = 52;
const [LEFT, TOP, BOTTOM] = [64, 16, 46];

/** All pairs that plans can end with, and those of the Pareto front. */
export function pairsOf(name) {
  const run = new Problem(documentOf(name)).solve({ solver: "exact", pairs: true });
  while (!run.advance(10_000));
  const { pairs, front } = run.outcome();
  return { pairs, front };
}

/** The chart as SVG. */
export function pairsChart(name) {
  const { pairs, front } = pairsOf(name);
  const goals = JSON.parse(documentOf(name)).goals.length;
  const side = goals * UNIT;
  const at = ({ adversarial, cooperative }) => [
    LEFT + (cooperative - 0.5) * UNIT,
    TOP + side - (adversarial - 0.5) * UNIT,
  ];
  const counts = Array.from({ length: goals }, (_, index) => index + 1);
  const grid = counts.flatMap((column) =>
    counts.map((row) => {
      const [x, y] = at({ adversarial: row, cooperative: column });
      return `<rect class="square" x="${x - UNIT / 2 + 1}" y="${y - UNIT / 2 + 1}" width="${UNIT - 2}" height="${UNIT - 2}"/>`;
    }),
  );
  const numbers = counts.flatMap((count) => [
    `<text x="${at({ adversarial: 1, cooperative: count })[0]}" y="${TOP + side + 18}">${count}</text>`,
    `<text x="${LEFT - 12}" y="${at({ adversarial: count, cooperative: 1 })[1] + 5}">${count}</text>`,
  ]);
  const among = (pair) =>
    front.some(({ adversarial, cooperative }) => adversarial === pair.adversarial && cooperative === pair.cooperative);
  const line = front.map((pair) => at(pair).join(" ")).join("L");
  const dots = pairs.map((pair) => {
    const [x, y] = at(pair);
    return `<circle class="${among(pair) ? "front" : "dominated"}" cx="${x}" cy="${y}" r="9"/>`;
  });
  const words = pairs.map((pair) => {
    const { adversarial, cooperative } = pair;
    return `${adversarial} for the enemy and ${cooperative} for the friend${among(pair) ? "" : " (dominated)"}`;
  });
  const middle = TOP + side / 2;
  return `<svg class="pairs" viewBox="0 0 ${LEFT + side + 8} ${TOP + side + BOTTOM}" role="img" aria-label="Pairs that walks can end with: ${words.join("; ")}.">${grid.join("")}<path class="line" d="M${line}"/>${dots.join("")}${numbers.join("")}<text x="${LEFT + side / 2}" y="${TOP + side + 40}">goals for the friend</text><text transform="rotate(-90 22 ${middle})" x="22" y="${middle}">goals for the enemy</text></svg>`;
}
