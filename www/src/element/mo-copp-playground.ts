// <mo-copp-playground>: it is drawn into a shadow root, so that no style of the page reaches what is in it, and none of
// its own the page. Only on the stand-alone page, which is the playground's own, it is drawn into the document
// (`root="page"`). docs/embedding.md lists attributes, properties, events and parts.
import { adopt } from "./adopt.js";
import { PlaygroundElement } from "./playground-element.js";
import { Theme } from "./theme.js";
import type { View } from "./view.js";

/** What there is before the view: room for it, so that playgrounds that wait for their turn are not all in sight. */
const frame = `
:host { display: block; }
:host([hidden]) { display: none !important; }
.mo-copp-part { all: initial; display: block; visibility: inherit; pointer-events: inherit; }
.mo-copp-part.waiting { min-height: 30rem; }
.mo-copp-part.waiting.has-poster { display: none; }
slot { display: none; }
slot.poster { display: contents; }
.failure { margin: 0; padding: 0.75rem; font: 1rem / 1.45 system-ui, sans-serif; }
`;

export class MoCoppPlayground extends PlaygroundElement {
  private root: HTMLElement | null = null;
  private slotted: HTMLElement | null = null;
  private theme: Theme | null = null;

  override connectedCallback(): void {
    super.connectedCallback();
    this.theme?.connect();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.theme?.disconnect();
  }

  override attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    super.attributeChangedCallback(name, before, after);
    if (name === "theme") this.theme?.update();
  }

  protected override makeRoot(): HTMLElement {
    if (this.root !== null) return this.root;
    if (this.getAttribute("root") === "page") {
      this.root = this;
      this.theme = new Theme(this, this, false);
      return this;
    }
    const shadow = this.attachShadow({ mode: "open" });
    adopt(shadow, "frame", frame);
    const root = document.createElement("div");
    root.className = "mo-copp-part waiting";
    root.setAttribute("part", "playground");
    root.lang = "en";
    root.dir = "ltr";
    // The page's own children of the element stand for the picture until there is one, and where there can be none.
    const poster = [...this.children].some((child) => !(child instanceof HTMLScriptElement));
    root.classList.toggle("has-poster", poster);
    this.slotted = document.createElement("slot");
    this.slotted.className = "poster";
    shadow.append(this.slotted, root);
    this.root = root;
    this.theme = new Theme(this, root, true);
    return root;
  }

  protected override async load(): Promise<typeof View> {
    if (this.root === this) return (await import("./view.js")).View;
    const { View, styles } = await import("./shadow-view.js");
    const shadow = this.shadowRoot;
    if (shadow !== null) for (const [name, text] of styles) adopt(shadow, name, text);
    this.root?.replaceChildren();
    return View;
  }

  protected override shown(): void {
    super.shown();
    this.root?.classList.remove("waiting", "has-poster");
    // Where nothing could be drawn, the poster stays beside the word of why.
    if (this.slotted !== null && this.root?.querySelector("[data-board], .stage") !== null) this.slotted.className = "";
  }

  protected override failed(again: () => void): void {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = "Try again";
    button.addEventListener("click", again);
    const text = document.createElement("p");
    text.className = "failure";
    text.setAttribute("role", "alert");
    text.append("The playground could not be loaded. Check the connection, then try again. ", button);
    this.root?.replaceChildren(text);
    this.root?.classList.remove("waiting", "has-poster");
    this.dataset.status = "error";
  }
}
