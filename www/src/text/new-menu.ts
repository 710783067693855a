// A menu of documents to begin with.
import { html, type TemplateResult } from "lit";
import { templates } from "./templates.js";

/** `use` takes the text of the one that is chosen. */
export function newMenu(use: (text: string) => void): TemplateResult {
  const choose = (text: string) => (event: Event) => {
    const menu = (event.currentTarget as Element).closest("details");
    menu?.removeAttribute("open");
    menu?.querySelector("summary")?.focus();
    use(text);
  };
  return html`<details class="new-menu" @keydown=${closeByKey} @focusout=${closeBehind}>
    <summary>New</summary>
    <div class="menu">
      ${templates.map(
        ({ title, about, text }) =>
          html`<button type="button" @click=${choose(text)}>${title}<small>${about}</small></button>`,
      )}
    </div>
  </details>`;
}

function closeByKey(event: KeyboardEvent): void {
  const menu = event.currentTarget as HTMLDetailsElement;
  if (event.key !== "Escape" || !menu.open) return;
  event.stopPropagation();
  menu.open = false;
  menu.querySelector("summary")?.focus();
}

function closeBehind(event: FocusEvent): void {
  const menu = event.currentTarget as HTMLDetailsElement;
  if (event.relatedTarget instanceof Node && !menu.contains(event.relatedTarget)) menu.open = false;
}
