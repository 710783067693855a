// What stands above the boards stays as it is while something is dragged: else they would move under the hand.
import type { TemplateResult } from "lit";
import { guard } from "lit/directives/guard.js";
import type { Playground } from "../state/playground.js";

export const held = ({ editing }: Playground, part: () => TemplateResult | "") =>
  guard(editing.drag.value === null ? [{}] : ["held"], part);
