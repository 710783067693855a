// The cells of a document that has some: how many, and what is in them.

export interface Floor {
  width: number;
  height: number;
  /** What stands in a cell, by `column,row`: a sign for the eye and a word. */
  marks: ReadonlyMap<string, { sign: string; word: string }[]>;
}

/** Signs of what is in a cell at first. */
export const signs = { start: "S", box: "□", can: "▯", charger: "ϟ" };

interface Cells {
  width?: number;
  height?: number;
  walls?: number[][];
  start?: number[] | { robot: number[]; box?: number[]; can?: number[] | "held" };
  charger?: number[];
  goals?: { name: string; cell?: number[] }[];
}

export function floorOf(document: object): Floor | null {
  const { width, height, walls = [], start, charger, goals = [] } = document as Cells;
  if (width === undefined || height === undefined) return null;
  const marks = new Map<string, { sign: string; word: string }[]>();
  const put = (cell: number[], sign: string, word: string) =>
    marks.set(String(cell), [...(marks.get(String(cell)) ?? []), { sign, word }]);
  for (const wall of walls) put(wall, "", "wall");
  if (Array.isArray(start)) put(start, signs.start, "the start");
  else if (start !== undefined) {
    put(start.robot, signs.start, "the start of the robot");
    if (start.box !== undefined) put(start.box, signs.box, "where the box begins");
    if (Array.isArray(start.can)) put(start.can, signs.can, "where the can begins");
  }
  if (charger !== undefined) put(charger, signs.charger, "the charger");
  for (const { name, cell } of goals) if (cell !== undefined) put(cell, name, `the goal ${name}`);
  return { width, height, marks };
}
