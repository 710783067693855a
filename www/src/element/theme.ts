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

/** A switch may be a field or a button that styles ask for by `:has(…)`, a ground may fade, and a style sheet come later. What none of these tells, theme-probe.ts feels. */
const events = ["change", "click", "load", "transitionend"] as const;

export class Theme {
  private readonly system = globalThis.matchMedia?.("(prefers-color-scheme: dark)");
  private readonly around = new MutationObserver(() => this.soon());
  private readonly sheets = new MutationObserver((records) => {
    const added = records.flatMap(({ addedNodes }) => [...addedNodes]);
    const { body, head } = this.page;
    if (added.some((node) => node === body || node === head)) this.again();
    else if ([...added, ...records.flatMap(({ removedNodes }) => [...removedNodes])].some(isStyling)) this.soon();
  });
  private frame = 0;
  /** The document that it is in; it may move into another. */
  private page = globalThis.document;

  constructor(
    private readonly host: HTMLElement,
    private readonly root: HTMLElement,
    /** Whether the page is another's; the stand-alone page follows the system by its styles. */
    private readonly guest: boolean,
  ) {}

  connect(): void {
    this.page = this.host.ownerDocument;
    this.update();
    this.system?.addEventListener("change", this.changed);
    // A load does not bubble.
    for (const name of events) this.page.addEventListener(name, this.changed, true);
    // A page's styles may go by any attribute.
    for (const around of ancestors(this.host)) this.around.observe(around, { attributes: true });
    // What is written into a sheet of the head; a page that is still being built may have no head yet, and no body.
    const { documentElement, head } = this.page;
    if (head !== null)
      this.around.observe(head, { attributes: true, childList: true, subtree: true, characterData: true });
    this.sheets.observe(documentElement, { childList: true, subtree: true });
  }

  disconnect(): void {
    this.system?.removeEventListener("change", this.changed);
    for (const name of events) this.page.removeEventListener(name, this.changed, true);
    this.around.disconnect();
    this.sheets.disconnect();
    cancelAnimationFrame(this.frame);
    this.frame = 0;
  }

  /** The page has parts that it did not have. */
  private again(): void {
    this.disconnect();
    this.connect();
  }

  update(): void {
    const asked = this.host.getAttribute("theme");
    const chosen = asked === "light" || asked === "dark" ? asked : null;
    if (!this.guest) {
      for (const element of [this.host, this.page.body]) if (element !== null) setScheme(element, chosen);
      return;
    }
    const scheme = chosen ?? this.ofPage();
    for (const element of [this.root, this.host]) setScheme(element, scheme);
  }

  private readonly changed = ({ type, target }: Event) => {
    if (type !== "load" || isStyling(target as Node)) this.soon();
  };

  /** Before the page is painted the next time: what changes often is looked at once. */
  soon(): void {
    if (this.frame !== 0) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.update();
    });
  }

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
    const said = getComputedStyle(around[0] ?? this.page.documentElement).colorScheme;
    const own = this.page.querySelector<HTMLMetaElement>("meta[name=color-scheme]")?.content ?? "";
    const words = said === "normal" ? own : said;
    // Slides are often dark without saying so.
    return words === "" ? groundOf(around) : fromColorScheme(words, this.system?.matches === true);
  }
}

/** Whether a node is a style sheet, or brings one. */
const isStyling = (node: Node): boolean =>
  isElement(node) && (node.matches("style, link") || node.querySelector("style, link") !== null);

/** Of whichever window: what is in another has classes of its own. */
const isElement = (node: Node): node is Element => node.nodeType === Node.ELEMENT_NODE;

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
  return parent !== null && "host" in parent && !isElement(parent)
    ? (parent as ShadowRoot).host
    : element.parentElement;
}

function fromColorScheme(said: string, systemDark: boolean): Scheme {
  const words = said.split(/\s+/);
  if (!words.includes("dark")) return "light";
  return words.includes("light") && !systemDark ? "light" : "dark";
}

/** Of 1: a ground that is darker is better met by light text. */
const DARK = 0.31;
/** The same grey as a lightness of OKLab, and of CIELAB (of 100). */
const DARK_OK = 0.43;
const DARK_LAB = 34;

/** As dark as what is painted behind it; a page that paints nothing is light, whatever the system. */
function groundOf(around: readonly Element[]): Scheme {
  for (const element of around) {
    const { backgroundColor, backgroundImage } = getComputedStyle(element);
    const dark = isDarkGradient(backgroundImage) ?? isDark(backgroundColor);
    if (dark !== null) return dark ? "dark" : "light";
    // What a picture shows can't be known, but text on it is meant to be read.
    if (/\burl\(|\bimage-set\(/.test(backgroundImage))
      return isDark(getComputedStyle(element).color) ? "light" : "dark";
  }
  return "light";
}

/** Of the nearest gradient of a ground: as most of its colours are; null where they let through what is behind. */
function isDarkGradient(image: string): boolean | null {
  for (const [gradient] of image.matchAll(/gradient\((?:[^()]|\([^()]*\))*\)/g)) {
    const colours = gradient.match(/\b(?:rgba?|color|ok(?:lab|lch)|lab|lch)\([^()]*\)/g) ?? [];
    const seen = colours.map(isDark).filter((dark) => dark !== null);
    if (seen.length * 2 > colours.length) return seen.filter((dark) => dark).length * 2 > seen.length;
  }
  return null;
}

/** Of a colour as it is computed; null where it lets through what is behind it. */
function isDark(colour: string): boolean | null {
  const [, space = "", values = ""] = /^(\w+)\((.*)\)$/.exec(colour) ?? [];
  const [channels = "", behind] = values.split("/");
  const numbers = channels
    .split(/[\s,]+/)
    .map(Number)
    .filter((number) => !Number.isNaN(number));
  const [first = 0, second = 0, third = 0, fourth] = numbers;
  const alpha = behind === undefined ? (fourth ?? 1) : Number(behind);
  if (numbers.length === 0 || alpha <= 0.5) return null;
  if (space.startsWith("ok")) return first < DARK_OK;
  if (space === "lab" || space === "lch") return first < DARK_LAB;
  const luma = 0.2126 * first + 0.7152 * second + 0.0722 * third;
  return (space.startsWith("rgb") ? luma / 255 : luma) < DARK;
}
