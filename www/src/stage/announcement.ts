// The step, said once in words for those who do not see the boards.

import { effect, type ReadonlySignal, signal } from "@preact/signals-core";
import { html, type TemplateResult } from "lit";
import type { TraceStep } from "../core.js";
import type { Boards } from "../state/boards.js";
import type { Editing } from "../state/editing.js";
import type { OpenProblem } from "../state/open-problem.js";
import type { Timeline } from "../state/timeline.js";
import { actionText } from "../view/action.js";
import { named } from "../view/names.js";
import { called, type Role } from "../view/observers.js";
import { pressed } from "../view/pressed.js";
import { stateCount } from "./belief-size.js";

export interface AnnouncerStores {
  timeline: Timeline;
  boards: Boards;
  editing: Editing;
  problem: OpenProblem;
}

/** A key held down, or an edit that is solved again and again, is one change and not many. */
const QUIET_MS = 250;

/** So many steps a second can be said while they are played. */
const SAID_A_SECOND = 1.5;

/** More names than these are a number. */
const MOST_NAMED = 12;

/** Says where one has come to, once one has come to rest. */
export class Announcer {
  readonly said: ReadonlySignal<string>;
  private readonly words = signal("");
  private stop: (() => void) | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(readonly playground: AnnouncerStores) {
    this.said = this.words;
  }

  listen(): void {
    this.stop ??= effect(() => {
      const words = sentence(this.playground);
      clearTimeout(this.timer);
      if (pressed.value || words === this.words.peek()) return;
      this.timer = setTimeout(() => {
        this.words.value = words;
      }, QUIET_MS);
    });
  }

  release(): void {
    clearTimeout(this.timer);
    this.stop?.();
    this.stop = undefined;
  }
}

export function announcement(announcer: Announcer): TemplateResult {
  const { said } = announcer.playground.editing;
  return html`<p class="unseen" aria-live="polite"><span>${announcer.said.value}</span> <span>${said.value}</span></p>`;
}

function sentence({ timeline, boards: { mode }, problem: { veiled } }: AnnouncerStores): string {
  const shown = timeline.shown.value;
  if (shown === null) return "";
  // Faster than this nobody could say the steps: then only the one where it stops is said.
  if (timeline.playing.value && timeline.speed.value > SAID_A_SECOND) return "";
  const where = `Step ${timeline.step.value}${shown.action === null || mode.value === "guess" ? "" : `, ${actionText(shown.action)}`}`;
  if (veiled.value) return `${where}.`;
  if (mode.value === "guess") return `${where}: ${part("adversarial", shown)}.`;
  return `${where}: ${part("adversarial", shown)}; ${part("cooperative", shown)}.`;
}

function part(role: Role, shown: TraceStep): string {
  const symbol = shown.symbols[role];
  const states = stateCount(shown, role);
  return [
    `the ${called[role]} ${symbol === null ? "was told nothing yet" : `was told ${named(symbol)}`}`,
    `${states} ${states === 1 ? "state" : "states"} left`,
    possible(shown.goals[role]),
  ].join(", ");
}

function possible(goals: readonly string[]): string {
  if (goals.length === 0) return "no goal is possible now";
  if (goals.length > MOST_NAMED) return `${goals.length} goals are possible`;
  if (goals.length === 1) return `goal ${named(goals[0] ?? "")} is possible`;
  return `goals ${goals.slice(0, -1).map(named).join(", ")} and ${named(goals.at(-1) ?? "")} are possible`;
}
