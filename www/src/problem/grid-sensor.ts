// Edits of what an observer on a grid is told: a symbol for each move, and whether the agent may stay.
import { withObserver } from "./grid-cells.js";
import { LONGEST_NAME, tidied } from "./names.js";
import type { GridworldDocument, Move, Role } from "./types.js";

export type GridSensor = { [move in Move]?: string };

export const moves: readonly Move[] = ["north", "south", "east", "west", "stay"];

export type GridPreset = "enemy" | "friend" | "everything" | "nothing";

export const gridPresets: Record<GridPreset, { title: string; sensor: Required<GridSensor> }> = {
  enemy: {
    title: "The paper’s enemy (vertical / horizontal)",
    sensor: { north: "vertical", south: "vertical", east: "horizontal", west: "horizontal", stay: "stay" },
  },
  friend: {
    title: "The paper’s friend (north-east / south-west)",
    sensor: { north: "north-east", south: "south-west", east: "north-east", west: "south-west", stay: "stay" },
  },
  everything: {
    title: "Sees every move",
    sensor: { north: "north", south: "south", east: "east", west: "west", stay: "stay" },
  },
  nothing: {
    title: "Sees nothing (every move looks the same)",
    sensor: { north: "moved", south: "moved", east: "moved", west: "moved", stay: "moved" },
  },
};

/** The moves that the agent has. */
export const movesOf = (document: GridworldDocument): readonly Move[] =>
  document.stay === true ? moves : moves.filter((move) => move !== "stay");

/** Which preset an observer's sensor is; null where it is none. */
export function presetOf(document: GridworldDocument, role: Role): GridPreset | null {
  const { sensor } = document.observers[role];
  const names = Object.keys(gridPresets) as GridPreset[];
  const fits = (name: GridPreset) => movesOf(document).every((move) => sensor[move] === gridPresets[name].sensor[move]);
  return names.find(fits) ?? null;
}

export function usePreset(document: GridworldDocument, role: Role, preset: GridPreset): GridworldDocument {
  const { stay, ...four } = gridPresets[preset].sensor;
  return withObserver(document, role, (observer) => ({
    ...observer,
    sensor: document.stay === true ? { ...four, stay } : four,
  }));
}

export function setSymbol(
  document: GridworldDocument,
  role: Role,
  move: Move,
  text: string,
): GridworldDocument | string {
  // A move that the agent does not have gives no symbol.
  if (!movesOf(document).includes(move)) return document;
  const symbol = tidied(text);
  if (symbol === "") return `A symbol for ${move} is needed; give moves the same one to make them look the same.`;
  return withObserver(document, role, (observer) => ({ ...observer, sensor: { ...observer.sensor, [move]: symbol } }));
}

/** Whoever has no symbol for staying gets one: their only one where they have no other, else a new one. */
export function setStay(document: GridworldDocument, stay: boolean): GridworldDocument {
  let changed: GridworldDocument = { ...document, stay };
  for (const role of ["adversarial", "cooperative"] as const) {
    const { sensor } = document.observers[role];
    if (!stay) {
      const { stay: _, ...moves } = sensor;
      changed = withObserver(changed, role, (observer) => ({ ...observer, sensor: moves }));
      continue;
    }
    if (sensor.stay !== undefined) continue;
    const symbols = new Set(Object.values(sensor));
    const [only] = symbols;
    const symbol = symbols.size === 1 && only !== undefined ? only : "stay";
    changed = withObserver(changed, role, (observer) => ({
      ...observer,
      sensor: { ...observer.sensor, stay: symbol },
    }));
  }
  return changed;
}

/** Every symbol of either observer, to choose from. */
export function symbolsOf(document: GridworldDocument): string[] {
  const { adversarial, cooperative } = document.observers;
  return [...new Set([...Object.values(adversarial.sensor), ...Object.values(cooperative.sensor)])].filter(
    (symbol) => symbol.length <= LONGEST_NAME,
  );
}
