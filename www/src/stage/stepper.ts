// Walking through the steps: buttons, a slider, the speed, and the keys that a slider has.
import { html, type TemplateResult } from "lit";
import type { Boards } from "../state/boards.js";
import { type Speed, speeds, type Timeline } from "../state/timeline.js";
import { back, first, forward, last, pause, play } from "../view/icons.js";

interface StepperStores {
  timeline: Timeline;
  boards: Boards;
}

const speedNames: Record<Speed, string> = { 0.75: "½×", 1.5: "1×", 3: "2×", 6: "4×" };

export function stepper({ timeline, boards: { mode } }: StepperStores): TemplateResult {
  const step = timeline.step.value;
  const end = timeline.lastStep.value;
  // How long the way is could tell which goal it leads to: who guesses learns it by walking it.
  const known = mode.value === "guess" ? timeline.seen.value : end;
  const playing = timeline.playing.value;
  // Not `disabled`: a button that has the focus when its end is reached would lose it, and the keys with it.
  const button = (label: string, sign: TemplateResult, atEnd: boolean, action: () => void, kind = "") =>
    html`<button type="button" class="sign ${kind}" aria-label=${label} title=${label} aria-disabled=${String(atEnd)} @click=${action}>${sign}</button>`;
  return html`<div class="stepper" part="stepper" role="group" aria-label="Steps" @keydown=${keys(timeline)}>
    <div class="buttons">
      ${button("First step", first, step === 0, () => timeline.goTo(0), "jump")}
      ${button("Back one step", back, step === 0, () => timeline.goTo(step - 1))}
      ${
        playing
          ? button("Pause", pause, false, () => timeline.pause(), "main")
          : button("Play", play, end === 0, () => timeline.play(), "main")
      }
      ${button("Forward one step", forward, step === end, () => timeline.goTo(step + 1))}
      ${button("Last step", last, step === end, () => timeline.goTo(end), "jump")}
    </div>
    <label class="scrub">
      <span class="count"><span class="count-word">Step</span> <b>${step}</b>${known < end ? "" : html`<span class="of"> of </span>${end}`}</span>
      <input type="range" min="0" max=${known} step="1" .value=${String(step)} ?disabled=${known === 0}
        @input=${(event: InputEvent) => timeline.goTo(Number((event.target as HTMLInputElement).value))} />
    </label>
    <label class="speed">
      <span class="unseen">Playing speed</span>
      <select @change=${(event: Event) => timeline.setSpeed(Number((event.target as HTMLSelectElement).value) as Speed)}>
        ${speeds.map((speed) => html`<option value=${speed} ?selected=${speed === timeline.speed.value}>${speedNames[speed]}</option>`)}
      </select>
    </label>
  </div>`;
}

/** The slider has these keys of itself; here they work from the buttons too. */
function keys(timeline: Timeline) {
  return (event: KeyboardEvent) => {
    const inField = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement;
    if (inField || event.altKey || event.ctrlKey || event.metaKey) return;
    const target: Record<string, number> = {
      Home: 0,
      End: timeline.lastStep.value,
      ArrowLeft: timeline.step.value - 1,
      ArrowRight: timeline.step.value + 1,
    };
    const step = target[event.key];
    if (step === undefined) return;
    event.preventDefault();
    timeline.goTo(step);
  };
}
