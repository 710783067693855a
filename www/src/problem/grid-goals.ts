// Edits of a grid's candidate goals.
import { sameCell } from "./cells.js";
import { freeCells, isFree, isTaken } from "./grid-cells.js";
import { freeName, nameFault, tidied } from "./names.js";
import type { Cell, FloorDocument } from "./types.js";

/** The core takes no more. */
export const MOST_GOALS = 1024;
/** With one goal there is nothing to keep secret. */
export const FEWEST_GOALS = 2;

const namesOf = (document: FloorDocument): string[] => document.goals.map(({ name }) => name);

/** A goal with a name of its own: in the cell that is asked for, or in the free one nearest to the last corner. */
export function addGoal<D extends FloorDocument>(document: D, cell?: Cell): D | string {
  if (document.goals.length >= MOST_GOALS) return `There are ${MOST_GOALS} goals already: no more are possible.`;
  if (cell !== undefined && !isFree(document, cell)) return "A goal can’t stand in a wall.";
  const free = freeCells(document).reverse();
  const place = cell ?? free.find((candidate) => !isTaken(document, candidate)) ?? free[0];
  if (place === undefined) return "There is no free cell.";
  const name = freeName(namesOf(document), (number) => `G${number}`);
  return { ...document, goals: [...document.goals, { name, cell: place }] };
}

export function renameGoal<D extends FloorDocument>(document: D, index: number, text: string): D | string {
  const before = document.goals[index]?.name;
  const name = tidied(text);
  const fault = nameFault(
    name,
    namesOf(document).filter((_, at) => at !== index),
  );
  if (fault !== null) return fault;
  return {
    ...document,
    goals: document.goals.map((goal, at) => (at === index ? { ...goal, name } : goal)),
    true_goal: document.true_goal === before ? name : document.true_goal,
  };
}

/** Where the true goal goes, the first that is left becomes true. */
export function removeGoal<D extends FloorDocument>(document: D, index: number): D | string {
  if (document.goals.length <= FEWEST_GOALS) return "At least two goals stay: with one there is nothing to guess.";
  const goals = document.goals.filter((_, at) => at !== index);
  const stays = goals.some(({ name }) => name === document.true_goal);
  return { ...document, goals, true_goal: stays ? document.true_goal : (goals[0]?.name ?? document.true_goal) };
}

export function chooseTrueGoal<D extends FloorDocument>(document: D, index: number): D {
  return { ...document, true_goal: document.goals[index]?.name ?? document.true_goal };
}

/** The goal that is drawn on top in a cell; −1 where there is none. */
export const goalAt = (document: FloorDocument, cell: Cell): number =>
  document.goals.map((goal) => sameCell(goal.cell, cell)).lastIndexOf(true);
