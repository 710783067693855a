// How large things are drawn on boards of many cells.
import type { Size } from "../problem/cells.js";

/** From so many cells on, all that look alike are drawn as one: a browser takes long to paint thousands of shapes. */
const MANY = 400;

export const isLarge = ({ width, height }: Size): boolean => width * height > MANY;

/** By how much what stands in a cell is drawn larger than the cell, so that it stays readable. */
export const enlarged = ({ width, height }: Size): number => Math.max(1, Math.max(width, height) / 14);
