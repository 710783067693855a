// Box pushing: a robot that looks one way and pushes a box; a goal is a cell for the box.
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
import { type Facing, robot, rose } from "../pose/robot.js";
import { spots, summaryOf, values } from "../pose/scene.js";
import type { BoardStores, View } from "../view.js";

type BoxScene = Extract<Scene, { format: "box-pushing" }>;

export const boxPushingView = (scene: BoxScene): View => ({
  board: (name, input, playground) => board(name, { ...input, scene }, playground),
  goal: (index) => `the box in ${cellText(scene.goals[index]?.cell ?? [0, 0])}`,
  legend: () =>
    poseSigns([
      [svg`<g transform="translate(0.5 0.5)">${crate("sure", 1)}</g>`, "box"],
      [svg`<g transform="translate(0.5 0.5)">${crate("perhaps", 1)}</g>`, "the box may be here"],
      [svg`<g transform="translate(0.5 0.5)">${rose(["north", "east"], [0, 0], 0.9)}</g>`, "ways it may look"],
    ]),
});

const boxOf = (state: State): Cell => (typeof state === "object" && "box" in state ? state.box : [0, 0]);
const facingOf = (state: State): Facing => (typeof state === "object" && "facing" in state ? state.facing : "north");

function board(name: BoardName, input: BoardInput<BoxScene>, playground: BoardStores): TemplateResult {
  const { scene, shown, step } = input;
  const scale = enlarged(scene);
  const at = robotCell(shown.state);
  const secret = playground.boards.mode.value === "guess";
  const boxes = name === "actor" ? [{ cell: boxOf(shown.state), sure: true }] : spots(summaryOf(shown, name), "box");
  const facings = name === "actor" ? [facingOf(shown.state)] : facingsOf(name, input);
  const after = `After ${counted(step, "action")}`;
  const label =
    name === "actor"
      ? `${after}: the robot in ${cellText(at)} looks ${facingOf(shown.state)}; the box is in ${cellText(boxOf(shown.state))}.`
      : `${after} the ${called[name]} thinks the robot may be in ${counted(cellsOf(name, input), "cell")}, looking ${facings.join(" or ") || "anywhere"}, and the box in ${counted(boxes.length, "cell")}.`;
  return poseBoard(name, input, playground, {
    at,
    label,
    under: svg`${boxes.map(
      ({ cell, sure }) =>
        svg`<g data-box=${cell.join(",")} transform="translate(${cell[0] + 0.5} ${cell[1] + 0.5})">${crate(sure ? "sure" : "perhaps", 1)}</g>`,
    )}`,
    over: svg`${robot(name, at, scale, secret, facingOf(shown.state), isGoal(scene, at))}`,
    below: {
      height: 0.75 * scale,
      drawn: svg`<g transform="scale(${scale})"><text class="below" x="0.08" y="0.52">${name === "actor" ? "looks" : "may look"}</text>
        ${rose(facings, [2.05, 0.41], 0.62)}</g>`,
    },
  });
}

const facingsOf = (name: Exclude<BoardName, "actor">, { shown }: BoardInput<BoxScene>): Facing[] =>
  values(summaryOf(shown, name), "facing").filter((value): value is Facing => typeof value === "string");

const isGoal = (scene: BoxScene, at: Cell): boolean => scene.goals.some(({ cell }) => sameCell(cell, at));

const cellsOf = (name: Exclude<BoardName, "actor">, { shown }: BoardInput<BoxScene>): number =>
  spots(summaryOf(shown, name), "robot").length;

/** A crate around the origin. */
function crate(look: "sure" | "perhaps", size: number) {
  return svg`<g class="crate ${look}" transform="scale(${size})"><rect x="-0.41" y="-0.41" width="0.82" height="0.82" rx="0.07"></rect>
    ${look === "sure" ? svg`<path d="M-0.41 -0.25H0.41M-0.41 0.25H0.41"></path>` : nothing}</g>`;
}
