// The cells of a document that has some: how many, and what is in them.

export interface Floor {
  width: number;
  height: number;
  /** What stands in a cell, by `column,row`: a sign for the eye and a word. */
  marks: ReadonlyMap<string, { sign: string; word: string }[]>;
}

interface Cells {
  width?: number;
  height?: number;
  walls?: number[][];
  start?: number[] | { robot: number[] };
  goals?: { name: string; cell?: number[] }[];
}

export function floorOf(document: object): Floor | null {
  const { width, height, walls = [], start, goals = [] } = document as Cells;
  if (width === undefined || height === undefined) return null;
  const marks = new Map<string, { sign: string; word: string }[]>();
  const put = (cell: number[], sign: string, word: string) =>
    marks.set(String(cell), [...(marks.get(String(cell)) ?? []), { sign, word }]);
  for (const wall of walls) put(wall, "", "wall");
  if (start !== undefined) put(Array.isArray(start) ? start : start.robot, "S", "the start");
  for (const { name, cell } of goals) if (cell !== undefined) put(cell, name, `the goal ${name}`);
  return { width, height, marks };
}
