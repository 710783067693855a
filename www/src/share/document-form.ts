// The problem as its document: typed, pasted, read from a file, or saved as one.
import { html, nothing, type TemplateResult } from "lit";
import type { Playground } from "../state/playground.js";
import { openFile, saveFile } from "./files.js";

export function documentForm(playground: Playground): TemplateResult {
  const { draft } = playground;
  const error = draft.error.value;
  const errorId = `${playground.workbench.id}-document-error`;
  const submit = (event: Event) => {
    event.preventDefault();
    void draft.use();
  };
  return html`<form class="document" @submit=${submit}>
    <label>
      <span>Problem document (JSON)</span>
      <textarea name="document" rows="14" spellcheck="false" autocapitalize="off" autocomplete="off"
        aria-invalid=${error === null ? nothing : "true"} aria-describedby=${error === null ? nothing : errorId}
        .value=${draft.text.value}
        @input=${(event: Event) => draft.type((event.target as HTMLTextAreaElement).value)}></textarea>
    </label>
    ${error === null ? nothing : html`<p class="mistake" id=${errorId}>${error}</p>`}
    ${
      draft.aside.value === null
        ? nothing
        : html`<p class="aside">The problem changed while you were typing.
            <button type="button" class="link" @click=${() => draft.bringBack()}>Bring my text back</button></p>`
    }
    <div class="actions">
      <button type="submit" class="primary">Use this problem</button>
      <button type="button" ?disabled=${!draft.changed.value} @click=${() => draft.forget()}>Undo typing</button>
      <button type="button" ?disabled=${playground.document.value === null} @click=${() => saveFile(playground)}>Save as a file</button>
      <label class="file">
        <span>Open a file</span>
        <input type="file" accept=".json,application/json" @change=${(event: Event) => chosen(playground, event)} />
      </label>
    </div>
    <small>The same document runs with the command: <code>mo-copp solve problem.json</code>. A file can also be dropped anywhere on the page.</small>
  </form>`;
}

function chosen(playground: Playground, event: Event): void {
  const input = event.target as HTMLInputElement;
  const file = input.files?.[0];
  // The same file, changed, can then be chosen again.
  input.value = "";
  if (file !== undefined) void openFile(playground, file);
}
