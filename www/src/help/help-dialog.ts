// The help: all keys, and what the words mean.
import { html, render, type TemplateResult } from "lit";
import { besidePlayground } from "../view/beside.js";
import { closeAround, openModal } from "../view/dialog.js";
import { cross } from "../view/icons.js";
import { type Definition, glossary } from "./glossary.js";
import { type KeyGroup, keyGroups } from "./keys.js";
import type { Term } from "./terms.js";

/** The dialog of each tree: the page's own, and one in the shadow root of each playground that has one. */
const dialogs = new WeakMap<Node, HTMLDialogElement>();

/** Opens the dialog, at a term of the glossary if one is named. */
export function showHelp(term: Term | undefined, part: Element): void {
  const root = part.getRootNode();
  let dialog = dialogs.get(root);
  if (dialog === undefined) {
    dialog = made();
    dialogs.set(root, dialog);
    besidePlayground(part).append(dialog);
  }
  if (!dialog.open) openModal(dialog);
  if (term !== undefined) showTerm(dialog, term);
  else dialog.scrollTop = 0;
}

function made(): HTMLDialogElement {
  const element = document.createElement("dialog");
  element.className = "sheet help";
  element.setAttribute("aria-labelledby", "mo-copp-help");
  element.addEventListener("click", closeAround);
  render(content(), element);
  return element;
}

function showTerm(dialog: HTMLElement, term: Term): void {
  const entry = dialog.querySelector<HTMLElement>(`[data-entry="${term}"]`);
  entry?.scrollIntoView({ block: "start" });
  entry?.focus({ preventScroll: true });
}

function content(): TemplateResult {
  return html`<form method="dialog" class="sheet-head">
      <h2 id="mo-copp-help">Help</h2>
      <button class="sign" aria-label="Close">${cross}</button>
    </form>
    <p>An agent walks to its true goal while an enemy and a friend watch, each through a poor sensor of its own. The
      boards show what both believe after every step. A good plan leaves the enemy many goals and the friend one.</p>
    <nav aria-label="Parts of the help" class="parts-of-help">
      ${part("Keys", "keys")} ${part("Words", "words")}
    </nav>
    <section data-part="keys" tabindex="-1" aria-labelledby="mo-copp-help-keys">
      <h3 id="mo-copp-help-keys">Keys</h3>
      <div class="key-groups">${keyGroups.map(group)}</div>
    </section>
    <section data-part="words" tabindex="-1" aria-labelledby="mo-copp-help-words">
      <h3 id="mo-copp-help-words">Words</h3>
      <p>The symbols are those of the paper: A. Kulkarni, S. Srivastava and S. Kambhampati, “Signaling Friends and
        Head-Faking Enemies Simultaneously: Balancing Goal Obfuscation and Goal Legibility” (2020).</p>
      <dl class="glossary">${glossary(see).map(definition)}</dl>
    </section>`;
}

const part = (title: string, name: string): TemplateResult =>
  html`<button type="button" class="link" @click=${(event: Event) => {
    const section = dialogAround(event)?.querySelector<HTMLElement>(`[data-part="${name}"]`);
    section?.scrollIntoView({ block: "start" });
    section?.focus({ preventScroll: true });
  }}>${title}</button>`;

const group = ({ title, where, keys }: KeyGroup): TemplateResult => html`<table class="keys">
  <caption>${title} <small>${where}</small></caption>
  <tbody>
    ${keys.map((row) => html`<tr><th scope="row">${row.keys.map((key) => html`<kbd>${key}</kbd> `)}</th><td>${row.does}</td></tr>`)}
  </tbody>
</table>`;

const definition = ({ term, name, symbol, meaning, source }: Definition): TemplateResult => html`<div
  data-entry=${term} tabindex="-1">
  <dt>${name}${symbol === undefined ? "" : html` <span class="math">${symbol}</span>`}</dt>
  <dd>${meaning}${source === undefined ? "" : html` <small>${source}</small>`}</dd>
</div>`;

/** From one definition to another. */
const see = (term: Term, text: string): TemplateResult =>
  html`<button type="button" class="term" @click=${(event: Event) => {
    const dialog = dialogAround(event);
    if (dialog !== null) showTerm(dialog, term);
  }}>${text}</button>`;

const dialogAround = (event: Event): HTMLDialogElement | null => (event.currentTarget as Element).closest("dialog");
