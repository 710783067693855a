// The problem as its document: typed, pasted or read from a file.
import { signal } from "@preact/signals-core";
import { html, type TemplateResult } from "lit";
import { exampleDocument } from "../problem/example.js";
import type { Playground } from "../state/playground.js";

/** No problem that can be drawn is larger; a file by mistake should not stall the page. */
const LARGEST_FILE = 2_000_000;

/** What stands in the text field; null where it is the document that is open. */
const draft = signal<string | null>(null);

export function documentForm(playground: Playground): TemplateResult {
  const submit = (event: Event) => {
    event.preventDefault();
    void playground.open(draft.value ?? playground.document.value?.text ?? "");
  };
  return html`<form class="document" @submit=${submit}>
      <label>
        <span>Problem document (JSON)</span>
        <textarea name="document" rows="14" spellcheck="false" autocapitalize="off" autocomplete="off"
          .value=${draft.value ?? playground.document.value?.text ?? ""}
          @input=${(event: Event) => {
            draft.value = (event.target as HTMLTextAreaElement).value;
          }}></textarea>
      </label>
      <div class="actions">
        <button type="submit" class="primary">Use this problem</button>
        <button type="button" @click=${() => playground.open(exampleDocument)}>Back to the example</button>
        <label class="file">
          <span>or open a file</span>
          <input type="file" accept=".json,application/json" @change=${(event: Event) => openFile(playground, event)} />
        </label>
      </div>
    </form>`;
}

async function openFile(playground: Playground, event: Event): Promise<void> {
  const input = event.target as HTMLInputElement;
  const file = input.files?.[0];
  if (file === undefined) return;
  // The same file, changed, can then be chosen again.
  input.value = "";
  if (file.size > LARGEST_FILE) {
    playground.refuse(`“${file.name}” is too large for a problem document (more than 2 MB).`);
    return;
  }
  await playground.open(await file.text());
}
