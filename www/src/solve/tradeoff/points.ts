// Points of a chart that can be chosen: with the mouse, by touch, and with the keyboard, where the arrow keys go to the
// nearest point on that side.
import { svg, type TemplateResult } from "lit";

export interface Point {
  x: number;
  y: number;
  /** Where it can be hit. */
  area: { x: number; y: number; width: number; height: number };
  name: string;
  kind: string;
  shown: boolean;
  /** The one that the tab key leads to. */
  first: boolean;
  choose: () => void;
  mark: TemplateResult;
}

export function pointView({ x, y, area, name, kind, shown, first, choose, mark }: Point): TemplateResult {
  return svg`<g class="point ${kind}" role="button" tabindex=${first ? 0 : -1} aria-pressed=${String(shown)}
    aria-label=${name} data-x=${x} data-y=${y} @click=${choose}>
    <title>${name}</title>
    <rect class="area" x=${area.x} y=${area.y} width=${area.width} height=${area.height}></rect>
    ${mark}
    ${shown ? svg`<circle class="ring" cx=${x} cy=${y} r="11"></circle>` : ""}
  </g>`;
}

const sides: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Keys on a chart of such points. */
export function pointKeys(event: KeyboardEvent): void {
  const chart = event.currentTarget as SVGElement;
  const points = [...chart.querySelectorAll<SVGGElement>(".point")];
  const at = points.indexOf(event.target as SVGGElement);
  const present = points[at];
  if (present === undefined) return;
  if (event.key === "Enter" || event.key === " ") {
    event.preventDefault();
    present.dispatchEvent(new MouseEvent("click", { bubbles: true }));
    return;
  }
  const ends: Record<string, number> = { Home: 0, End: points.length - 1 };
  const side = sides[event.key];
  const target = side === undefined ? points[ends[event.key] ?? -1] : nearest(points, present, side);
  if (target === undefined) return;
  event.preventDefault();
  // The playground's own arrow keys walk through the steps.
  event.stopPropagation();
  target.focus();
}

const place = (point: SVGGElement): [number, number] => [Number(point.dataset.x), Number(point.dataset.y)];

function nearest(points: SVGGElement[], present: SVGGElement, [toX, toY]: [number, number]): SVGGElement | undefined {
  const [x, y] = place(present);
  let best: SVGGElement | undefined;
  let least = Number.POSITIVE_INFINITY;
  for (const point of points) {
    const [dx, dy] = [place(point)[0] - x, place(point)[1] - y];
    const along = dx * toX + dy * toY;
    // What is straight ahead comes before what is aside.
    const cost = along + 3 * Math.abs(dx * toY + dy * toX);
    if (point === present || along <= 0.5 || cost >= least) continue;
    [best, least] = [point, cost];
  }
  return best;
}
