// The problem of a question in words: what the picture shows, and what the observers are told of each action.
import { html, nothing, type TemplateResult } from "lit";
import type { Question } from "../core.js";
import type { DeliveryDocument, FloorDocument } from "../problem/types.js";
import { deliveryInWords } from "./words/delivery.js";
import { type ExplicitWords, explicitInWords } from "./words/explicit.js";
import { floorInWords } from "./words/floor.js";
import { type PddlWords, pddlInWords } from "./words/pddl.js";
import type { InWords } from "./words/sensor.js";

export function problemInWords({ document, kind }: Question): TemplateResult {
  // Whoever guesses the goal must not read which it is.
  const { true_goal, ...rest } = document as { true_goal?: string };
  const { sentences, texts = [] } = inWords((kind === "guess" ? rest : document) as Words);
  return html`<details><summary>The problem in words</summary>
    <ul>${sentences.map((sentence) =>
      typeof sentence === "string"
        ? html`<li>${sentence}</li>`
        : html`<li>${sentence.said}<ul>${sentence.each.map((one) => html`<li>${one}</li>`)}</ul></li>`,
    )}</ul>
    ${
      texts.length === 0
        ? nothing
        : texts.map(
            ({ title, text }) => html`<details><summary>${title}</summary><pre tabindex="0">${text}</pre></details>`,
          )
    }
  </details>`;
}

type Words = FloorDocument | DeliveryDocument | PddlWords | ExplicitWords;

function inWords(document: Words): InWords {
  switch (document.format) {
    case "delivery":
      return { sentences: deliveryInWords(document) };
    case "pddl":
      return pddlInWords(document);
    case "explicit":
      return explicitInWords(document);
    default:
      return { sentences: floorInWords(document) };
  }
}
