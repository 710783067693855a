// The button that opens the sheet in which pictures are saved. The sheet's code is loaded when the button is pressed.
import { html, type TemplateResult } from "lit";
import { frame } from "../view/icons.js";
import type { PictureStores } from "./picture-sheet.js";

/** `scheme`: the colours that the playground has. */
export function pictureButton(playground: PictureStores, scheme: () => "light" | "dark"): TemplateResult {
  const open = async ({ currentTarget }: Event) => {
    const part = currentTarget as Element;
    const { PictureSheet } = await import("./picture-sheet.js");
    new PictureSheet(playground, scheme()).open(part);
  };
  return html`<button type="button" class="save-picture" title="Save what the boards show as a picture"
    ?disabled=${playground.boards.document.value === null} @click=${(event: Event) => void open(event)}>
    ${frame}<span>Save picture</span>
  </button>`;
}
