// What a person is shown once: remembered by the browser, or, where a page may keep nothing, by the page's own entry in the
// history, which a reload keeps.

const inThisPage = new Set<string>();

const keyOf = (name: string): string => `mo-copp ${name}`;

export function wasShown(name: string): boolean {
  if (inThisPage.has(name)) return true;
  try {
    if (localStorage.getItem(keyOf(name)) !== null) return true;
  } catch {
    // No storage for this page.
  }
  const state: unknown = history.state;
  return typeof state === "object" && state !== null && keyOf(name) in state;
}

export function rememberShown(name: string): void {
  inThisPage.add(name);
  try {
    localStorage.setItem(keyOf(name), "shown");
    return;
  } catch {
    // Then for this session.
  }
  try {
    history.replaceState({ ...history.state, [keyOf(name)]: true }, "");
  } catch {
    // A page inside another may not be allowed to: then for this page.
  }
}
