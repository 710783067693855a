// The text fields of a playground: one for the whole document, or three for a PDDL document. All write the same draft.
import { json } from "@codemirror/lang-json";
import { signal } from "@preact/signals-core";
import { written } from "../problem/text.js";
import { inWhole } from "../share/fault-words.js";
import type { Draft } from "./draft.js";
import { markAt } from "./fault.js";
import { compose, markIn, type PartName, type Parts, partNames, split } from "./parts.js";
import { pddl } from "./pddl-language.js";
import { TextField } from "./text-field.js";

export interface TextTabStores {
  draft: Draft;
}

export type View = "json" | "pddl";

export class TextTab {
  private readonly wanted = signal<View>("json");
  private readonly whole: TextField;
  private readonly fields: Record<PartName, TextField>;
  /** The text that the fields show, and the parts that are shown of it. */
  private shown: { text: string; parts: Parts | null } | null = null;
  /** What typing in the parts came to last: they are kept as they are, right or wrong. */
  private made: { text: string; parts: Parts } | null = null;
  /** Whether a text has parts, of the last text asked about. */
  private known: { text: string; parts: Parts | null } | null = null;

  constructor(private readonly playground: TextTabStores) {
    const common = { submit: () => void this.use(), next: () => this.goToFault() };
    const part = (label: string, language: typeof json) =>
      new TextField({ ...common, label, fine: "", language: language(), changed: () => this.partTyped() });
    this.whole = new TextField({
      ...common,
      fine: "No errors.",
      label: "Problem document (JSON)",
      language: json(),
      changed: () => this.typed(this.whole.text, null),
    });
    this.fields = {
      domain: part("Domain (PDDL)", pddl),
      problem: part("Problem (PDDL)", pddl),
      rest: part("Goals and observers (JSON)", json),
    };
  }

  /** How the text is shown; also puts it there, and what the core says of it. */
  follow(): { view: View; hasParts: boolean; elements: HTMLElement[] } {
    const { draft } = this.playground;
    const text = draft.text.value;
    const parts = this.partsOf(text);
    const view = parts === null ? "json" : this.wanted.value;
    const inParts = view === "pddl" ? parts : null;
    if (this.shown === null || this.shown.text !== text || (this.shown.parts === null) !== (inParts === null)) {
      this.shown = { text, parts: inParts };
      if (inParts === null) this.whole.show(text);
      else for (const name of partNames) this.fields[name].show(inParts[name]);
    }
    this.showFaults(inParts);
    const shown = inParts === null ? [this.whole] : partNames.map((name) => this.fields[name]);
    return { view, hasParts: parts !== null, elements: shown.map(({ element }) => element) };
  }

  show(view: View): void {
    this.wanted.value = view;
  }

  async use(): Promise<void> {
    const { draft } = this.playground;
    draft.check(this.textOfView());
    const inParts = this.shown?.parts != null;
    await draft.use(inParts ? ({ message }) => message : inWhole);
  }

  goToFault(): void {
    const fields = this.shown?.parts == null ? [this.whole] : partNames.map((name) => this.fields[name]);
    fields.some((field) => field.goToFault());
  }

  /** Another text takes the place of the draft; the field's own undo brings that back. */
  replace(text: string): void {
    const parts = this.shown?.parts == null ? null : split(text);
    if (parts !== null) {
      for (const name of partNames) this.fields[name].replace(parts[name]);
      return;
    }
    this.wanted.value = "json";
    this.whole.show(this.playground.draft.text.value);
    this.whole.replace(text);
  }

  /** The text of the document that is open comes back; the field's own undo brings the other one back. */
  forget(): void {
    const { draft } = this.playground;
    const text = draft.open.value;
    this.replace(text);
    draft.forget();
    this.shown = { text, parts: this.shown?.parts ?? null };
  }

  /** Writes the JSON that is shown as the project's documents are written. False where it can't be read as it is. */
  format(): boolean {
    const field = this.shown?.parts == null ? this.whole : this.fields.rest;
    const { checked, text } = this.playground.draft;
    // No JSON for the core, as with a key given twice, of which the browser would keep one.
    const fault = checked.value?.text === text.value ? checked.value.fault : null;
    if (fault !== null && fault.path === undefined) return false;
    try {
      const formatted = written(JSON.parse(field.text));
      if (formatted !== field.text) field.replace(formatted);
      return true;
    } catch {
      return false;
    }
  }

  private typed(text: string, parts: Parts | null): void {
    this.shown = { text, parts };
    this.playground.draft.type(text);
    this.playground.draft.check(text);
  }

  private partTyped(): void {
    const { domain, problem, rest } = this.fields;
    const parts = { domain: domain.text, problem: problem.text, rest: rest.text };
    const text = compose(parts);
    this.made = { text, parts };
    this.typed(text, parts);
  }

  private partsOf(text: string): Parts | null {
    if (this.made?.text === text) return this.made.parts;
    if (this.known?.text !== text) this.known = { text, parts: split(text) };
    return this.known.parts;
  }

  /** Places are those of the text that was read: of parts that is what they make. */
  private textOfView(): string {
    const { text } = this.playground.draft;
    return this.shown?.parts == null ? text.value : compose(this.shown.parts);
  }

  private showFaults(parts: Parts | null): void {
    const { draft } = this.playground;
    const text = parts === null ? draft.text.value : compose(parts);
    if (!draft.changed.value) {
      for (const field of [this.whole, ...Object.values(this.fields)]) field.mark(null);
      return;
    }
    draft.check(text);
    const checked = draft.checked.value;
    // Until the core has read the newest text, what is marked stays marked.
    if (checked?.text !== text) return;
    const { fault } = checked;
    if (draft.toFault.peek()) {
      // Once it is marked, and the fields stand in the page.
      queueMicrotask(() => {
        draft.toFault.value = false;
        requestAnimationFrame(() => this.goToFault());
      });
    }
    if (parts === null) {
      this.whole.mark(fault && markAt(this.whole.doc, fault.place, inWhole(fault)));
      return;
    }
    const { domain, problem, rest } = this.fields;
    const docs = { domain: domain.doc, problem: problem.doc, rest: rest.doc };
    const found = fault && markIn(parts, docs, fault);
    for (const name of partNames) this.fields[name].mark(found?.part === name ? found.mark : null);
  }
}
