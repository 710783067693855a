// Light or dark: as the attribute `theme` says, or as the page is. Pages say it by their computed color-scheme, or by
// the switch of the tool that they are made with.

export const themes = ["light", "dark", "auto"] as const;
type Scheme = "light" | "dark";

/** What switches write: an attribute, and its values. The nearest around the playground counts. */
const switches: readonly [attribute: string, light: RegExp, dark: RegExp][] = [
  // Docusaurus, Pico, pydata-sphinx-theme, Furo.
  ["data-theme", /^light$/, /^dark$/],
  // Bootstrap, Quarto from 1.7 on.
  ["data-bs-theme", /^light$/, /^dark$/],
  // Material for MkDocs: "slate" is its dark scheme.
  ["data-md-color-scheme", /^default$/, /^slate$/],
  // JupyterLab.
  ["data-jp-theme-light", /^true$/, /^false$/],
  // Quarto, reveal.js, and the many that write one word.
  [
    "class",
    /(?:^|\s)(?:quarto-light|has-light-background|light)(?:\s|$)/,
    /(?:^|\s)(?:quarto-dark|has-dark-background|dark)(?:\s|$)/,
  ],
];

export class Theme {
  private readonly system = globalThis.matchMedia?.("(prefers-color-scheme: dark)");
  private readonly observer = new MutationObserver(() => this.update());

  constructor(
    private readonly host: HTMLElement,
    private readonly root: HTMLElement,
    /** Whether the page is another's; the stand-alone page follows the system by its styles. */
    private readonly guest: boolean,
  ) {}

  connect(): void {
    this.update();
    this.system?.addEventListener("change", this.changed);
    // A switch may also load or leave out a style sheet.
    const attributes = {
      attributes: true,
      attributeFilter: [...switches.map(([name]) => name), "style", "media", "disabled", "rel"],
    };
    for (const around of ancestors(this.host)) this.observer.observe(around, attributes);
    this.observer.observe(document.head, { ...attributes, childList: true, subtree: true });
  }

  disconnect(): void {
    this.system?.removeEventListener("change", this.changed);
    this.observer.disconnect();
  }

  update(): void {
    const asked = this.host.getAttribute("theme");
    const chosen = asked === "light" || asked === "dark" ? asked : null;
    if (!this.guest) {
      for (const element of [this.host, document.body]) setScheme(element, chosen);
      return;
    }
    const scheme = chosen ?? this.ofPage();
    for (const element of [this.root, this.host]) setScheme(element, scheme);
  }

  private readonly changed = () => this.update();

  private ofPage(): Scheme {
    for (const around of ancestors(this.host)) {
      for (const [name, light, dark] of switches) {
        const value = around.getAttribute(name);
        if (value === null) continue;
        if (dark.test(value)) return "dark";
        if (light.test(value)) return "light";
      }
    }
    const parent = ancestors(this.host)[0] ?? document.documentElement;
    return fromColorScheme(getComputedStyle(parent).colorScheme, this.system?.matches === true);
  }
}

function setScheme({ dataset }: HTMLElement, scheme: Scheme | null): void {
  if (scheme === null) delete dataset.scheme;
  else if (dataset.scheme !== scheme) dataset.scheme = scheme;
}

/** From the nearest to the root, out of shadow roots too. */
function ancestors(element: Element): Element[] {
  const found: Element[] = [];
  for (let at = around(element); at !== null; at = around(at)) found.push(at);
  return found;
}

function around(element: Element): Element | null {
  if (element.assignedSlot !== null) return element.assignedSlot;
  const parent = element.parentNode;
  return parent instanceof ShadowRoot ? parent.host : element.parentElement;
}

/** A page that says nothing is light, whatever the system: so is what the browser draws of it. */
function fromColorScheme(computed: string, systemDark: boolean): Scheme {
  const own = document.querySelector<HTMLMetaElement>("meta[name=color-scheme]")?.content ?? "";
  const words = (computed === "normal" ? own : computed).split(/\s+/);
  if (!words.includes("dark")) return "light";
  return words.includes("light") && !systemDark ? "light" : "dark";
}
