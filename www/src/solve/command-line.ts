// The command that does the same as the form, to copy.
import type { ReadonlySignal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit";
import type { Gallery } from "../gallery/gallery.js";
import { commandFor } from "../state/command.js";
import { type Form, optionsOf } from "../state/form.js";
import type { Copier } from "../view/copier.js";

export interface CommandLineStores {
  form: ReadonlySignal<Form>;
  gallery: Gallery;
  command: Copier;
}

const words = { "": "", copied: "Copied.", refused: "The page may not use the clipboard: select the command." };

export function commandLine({ form, gallery, command }: CommandLineStores): TemplateResult | typeof nothing {
  const options = optionsOf(form.value);
  if (typeof options === "string") return nothing;
  const text = commandFor(`${gallery.fileName.value}.json`, options);
  return html`<div class="command">
    <small>The same with the command, on the document saved as a file:</small>
    <code>${text}</code>
    <button type="button" class="small" @click=${() => void command.copy(text)}>Copy the command</button>
    <small role="status">${words[command.said.value]}</small>
  </div>`;
}
