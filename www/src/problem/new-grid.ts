// An empty grid to begin with.

import { type GridSensor, gridPresets } from "./grid-sensor.js";
import type { GridworldDocument } from "./types.js";

export function newGrid(width: number, height: number): GridworldDocument {
  const sensor = ({ stay: _stay, ...four }: GridSensor): GridSensor => four;
  return {
    format: "gridworld",
    width,
    height,
    walls: [],
    start: [0, height - 1],
    goals: [
      { name: "G1", cell: [width - 1, 0] },
      { name: "G2", cell: [width - 1, height - 1] },
      { name: "G3", cell: [0, 0] },
    ],
    true_goal: "G1",
    stay: false,
    observers: {
      adversarial: { sensor: sensor(gridPresets.enemy.sensor) },
      cooperative: { sensor: sensor(gridPresets.friend.sensor) },
    },
  };
}
