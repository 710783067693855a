// The candidate goals on a board that has very many of them: a badge each, without its name and in its cell. They are made once, a part
// at a time, and then only what changes is touched.
import { noChange } from "lit";
import { AsyncDirective } from "lit/async-directive.js";
import { directive, type ElementPart } from "lit/directive.js";
import type { Place } from "../../view/goal-place.js";
import { starPath } from "../../view/icons.js";
import type { BoardName } from "../board-input.js";
import { type GoalView, isKnown } from "../goal-attributes.js";
import { goalTold, looks } from "../goal-marks.js";

/** From so many on, names and marks could not be read. */
export const MANY_GOALS = 150;
/** That many are made in one go. */
const AT_ONCE = 100;
/** Each part has a picture of its own. */
const FRAME_MS = 16;

export interface GoalsDrawn {
  board: BoardName;
  goals: readonly GoalView[];
  places: readonly Place[];
}

interface Badge {
  group: SVGGElement;
  title: SVGTitleElement;
  look: string;
}

const NAMESPACE = "http://www.w3.org/2000/svg";

class GoalLayer extends AsyncDirective {
  private badges: Badge[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;

  render(_drawn: GoalsDrawn): typeof noChange {
    return noChange;
  }

  override update(part: ElementPart, [drawn]: [GoalsDrawn]): typeof noChange {
    clearTimeout(this.timer);
    for (const { group } of this.badges.splice(drawn.goals.length)) group.remove();
    this.badges.forEach((badge, index) => {
      show(badge, drawn, index);
    });
    this.goOn(part.element, drawn);
    return noChange;
  }

  override disconnected(): void {
    clearTimeout(this.timer);
  }

  private goOn(layer: Element, drawn: GoalsDrawn): void {
    if (this.badges.length < drawn.goals.length) this.timer = setTimeout(() => this.more(layer, drawn), FRAME_MS);
  }

  private more(layer: Element, drawn: GoalsDrawn): void {
    const from = this.badges.length;
    const fresh = drawn.goals.slice(from, from + AT_ONCE).map(made);
    layer.append(...fresh.map(({ group }) => group));
    this.badges.push(...fresh);
    fresh.forEach((badge, index) => {
      show(badge, drawn, from + index);
    });
    this.goOn(layer, drawn);
  }
}

const create = <Name extends keyof SVGElementTagNameMap>(name: Name) => document.createElementNS(NAMESPACE, name);

function pattern(): SVGGElement {
  const [group, badge] = [create("g"), create("rect")];
  const box = { class: "badge", x: "-0.35", y: "-0.27", width: "0.7", height: "0.54", rx: "0.16" };
  for (const [name, value] of Object.entries(box)) badge.setAttribute(name, value);
  group.append(badge);
  return group;
}

function star(): SVGPathElement {
  const path = create("path");
  for (const [name, value] of Object.entries({ class: "star", transform: "scale(0.6)", d: starPath })) {
    path.setAttribute(name, value);
  }
  return path;
}

let first: SVGGElement | undefined;

function made(): Badge {
  first ??= pattern();
  const group = first.cloneNode(true) as SVGGElement;
  const title = create("title");
  group.prepend(title);
  return { group, title, look: "" };
}

/** Touches a badge where it does not look so already. */
function show(badge: Badge, { board, goals, places }: GoalsDrawn, index: number): void {
  const [goal, place] = [goals[index], places[index]];
  if (goal === undefined || place === undefined) return;
  const { x, y, scale } = place;
  const words = goalTold(goal);
  const look = `${words} ${x} ${y} ${scale}`;
  if (look === badge.look) return;
  badge.look = look;
  badge.title.textContent = words;
  const { group } = badge;
  const kind = board === "actor" ? "plain" : looks[goal.standing[board]];
  group.setAttribute("class", `goal ${kind}`);
  group.setAttribute("transform", `translate(${x} ${y}) scale(${scale})`);
  group.setAttribute("data-goal", goal.name);
  group.toggleAttribute("data-true-goal", goal.isTrue);
  group.querySelector(".star")?.remove();
  if (goal.isTrue) group.append(star());
  for (const role of ["adversarial", "cooperative"] as const) {
    const { [role]: attribute } = goal.attributes;
    if (isKnown(attribute)) group.setAttribute(`data-${role}`, attribute);
    else group.removeAttribute(`data-${role}`);
  }
}

/** `<g ${goalLayer({...})}></g>` */
export const goalLayer = directive(GoalLayer);
