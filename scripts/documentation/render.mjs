// A Markdown document of docs/ as a page of the site.
import { Marked } from "marked";

/** The pages, in the order in which every page lists them: the name of the document, and what the list calls it. */
/** @type {readonly (readonly [string, string])[]} */
export const pages = [
  ["documents", "Problem documents"],
  ["pddl", "PDDL"],
  ["domains", "The paper’s domains"],
  ["experiments", "Experiments"],
  ["benchmarks", "Benchmarks"],
  ["embedding", "In your own page"],
  ["frames", "Frames"],
  ["pictures", "Pictures and print"],
  ["exercises", "Exercises and marks"],
  ["lesson", "A lesson of one hour"],
  ["release", "Releases"],
];

const escaped = (text) =>
  text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");

/** A heading's name in addresses, as the readers of Markdown on the usual hosts make it. */
const anchor = (text) =>
  text
    .toLowerCase()
    .replaceAll(/[^\p{L}\p{N} _-]/gu, "")
    .replaceAll(" ", "-");

/** What stands in a text, without its marks. */
const plain = (tokens) =>
  tokens.map((token) => (token.tokens === undefined ? (token.text ?? "") : plain(token.tokens))).join("");

/** An exercise is opened in the playground of the site; its file stands beside that. */
const toExercise = (name, text) =>
  `<a href="../index.html?src=exercises/${name}.json">${text}</a> (<a href="../exercises/${name}.json" aria-label="file of ${name}">file</a>)`;

const marked = new Marked({
  gfm: true,
  renderer: {
    heading({ tokens, depth }) {
      return `<h${depth} id="${escaped(anchor(plain(tokens)))}">${this.parser.parseInline(tokens)}</h${depth}>\n`;
    },
    link({ href, title, tokens }) {
      const [, exercise] = /^\.\.\/examples\/exercises\/([\w-]+)\.json$/.exec(href) ?? [];
      if (exercise !== undefined) return toExercise(exercise, this.parser.parseInline(tokens));
      // The documents stand beside each other as pages.
      const address = /^[a-z]+:/.test(href) ? href : href.replace(/\.md(?=#|$)/, ".html");
      const titled = title ? ` title="${escaped(title)}"` : "";
      return `<a href="${escaped(address)}"${titled}>${this.parser.parseInline(tokens)}</a>`;
    },
  },
  hooks: {
    // A wide table or program scrolls by itself, with the keyboard too.
    postprocess: (html) => {
      let tables = 0;
      return html
        .replaceAll("<table>", () => {
          tables += 1;
          return `<div class="wide" role="region" aria-label="Table ${tables}" tabindex="0"><table>`;
        })
        .replaceAll("</table>", "</table></div>")
        .replaceAll("<pre>", '<pre tabindex="0">');
    },
  },
});

/** The page of a document, which links to all others. */
export function page(name, markdown) {
  const title = plain(marked.lexer(markdown).filter(({ type }) => type === "heading")[0]?.tokens ?? []);
  const item = ([other, label]) =>
    other === name
      ? `<li><a href="./${other}.html" aria-current="page">${label}</a></li>`
      : `<li><a href="./${other}.html">${label}</a></li>`;
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta
      http-equiv="Content-Security-Policy"
      content="default-src 'none'; style-src 'self'; img-src 'self' data:; base-uri 'none'; form-action 'none'"
    />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <title>${escaped(title)} – mo-copp</title>
    <link rel="icon" type="image/svg+xml" href="../favicon.svg" />
    <link rel="stylesheet" href="./documentation.css" />
  </head>
  <body class="mo-copp-site">
    <nav aria-label="Pages">
      <ul>
        <li><a href="../index.html">Playground</a></li>
        <li><a href="../learn/index.html">The article</a></li>
        ${pages.map(item).join("\n        ")}
      </ul>
    </nav>
    <main>
${marked.parse(markdown)}
    </main>
  </body>
</html>
`;
}
