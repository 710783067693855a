// The problem as its document: typed, pasted, read from a file, or saved as one.
import { html, nothing, type TemplateResult } from "lit";
import { type FileStores, openFile, saveFile } from "../share/files.js";
import { newMenu } from "./new-menu.js";
import { TextTab, type TextTabStores, type View } from "./text-tab.js";

export type DocumentFormStores = TextTabStores & FileStores;

/** The fields stay with their playground, with the cursor and all that can be undone in them. */
const tabs = new WeakMap<DocumentFormStores, TextTab>();

function tabOf(playground: DocumentFormStores): TextTab {
  const tab = tabs.get(playground) ?? new TextTab(playground);
  tabs.set(playground, tab);
  return tab;
}

export function documentForm(playground: DocumentFormStores): TemplateResult {
  const { draft } = playground;
  const tab = tabOf(playground);
  const { view, hasParts, elements } = tab.follow();
  const submit = (event: Event) => {
    event.preventDefault();
    void tab.use();
  };
  return html`<form class="document" @submit=${submit}>
    <div class="text-head">
      ${viewSwitch(tab, view, hasParts, draft.text.value)}
      <div class="actions">
        ${newMenu((text) => tab.replace(text))}
        <button type="button" @click=${() => tab.format() || tab.goToFault()}>Format</button>
      </div>
    </div>
    <div class="text-fields" data-view=${view}>${elements.map((element, index) => named(element, view, index))}</div>
    ${
      draft.overtaken.value
        ? html`<p class="aside" role="status">The problem on the page is another one by now. Your text is as you left it.
            <button type="button" class="link" @click=${() => draft.keep()}>Keep my text</button>
            <button type="button" class="link" @click=${() => tab.forget()}>Show the page’s problem</button></p>`
        : nothing
    }
    <div class="actions">
      <button type="submit" class="primary" aria-keyshortcuts="Control+Enter">Use this problem</button>
      <button type="button" ?disabled=${!draft.changed.value} @click=${() => tab.forget()}>Undo typing</button>
      <button type="button" ?disabled=${playground.problem.document.value === null} @click=${() => saveFile(playground)}>Save as a file</button>
      <label class="file">
        <span>Open a file</span>
        <input type="file" accept=".json,application/json" @change=${(event: Event) => chosen(playground, event)} />
      </label>
    </div>
    <small>${draft.changed.value ? "The page shows your text once you use it: " : "The text follows the page. To use what you type: "}<kbd>Ctrl</kbd>
      + <kbd>Enter</kbd>. <kbd>Tab</kbd> indents; <kbd>Escape</kbd>, then <kbd>Tab</kbd> goes on to the next control.
      The same document runs with the command: <code>mo-copp solve problem.json</code>. A file can also be dropped anywhere on the page.</small>
  </form>`;
}

/** A PDDL document can be seen as PDDL. */
function viewSwitch(tab: TextTab, view: View, hasParts: boolean, text: string): TemplateResult | typeof nothing {
  if (!hasParts && !/"format"\s*:\s*"pddl"/.test(text)) return nothing;
  const button = (value: View, name: string, able: boolean) =>
    html`<button type="button" aria-pressed=${String(view === value)} ?disabled=${!able} @click=${() => tab.show(value)}>${name}</button>`;
  return html`<div class="text-views" role="group" aria-label="Show the text as">
    ${button("json", "JSON", true)} ${button("pddl", "PDDL", hasParts)}
    ${hasParts ? nothing : html`<small>The JSON must be whole before it can be shown as PDDL.</small>`}
  </div>`;
}

const titles = ["Domain (PDDL)", "Problem (PDDL)", "Goals and observers (JSON)"];

/** The field has its name for those who hear it; this is for those who see it. */
const named = (element: HTMLElement, view: View, index: number): TemplateResult =>
  html`<div class="named-field"><span class="field-name" aria-hidden="true">${view === "json" ? "Problem document (JSON)" : titles[index]}</span>${element}</div>`;

function chosen(playground: DocumentFormStores, event: Event): void {
  const input = event.target as HTMLInputElement;
  const file = input.files?.[0];
  // The same file, changed, can then be chosen again.
  input.value = "";
  if (file !== undefined) void openFile(playground, file);
}
