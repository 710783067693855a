// The recycling robot: it carries a can to a bin, and its battery runs down on the way. A goal is a bin.
import { nothing, svg, type TemplateResult } from "lit";
import type { Scene, State } from "../../core.js";
import { cellText, sameCell } from "../../problem/cells.js";
import type { Cell } from "../../problem/types.js";
import { counted } from "../../view/numbers.js";
import { called } from "../../view/observers.js";
import { enlarged } from "../../view/scale.js";
import type { BoardInput, BoardName } from "../board-input.js";
import { poseBoard, robotCell } from "../pose/board.js";
import { poseSigns } from "../pose/legend.js";
import { robot } from "../pose/robot.js";
import { spots, summaryOf, values } from "../pose/scene.js";
import type { BoardStores, View } from "../view.js";
import { battery } from "./battery.js";
import { bin, can, charger } from "./things.js";

type RobotScene = Extract<Scene, { format: "recycling-robot" }>;

export const recyclingView = (scene: RobotScene): View => ({
  board: (name, input, playground) => board(name, { ...input, scene }, playground),
  goal: (index) => `the can in the bin in ${cellText(scene.goals[index]?.cell ?? [0, 0])}`,
  legend: () =>
    poseSigns([
      [svg`<g transform="translate(0.5 0.5) scale(1.6)">${can("sure")}</g>`, "can"],
      [svg`<g transform="translate(0.5 0.5) scale(1.6)">${can("perhaps")}</g>`, "the can may be here"],
      [svg`<g transform="translate(0.5 0.5)">${bin()}</g>`, "bin"],
      [svg`<g transform="translate(0.5 0.5)">${charger()}</g>`, "charger"],
    ]),
});

const robotState = (state: State) => (typeof state === "object" && "battery" in state ? state : null);

function board(name: BoardName, input: BoardInput<RobotScene>, playground: BoardStores): TemplateResult {
  const { scene, shown } = input;
  const scale = enlarged(scene);
  const at = robotCell(shown.state);
  const secret = playground.boards.mode.value === "guess";
  const state = robotState(shown.state);
  const belief = name === "actor" ? null : summaryOf(shown, name);
  const cans =
    belief === null ? (Array.isArray(state?.can) ? [{ cell: state.can, sure: true }] : []) : spots(belief, "can");
  const carried = belief === null ? state?.can === "held" : values(belief, "can").includes("held");
  const levels =
    belief === null ? [state?.battery ?? 0] : values(belief, "battery").filter((level) => typeof level === "number");
  const place = ([column, row]: Cell) => `translate(${column + 0.5} ${row + 0.5})`;
  return poseBoard(name, input, playground, {
    at,
    label: described(name, input, cans.length, carried, levels),
    under: svg`<g transform="${place(scene.charger)} scale(${scale})">${charger()}</g>
      ${scene.goals.map(({ cell }) => svg`<g transform="${place(cell)} scale(${scale})">${bin()}</g>`)}`,
    over: svg`${robot(
      name,
      at,
      scale,
      secret,
      null,
      scene.goals.some(({ cell }) => sameCell(cell, at)),
      name === "actor" && carried ? svg`<g transform="translate(0.18 0.12) scale(1.5)">${can("sure")}</g>` : nothing,
    )}
      ${cans.map(({ cell, sure }) => svg`<g data-can=${cell.join(",")} transform="${place(cell)} scale(${scale}) translate(-0.34 -0.27) scale(1.15)">${can(sure ? "sure" : "perhaps")}</g>`)}`,
    below: {
      height: 0.8 * scale,
      drawn: svg`<g transform="scale(${scale})">${battery(levels, scene.battery_levels, scene.width / scale, belief === null, belief !== null && carried ? (cans.length === 0 ? "sure" : "perhaps") : null)}</g>`,
    },
  });
}

function described(
  name: BoardName,
  { shown, step }: BoardInput<RobotScene>,
  cans: number,
  carried: boolean,
  levels: readonly (string | number)[],
): string {
  const after = `After ${counted(step, "action")}`;
  if (name === "actor") {
    const state = robotState(shown.state);
    const where = Array.isArray(state?.can) ? `the can lies in ${cellText(state.can)}` : "it carries the can";
    return `${after}: the robot is in ${cellText(robotCell(shown.state))}, ${where}, battery level ${state?.battery ?? 0}.`;
  }
  const robots = spots(summaryOf(shown, name), "robot").length;
  const lying = cans === 0 ? "" : `the can may lie in ${counted(cans, "cell")}`;
  const carrying = carried ? (cans === 0 ? "it carries the can" : "it may carry the can") : "";
  const sorted = [...levels].map(Number).sort((a, b) => a - b);
  return `${after} the ${called[name]} thinks the robot may be in ${counted(robots, "cell")}; ${[lying, carrying].filter(Boolean).join(", or ")}; battery level ${sorted.join(" or ")}.`;
}
