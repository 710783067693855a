// All documents of the gallery, in one chunk that is loaded when the page has something to show.
const files = import.meta.glob<string>("../../problems/*.json", { query: "?raw", import: "default", eager: true });

/** The text of each document, by its name. */
export const documents: ReadonlyMap<string, string> = new Map(
  Object.entries(files).map(([path, text]) => [path.replace(/^.*\/|\.json$/g, ""), text]),
);
