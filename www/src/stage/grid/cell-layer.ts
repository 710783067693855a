// The cells of a board. A large board has a thousand of them, and few change from one picture to the next: they are
// made once for a size, and then only what changes is touched.
import { noChange } from "lit";
import { Directive, directive, type ElementPart, type PartInfo, PartType } from "lit/directive.js";
import { times } from "../../problem/times.js";
import { type Cell, keyOf } from "./cells.js";

export interface CellsDrawn {
  width: number;
  height: number;
  walls: readonly Cell[];
  /** The keys of the cells in which this board's observer believes the agent may be. */
  believed: ReadonlySet<string>;
}

interface Drawn {
  rect: SVGRectElement;
  key: string;
  wall: boolean;
  believed: boolean;
}

const NAMESPACE = "http://www.w3.org/2000/svg";

class CellLayer extends Directive {
  private cells: Drawn[] = [];
  private width = 0;
  private height = 0;

  constructor(part: PartInfo) {
    super(part);
    if (part.type !== PartType.ELEMENT) throw new Error("cells belong in an element");
  }

  render(_drawn: CellsDrawn): typeof noChange {
    return noChange;
  }

  override update(part: ElementPart, [drawn]: [CellsDrawn]): typeof noChange {
    if (drawn.width !== this.width || drawn.height !== this.height) this.make(part.element, drawn);
    const walls = new Set(drawn.walls.map(keyOf));
    for (const cell of this.cells) {
      const wall = walls.has(cell.key);
      const believed = drawn.believed.has(cell.key);
      if (wall !== cell.wall) cell.rect.setAttribute("class", wall ? "wall" : "floor");
      if (believed !== cell.believed) cell.rect.toggleAttribute("data-believed", believed);
      cell.wall = wall;
      cell.believed = believed;
    }
    return noChange;
  }

  private make(layer: Element, { width, height }: CellsDrawn): void {
    this.width = width;
    this.height = height;
    // What all cells share is written once: copying is faster than writing it a thousand times.
    const pattern = document.createElementNS(NAMESPACE, "rect");
    const shared = { class: "floor", width: 0.94, height: 0.94, rx: 0.13 };
    for (const [name, value] of Object.entries(shared)) pattern.setAttribute(name, String(value));
    this.cells = times(width * height, (index) => {
      const [column, row] = [index % width, Math.floor(index / width)];
      const rect = pattern.cloneNode() as SVGRectElement;
      const key = keyOf([column, row]);
      rect.setAttribute("data-cell", key);
      rect.setAttribute("x", String(column + 0.03));
      rect.setAttribute("y", String(row + 0.03));
      return { rect, key, wall: false, believed: false };
    });
    layer.replaceChildren(...this.cells.map(({ rect }) => rect));
  }
}

/** `<g ${cellLayer({...})}></g>` */
export const cellLayer = directive(CellLayer);
