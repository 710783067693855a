// What every picture is drawn from: the scene and one step of it.
import type { Scene, Trace, TraceStep } from "../core.js";
import type { BoardName } from "../view/observers.js";

export type { BoardName };

export interface BoardInput<S extends Scene = Scene> {
  scene: S;
  trace: Trace;
  step: number;
  shown: TraceStep;
}
