// Saving pictures, as a dialog: which boards, how they look, and the picture as it will be.
import { effect, type Signal, signal } from "@preact/signals-core";
import { html, nothing, render, type TemplateResult } from "lit";
import type { Gallery } from "../gallery/gallery.js";
import type { Boards } from "../state/boards.js";
import type { Pictures } from "../state/pictures.js";
import type { Timeline } from "../state/timeline.js";
import { besidePlayground } from "../view/beside.js";
import { closeAround, openModal } from "../view/dialog.js";
import { download } from "../view/download.js";
import { cross } from "../view/icons.js";
import { imageAddress } from "../view/image-address.js";
import { png } from "./png.js";

export interface PictureStores {
  boards: Boards;
  timeline: Timeline;
  gallery: Gallery;
  pictures: Pictures;
}

const boardChoices = {
  all: "All three boards",
  actor: "What the agent does",
  adversarial: "What the enemy believes",
  cooperative: "What the friend believes",
} as const;
type BoardChoice = keyof typeof boardChoices;

/** What a file's name says of its boards. */
const inName: Record<BoardChoice, string> = { all: "", actor: "-agent", adversarial: "-enemy", cooperative: "-friend" };

const schemes = { light: "Light", dark: "Dark" } as const;
type Scheme = keyof typeof schemes;

type Kind = "svg" | "png" | "walk";

type Preview = { svg: string; description: string } | { problem: string } | null;

/** What an image means that the browser does not show. */
const NOT_SHOWN = "This page’s content policy shows no preview (img-src data:).";

export class PictureSheet {
  private readonly board = signal<BoardChoice>("all");
  private readonly captions = signal(true);
  private readonly scheme: Signal<Scheme>;
  private readonly preview = signal<Preview>(null);
  private readonly said = signal("");
  private readonly dialog = document.createElement("dialog");
  /** How often a preview was asked for: only the last one counts. */
  private asked = 0;

  constructor(
    private readonly stores: PictureStores,
    scheme: Scheme,
  ) {
    this.scheme = signal(scheme);
  }

  /** Opens it for the playground that `part` is in. */
  open(part: Element): void {
    const { dialog } = this;
    this.stores.timeline.pause();
    dialog.className = "sheet picture-sheet";
    dialog.setAttribute("aria-labelledby", "mo-copp-pictures");
    dialog.addEventListener("click", closeAround);
    const place = besidePlayground(part);
    place.append(dialog);
    const stops = [
      effect(() => this.look()),
      effect(() => {
        render(this.content(), dialog);
      }),
    ];
    dialog.addEventListener("close", () => {
      for (const stop of stops) stop();
      place.remove();
    });
    openModal(dialog);
  }

  private draw(all: boolean): Promise<string> {
    const [board, captions, theme] = [this.board.value, this.captions.value, this.scheme.value];
    return this.stores.pictures.draw({ board, captions, theme, ...(all ? { animate: true } : {}) });
  }

  /** Draws the preview, again with everything that changes it. */
  private look(): void {
    this.asked += 1;
    const now = this.asked;
    const show = (preview: Preview) => {
      if (now === this.asked) this.preview.value = preview;
    };
    this.draw(false).then(
      (svg) => show({ svg, description: descriptionOf(svg) }),
      (error: Error) => show({ problem: error.message }),
    );
  }

  private async save(kind: Kind): Promise<void> {
    const name = this.fileName(kind);
    this.said.value = "Drawing…";
    try {
      const svg = await this.draw(kind === "walk");
      if (kind === "png") download(await png(svg), "image/png", name);
      else download(svg, "image/svg+xml", name);
      this.said.value = `Saved: ${name}`;
    } catch (error) {
      this.said.value = (error as Error).message;
    }
  }

  private fileName(kind: Kind): string {
    const { gallery, timeline } = this.stores;
    const which = kind === "walk" ? "walk" : `step-${timeline.step.value}`;
    return `${gallery.fileName.value}${inName[this.board.value]}-${which}.${kind === "png" ? "png" : "svg"}`;
  }

  private content(): TemplateResult {
    const { timeline } = this.stores;
    const [step, last] = [timeline.step.value, timeline.lastStep.value];
    return html`<form method="dialog" class="sheet-head">
        <h2 id="mo-copp-pictures">Save a picture</h2>
        <button class="sign" aria-label="Close">${cross}</button>
      </form>
      <div class="preview" aria-busy=${String(this.preview.value === null)}>${this.image()}</div>
      <div class="choices">
        ${choice("Boards", boardChoices, this.board)} ${choice("Colours", schemes, this.scheme)}
        <label class="check"><input type="checkbox" .checked=${this.captions.value}
          @change=${({ target }: Event) => {
            this.captions.value = (target as HTMLInputElement).checked;
          }} /><span>Headings, symbols and goals</span></label>
      </div>
      <div class="actions">
        ${this.button("svg", html`Step ${step} as SVG`, true)} ${this.button("png", html`Step ${step} as PNG`)}
        ${last === 0 ? nothing : this.button("walk", html`All ${last} steps as animated SVG`)}
      </div>
      <p class="said" role="status">${this.said.value}</p>`;
  }

  private image(): TemplateResult | string {
    const shown = this.preview.value;
    if (shown === null) return "";
    if ("problem" in shown) return html`<p>${shown.problem}</p>`;
    const failed = () => {
      this.preview.value = { problem: NOT_SHOWN };
    };
    return html`<img src=${imageAddress(shown.svg)} alt=${shown.description} @error=${failed} />`;
  }

  private button(kind: Kind, title: TemplateResult, first = false): TemplateResult {
    return html`<button type="button" class=${first ? "primary" : ""} @click=${() => void this.save(kind)}>${title}</button>`;
  }
}

/** What the picture says of itself to those who do not see it. */
const descriptionOf = (svg: string): string =>
  new DOMParser().parseFromString(svg, "image/svg+xml").querySelector("desc")?.textContent ?? "";

function choice<Name extends string>(
  title: string,
  choices: Record<Name, string>,
  chosen: Signal<Name>,
): TemplateResult {
  const names = Object.keys(choices) as Name[];
  return html`<label><span>${title}</span>
    <select @change=${({ target }: Event) => {
      chosen.value = (target as HTMLSelectElement).value as Name;
    }}>
      ${names.map((name) => html`<option value=${name} ?selected=${name === chosen.value}>${choices[name]}</option>`)}
    </select>
  </label>`;
}
