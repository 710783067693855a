// Walking through the steps: buttons, a slider, and the keys that a slider has.
import { html, type TemplateResult } from "lit";
import type { Playground } from "../state/playground.js";
import { back, first, forward, last, pause, play } from "./icons.js";

export function stepper(playground: Playground): TemplateResult {
  const step = playground.step.value;
  const end = playground.lastStep.value;
  const playing = playground.playing.value;
  // Not `disabled`: a button that has the focus when its end is reached would lose it, and the keys with it.
  const button = (label: string, sign: TemplateResult, atEnd: boolean, action: () => void, kind = "") =>
    html`<button type="button" class="sign ${kind}" aria-label=${label} title=${label} aria-disabled=${String(atEnd)} @click=${action}>${sign}</button>`;
  return html`<section class="stepper" aria-label="Steps" @keydown=${keys(playground)}>
    <div class="buttons">
      ${button("First step", first, step === 0, () => playground.goTo(0), "jump")}
      ${button("Back one step", back, step === 0, () => playground.goTo(step - 1))}
      ${
        playing
          ? button("Pause", pause, false, () => playground.pause(), "main")
          : button("Play", play, end === 0, () => playground.play(), "main")
      }
      ${button("Forward one step", forward, step === end, () => playground.goTo(step + 1))}
      ${button("Last step", last, step === end, () => playground.goTo(end), "jump")}
    </div>
    <label>
      <span class="count"><span class="count-word">Step</span> <b>${step}</b> of ${end}</span>
      <input type="range" min="0" max=${end} step="1" .value=${String(step)} ?disabled=${end === 0}
        @input=${(event: InputEvent) => playground.goTo(Number((event.target as HTMLInputElement).value))} />
    </label>
  </section>`;
}

/** The slider has these keys of itself; here they work from the buttons too. */
function keys(playground: Playground) {
  return (event: KeyboardEvent) => {
    if (event.target instanceof HTMLInputElement || event.altKey || event.ctrlKey || event.metaKey) return;
    const target: Record<string, number> = {
      Home: 0,
      End: playground.lastStep.value,
      ArrowLeft: playground.step.value - 1,
      ArrowRight: playground.step.value + 1,
    };
    const step = target[event.key];
    if (step === undefined) return;
    event.preventDefault();
    playground.goTo(step);
  };
}
