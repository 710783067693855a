// Pictures that stand for a figure of the article until it runs, and where it cannot: one for each board and theme, drawn by the core.
import { Problem } from "./core.mjs";
import { documentOf, planOf } from "./figures.mjs";
import { escaped } from "./text.mjs";

const themes = ["light", "dark"];

const captions = {
  adversarial: "What the enemy believes",
  actor: "The agent",
  cooperative: "What the friend believes",
};

/** What a picture says in words, for each board: the core describes the step, then the enemy's belief and the friend's. */
function wordsOf(picture) {
  const text = /<desc>(.*?)<\/desc>/s.exec(picture)?.[1] ?? "";
  const sentence = (start) => new RegExp(`${start}[^.]*\\.`).exec(text)?.[0] ?? "";
  return {
    step: /^(.*?)\s*(?=The enemy believes)/s.exec(text)?.[1] ?? text,
    adversarial: sentence("The enemy believes"),
    actor: "The agent’s board.",
    cooperative: sentence("The friend believes"),
  };
}

/** The words of a story of one observer, which is no enemy and counts no goals. */
const ofOne = ({ step, adversarial, ...rest }) => ({
  ...rest,
  step: step.replace(/ Possible goals:.*$/s, ""),
  adversarial: adversarial.replace("The enemy believes", "The observer believes").replace(/, with the goals.*$/s, "."),
});

/** The poster of a step of a plan: its HTML, and the pictures that it shows, by file name. */
export function poster(name, plan, step, boards) {
  const problem = new Problem(documentOf(name));
  const actions = planOf(name, plan);
  const files = new Map();
  const file = (board, theme) => {
    const called = `${name}-${plan}-${step}-${board}-${theme}.svg`;
    files.set(called, problem.picture(actions, { step, board, theme, captions: false }));
    return `./figures/${called}`;
  };
  const all = wordsOf(problem.picture(actions, { step }));
  const words = boards.length < 3 ? ofOne(all) : all;
  const size = (address) => {
    const [, width, height] = /width="([\d.]+)" height="([\d.]+)"/.exec(files.get(address.split("/").at(-1))) ?? [];
    return `width="${width}" height="${height}"`;
  };
  const image = (theme, address, alt) =>
    `<img class="${theme}" src="${address}" alt="${alt}" ${size(address)}${theme === "dark" ? ' loading="lazy"' : ""} />`;
  const pictures = boards.map((board) => {
    const [light, dark] = themes.map((theme) => file(board, theme));
    return `<div class="board ${board}"><p>${boards.length < 3 && board !== "actor" ? "What the observer believes" : captions[board]}</p>${image("light", light, words[board])}${image("dark", dark, words[board])}</div>`;
  });
  problem.free();
  return {
    html: `<div class="poster"><p class="step">${words.step}</p><div class="boards">${pictures.join("")}</div></div>`,
    files,
  };
}

/** A document in the page, as an element reads it. */
export const inlineDocument = (name) =>
  `<script type="application/json">${documentOf(name).trim().replaceAll("<", "\\u003c")}</script>`;

/** The attribute of a plan. */
export const planAttribute = (name, plan) => escaped(planOf(name, plan).join(","));
