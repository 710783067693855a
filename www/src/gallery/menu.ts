// The gallery as a dialog: a card for each problem, with its picture and what it shows.
import { html, type TemplateResult } from "lit";
import type { Workbench } from "../state/workbench.js";
import { closeAround, openModal } from "../view/dialog.js";
import { cross } from "../view/icons.js";
import { playgroundAround } from "../view/surroundings.js";
import { type Entry, entries } from "./entries.js";
import type { Gallery } from "./gallery.js";
import { thumbnail } from "./thumbnail.js";

export interface MenuStores {
  gallery: Gallery;
  workbench: Workbench;
}

export function galleryMenu(playground: MenuStores): TemplateResult {
  const { gallery } = playground;
  const id = `${playground.workbench.id}-gallery`;
  return html`<dialog class="sheet gallery" aria-labelledby=${id} @click=${closeAround}
    @close=${() => {
      gallery.menuOpen.value = false;
    }}>
    <form method="dialog" class="sheet-head">
      <h2 id=${id}>Problems</h2>
      <button class="sign" aria-label="Close">${cross}</button>
    </form>
    <ul class="cards">
      ${gallery.menuOpen.value ? entries.map((entry) => card(playground, entry)) : ""}
    </ul>
  </dialog>`;
}

function card(playground: MenuStores, entry: Entry): TemplateResult {
  const { gallery } = playground;
  const document = gallery.documents.value.get(entry.name);
  const current = gallery.current.value === entry;
  return html`<li>
    <button type="button" class="problem" aria-current=${current ? "true" : "false"}
      @click=${(event: Event) => {
        (event.currentTarget as HTMLElement).closest("dialog")?.close();
        void gallery.open(entry.name);
      }}>
      ${document === undefined ? html`<span class="thumbnail"></span>` : thumbnail(document.value)}
      <span class="words"><b class="title">${entry.title}</b><span class="about">${entry.about}</span></span>
    </button>
  </li>`;
}

/** Opens the dialog of the playground that `part` is in. */
export function openGallery(playground: MenuStores, part: Element): void {
  const { gallery } = playground;
  gallery.menuOpen.value = true;
  void gallery.load();
  const dialog = playgroundAround(part)?.querySelector<HTMLDialogElement>("dialog.gallery");
  if (dialog) openModal(dialog);
}
