// What stands behind the # of an address: a playground's state, or a place of the page.

/** Whether a fragment begins as `pack` writes it; one of a newer version is known by all that it has. */
export const isOwn = (fragment: string): boolean => /^(?:1\.|\d{1,6}\.[\w-]{40,}\.[a-z0-9]+$)/.test(fragment);

/** Whether the page has the place that a fragment names, as a browser finds it (HTML, "find a potential indicated element"). */
export function leadsSomewhere(fragment: string): boolean {
  return [fragment, decoded(fragment)].some(
    (name) =>
      name.toLowerCase() === "top" ||
      document.getElementById(name) !== null ||
      document.querySelector(`a[name="${CSS.escape(name)}"]`) !== null,
  );
}

function decoded(fragment: string): string {
  try {
    return decodeURIComponent(fragment);
  } catch {
    return fragment;
  }
}
