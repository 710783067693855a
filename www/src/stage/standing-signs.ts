// The sign beside a goal in lists, by what an observer holds of it.
import type { TemplateResult } from "lit";
import { notNow, possible, ruledOut } from "../view/icons.js";
import type { Standing } from "./goal-attributes.js";

export const signs: Record<Standing, TemplateResult> = { possible, "not now": notNow, "ruled out": ruledOut };
