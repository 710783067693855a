// What stands above the boards stays as it is while something is dragged: else they would move under the hand.
import type { TemplateResult } from "lit";
import { guard } from "lit/directives/guard.js";
import type { Editing } from "../state/editing.js";

interface HeldStores {
  editing: Editing;
}

export const held = ({ editing }: HeldStores, part: () => TemplateResult | "") =>
  guard(editing.drag.value === null ? [{}] : ["held"], part);
