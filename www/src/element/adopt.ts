// Styles for shadow roots: one sheet for all roots of a page, made by script, which no content policy forbids.

const sheets = new Map<string, CSSStyleSheet>();

export function adopt(root: ShadowRoot, name: string, text: string): void {
  if (!("adoptedStyleSheets" in root)) {
    const style = document.createElement("style");
    style.textContent = text;
    (root as ShadowRoot).prepend(style);
    return;
  }
  let sheet = sheets.get(name);
  if (sheet === undefined) {
    sheet = new CSSStyleSheet();
    sheet.replaceSync(text);
    sheets.set(name, sheet);
  }
  if (!root.adoptedStyleSheets.includes(sheet)) root.adoptedStyleSheets = [...root.adoptedStyleSheets, sheet];
}
