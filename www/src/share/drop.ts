// Files dropped on the page.
import { signal } from "@preact/signals-core";
import { html, type TemplateResult } from "lit";
import { inField } from "../view/typing.js";
import { type FileStores, openFile } from "./files.js";

type DropStores = FileStores;

export class DropTarget {
  /** A file is being dragged over it. */
  readonly over = signal(false);
  private target: EventTarget | null = null;
  private leaving: ReturnType<typeof setTimeout> | undefined;

  /** `refusal`: why no file may be opened now; null where one may. */
  constructor(
    private readonly playground: DropStores,
    readonly refusal: () => string | null,
  ) {}

  /** Takes what is dropped on `target`: the whole page, or the playground alone. */
  listen(target: EventTarget): void {
    this.release();
    this.target = target;
    for (const [type, listener] of this.listeners) target.addEventListener(type, listener);
  }

  release(): void {
    for (const [type, listener] of this.listeners) this.target?.removeEventListener(type, listener);
    this.target = null;
    clearTimeout(this.leaving);
  }

  private readonly dragged = (event: Event) => {
    const { dataTransfer } = event as DragEvent;
    if (event.defaultPrevented) {
      this.pass();
      return;
    }
    if (dataTransfer === null || inText(event)) return;
    event.preventDefault();
    dataTransfer.dropEffect = this.refusal() === null ? "copy" : "none";
    clearTimeout(this.leaving);
    this.over.value = dataTransfer.types.includes("Files");
  };

  /** Also comes when a part of the page is left for another: then it is over that at once. */
  private readonly left = () => {
    clearTimeout(this.leaving);
    this.leaving = setTimeout(() => {
      this.over.value = false;
    }, 100);
  };

  /** What another playground, or the page around it, has taken is not for this one. */
  private pass(): void {
    clearTimeout(this.leaving);
    this.over.value = false;
  }

  private readonly dropped = (event: Event) => {
    const { dataTransfer } = event as DragEvent;
    this.pass();
    if (event.defaultPrevented || dataTransfer === null || inText(event)) return;
    event.preventDefault();
    const refused = this.refusal();
    if (refused === null) void this.take(dataTransfer);
    else this.playground.solving.remark(refused);
  };

  private readonly listeners: readonly [string, (event: Event) => void][] = [
    ["dragenter", this.dragged],
    ["dragover", this.dragged],
    ["dragleave", this.left],
    ["drop", this.dropped],
  ];

  private async take({ items, files }: DataTransfer): Promise<void> {
    const folder = [...items].some((item) => item.webkitGetAsEntry?.()?.isDirectory === true);
    const [file] = files;
    if (folder) this.playground.solving.refuse("That is a folder. Drop one problem document, a .json file.");
    else if (file === undefined)
      this.playground.solving.refuse("That is no file. Drop one problem document, a .json file.");
    else if (files.length > 1)
      this.playground.solving.refuse(`Those are ${files.length} files. Drop one problem document at a time.`);
    else await openFile(this.playground, file);
  }
}

/** Text can be dragged into a text field, as everywhere. */
function inText(event: Event): boolean {
  return inField(event) && !((event as DragEvent).dataTransfer?.types ?? []).includes("Files");
}

export function dropSign(target: DropTarget): TemplateResult | "" {
  if (!target.over.value) return "";
  return html`<div class="drop"><p>${target.refusal() ?? "Drop the problem document here"}</p></div>`;
}
