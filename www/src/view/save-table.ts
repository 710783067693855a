// The buttons that save a table, for a spreadsheet and for programs.
import { html, type TemplateResult } from "lit";
import { type Cell, csvText } from "./csv.js";
import { download } from "./download.js";

export interface Table {
  /** What the files are called, without their ending. */
  name: string;
  /** The first row holds the names of the columns. */
  rows: () => readonly (readonly Cell[])[];
  json: () => unknown;
}

/** `what` says to those who hear it what is saved. */
export function saveTable(what: string, { name, rows, json }: Table): TemplateResult {
  return html`<div class="actions save-table" role="group" aria-label="Save ${what}">
    <button type="button" class="small" @click=${() => download(csvText(rows()), "text/csv", `${name}.csv`)}>Save as CSV</button>
    <button type="button" class="small"
      @click=${() => download(`${JSON.stringify(json(), null, 2)}\n`, "application/json", `${name}.json`)}>Save as JSON</button>
  </div>`;
}
