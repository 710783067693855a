// The button that copies a link to what is shown, and says whether it did.
import { signal } from "@preact/signals-core";
import { html, type TemplateResult } from "lit";
import type { OpenProblem } from "../state/open-problem.js";
import { copy } from "../view/clipboard.js";
import { chain, tick } from "../view/icons.js";
import type { Address } from "./address.js";

interface CopyLinkStores {
  problem: OpenProblem;
}

type Said = { kind: "nothing" } | { kind: "copied" } | { kind: "yours"; link: string } | { kind: "too long" };

const SHOWN_MS = 2500;

export class LinkCopier {
  readonly said = signal<Said>({ kind: "nothing" });
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly address: Address) {}

  async copy(): Promise<void> {
    // Browsers let a page use the clipboard at the click itself, not much later.
    const link = this.address.present() ?? (await this.address.link());
    if (link === null) this.say({ kind: "too long" });
    else this.say((await copy(link)) ? { kind: "copied" } : { kind: "yours", link });
  }

  say(said: Said): void {
    clearTimeout(this.timer);
    this.said.value = said;
    if (said.kind === "copied") this.timer = setTimeout(() => this.say({ kind: "nothing" }), SHOWN_MS);
  }
}

export function copyLink(playground: CopyLinkStores, copier: LinkCopier): TemplateResult {
  const said = copier.said.value;
  return html`<div class="copy-link">
    <button type="button" title="Copy a link to the problem, the plan and the step as they are shown"
      ?disabled=${playground.problem.document.value === null} @click=${() => void copier.copy()}>
      ${said.kind === "copied" ? tick : chain}<span>${said.kind === "copied" ? "Copied" : "Copy link"}</span>
    </button>
    <div role="status">${words(said, copier)}</div>
  </div>`;
}

function words(said: Said, copier: LinkCopier): TemplateResult | string {
  if (said.kind === "copied") return html`<span class="unseen">The link is on the clipboard.</span>`;
  if (said.kind === "too long") {
    return html`<p>This problem is too large for a link. Save the document as a file instead (tab “Document”).</p>`;
  }
  if (said.kind === "nothing") return "";
  return html`<label class="link-field">
    <span>The page may not use the clipboard: copy the link from here.</span>
    <input type="text" readonly .value=${said.link} @focus=${(event: Event) => (event.target as HTMLInputElement).select()} />
    <button type="button" @click=${() => copier.say({ kind: "nothing" })}>Done</button>
  </label>`;
}
