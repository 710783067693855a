// The problem of a question in words: what the observers are told, which no picture shows, and all the rest to be opened.
import { html, nothing, type TemplateResult } from "lit";
import type { Question } from "../core.js";
import type { DeliveryDocument, FloorDocument } from "../problem/types.js";
import { deliveryInWords } from "./words/delivery.js";
import { type ExplicitWords, explicitInWords } from "./words/explicit.js";
import { floorInWords } from "./words/floor.js";
import { type PddlWords, pddlInWords } from "./words/pddl.js";
import type { InWords, Sentence, Verbatim } from "./words/sensor.js";
import { parted } from "./words/told.js";

const TOLD = "What the observers are told";
const WORDS = "The problem in words";

export function problemInWords(question: Question): TemplateResult {
  const { sentences, texts = [], told } = wordsOf(question);
  const { shown, rest } = parted(told);
  const more = rest.sentences.length > 0 || (rest.texts ?? []).length > 0;
  return html`<div class="words">
    ${list(shown, TOLD)}
    ${
      more
        ? html`<p class="signs">${shown.length === 0 ? `${TOLD} stands` : "More of what they are told stands"} in “${WORDS}”.</p>`
        : nothing
    }
    <details><summary>${WORDS}</summary>
      ${list(sentences)} ${texts.map(openable)}
      ${more ? html`<p>${TOLD}:</p>${list(rest.sentences)} ${(rest.texts ?? []).map(openable)}` : nothing}
    </details>
  </div>`;
}

/** All of it, with nothing to be opened. */
export function wordsOnPaper(question: Question): TemplateResult {
  const { sentences, texts = [], told } = wordsOf(question);
  return html`<section class="words on-paper" aria-label=${WORDS}>
    <div><h3>${TOLD}</h3>${list(told.sentences)}</div>
    <div><h3>${WORDS}</h3>${list(sentences)}</div>
    ${[...(told.texts ?? []), ...texts].map(printed)}
  </section>`;
}

function list(sentences: readonly Sentence[], label: string | null = null): TemplateResult | typeof nothing {
  if (sentences.length === 0) return nothing;
  return html`<ul class=${label === null ? nothing : "told"} aria-label=${label ?? nothing}>${sentences.map(
    (sentence) =>
      typeof sentence === "string"
        ? html`<li>${sentence}</li>`
        : html`<li>${sentence.said}<ul>${sentence.each.map((one) => html`<li>${one}</li>`)}</ul></li>`,
  )}</ul>`;
}

const openable = ({ title, text }: Verbatim): TemplateResult =>
  html`<details><summary>${title}</summary><pre tabindex="0">${text}</pre></details>`;

const printed = ({ title, text }: Verbatim): TemplateResult =>
  html`<div class="verbatim"><h3>${title}</h3><pre>${text}</pre></div>`;

type Words = FloorDocument | DeliveryDocument | PddlWords | ExplicitWords;

function wordsOf({ document, kind }: Question): InWords {
  // Whoever guesses the goal must not read which it is.
  const { true_goal, ...rest } = document as { true_goal?: string };
  return inWords((kind === "guess" ? rest : document) as Words);
}

function inWords(document: Words): InWords {
  switch (document.format) {
    case "delivery":
      return deliveryInWords(document);
    case "pddl":
      return pddlInWords(document);
    case "explicit":
      return explicitInWords(document);
    default:
      return floorInWords(document);
  }
}
