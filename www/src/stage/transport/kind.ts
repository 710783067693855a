// Transport domains: how their states, facts and goals are shown.
import type { State } from "../../core.js";
import { atomOf, atomsOf, type PddlScene } from "../pddl/atoms.js";
import type { StateKind } from "../states/kind.js";
import { loadOfBelief, loadOfState } from "./load.js";
import { transportPicture } from "./picture.js";
import { worldOf } from "./world.js";

export { isTransport } from "./world.js";

export function transportKind(scene: PddlScene): StateKind {
  const world = worldOf(scene);
  return {
    atOnce: 1,
    picture: (state) => transportPicture(world, loadOfState(state)),
    described: (state: State) =>
      atomsOf(state)
        .filter(({ predicate }) => predicate !== "empty")
        .map(said)
        .join("; "),
    words: (fact) => said(atomOf(fact)),
    merged: (belief) => transportPicture(world, loadOfBelief(belief)),
    goal: (index) => goalText(scene, index),
  };
}

function said({ predicate, objects }: { predicate: string; objects: readonly string[] }): string {
  const [first = "", second = ""] = objects;
  if (objects.length === 2 && (predicate === "at" || predicate === "in")) return `${first} is ${predicate} ${second}`;
  if (predicate === "driving") return `${first} drives ${second}`;
  if (predicate === "empty") return `nobody drives ${first}`;
  return [predicate, ...objects].join(" ");
}

function goalText({ goals }: PddlScene, index: number): string {
  const goal = goals[index];
  if (goal === undefined) return "";
  const plain = goal.facts.length > 0 && !goal.condition.includes("(not ");
  return plain ? goal.facts.map((fact) => said(atomOf(fact))).join(", ") : goal.condition;
}
