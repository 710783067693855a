// Fields of the form that makes an exercise.
import { html, type TemplateResult } from "lit";

const typed = (event: Event): string => (event.target as HTMLInputElement).value;

export function select<Value extends string>(
  label: string,
  value: Value,
  values: readonly Value[],
  word: (value: Value) => string,
  choose: (value: Value) => void,
): TemplateResult {
  return html`<label>${label} <select @change=${(event: Event) => choose(typed(event) as Value)}>
    ${values.map((one) => html`<option value=${one} ?selected=${one === value}>${word(one)}</option>`)}</select></label>`;
}

export const text = (label: string, value: string, type: (value: string) => void): TemplateResult =>
  html`<label>${label} <input type="text" .value=${value} @input=${(event: Event) => type(typed(event))} /></label>`;

export const area = (label: string, value: string, type: (value: string) => void): TemplateResult =>
  html`<label>${label} <textarea rows="2" .value=${value} @input=${(event: Event) => type(typed(event))}></textarea></label>`;

export const check = (label: string, value: boolean, set: (value: boolean) => void): TemplateResult =>
  html`<label class="check"><input type="checkbox" .checked=${value}
    @change=${(event: Event) => set((event.target as HTMLInputElement).checked)} /> ${label}</label>`;
