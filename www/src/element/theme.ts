// Light or dark: as the attribute `theme` says, or as the page is. Pages say it by their computed color-scheme, or by
// the switch of the tool that they are made with; where a page says nothing, its ground does.

export const themes = ["light", "dark", "auto"] as const;
export type Scheme = "light" | "dark";

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
    const around = ancestors(this.host);
    const said = getComputedStyle(around[0] ?? document.documentElement).colorScheme;
    const own = document.querySelector<HTMLMetaElement>("meta[name=color-scheme]")?.content ?? "";
    const words = said === "normal" ? own : said;
    // Slides are often dark without saying so.
    return words === "" ? groundOf(around) : fromColorScheme(words, this.system?.matches === true);
  }
}

/** The colours that a playground has now. */
export function schemeOf({ dataset }: HTMLElement): Scheme {
  if (dataset.scheme === "light" || dataset.scheme === "dark") return dataset.scheme;
  return globalThis.matchMedia?.("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

/** Tells the colours that a playground has, now and when they change, until the function that is returned is called. */
export function followScheme(host: HTMLElement, told: (scheme: Scheme) => void): () => void {
  const system = globalThis.matchMedia?.("(prefers-color-scheme: dark)");
  const tell = () => told(schemeOf(host));
  const observer = new MutationObserver(tell);
  observer.observe(host, { attributeFilter: ["data-scheme"] });
  system?.addEventListener("change", tell);
  tell();
  return () => {
    observer.disconnect();
    system?.removeEventListener("change", tell);
  };
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

function fromColorScheme(said: string, systemDark: boolean): Scheme {
  const words = said.split(/\s+/);
  if (!words.includes("dark")) return "light";
  return words.includes("light") && !systemDark ? "light" : "dark";
}

/** Of 255: a ground that is darker is better met by light text. */
const DARK = 80;

/** As dark as what is painted behind it; a page that paints nothing is light, whatever the system. */
function groundOf(around: readonly Element[]): Scheme {
  for (const element of around) {
    const [red = 0, green = 0, blue = 0, alpha = 1] = (
      getComputedStyle(element).backgroundColor.match(/^rgba?\((.*)\)$/)?.[1] ?? "0, 0, 0, 0"
    )
      .split(/[\s,/]+/)
      .map(Number);
    if (alpha > 0.5) return 0.2126 * red + 0.7152 * green + 0.0722 * blue < DARK ? "dark" : "light";
  }
  return "light";
}
