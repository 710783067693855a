// The form that makes an exercise of the open problem: its kind, what is locked and hidden, what varies, and ways to hand
// it out.
import { html, nothing, type TemplateResult } from "lit";
import { type DraftFields, hidesBeliefs } from "../state/exercise-draft.js";
import {
  asksAboutWalk,
  type Kind,
  kindsOf,
  placesOf,
  type Shown,
  subjectOf,
  type Vary,
  variableOf,
} from "../state/exercise-subject.js";
import { counted } from "../view/numbers.js";
import { called, roles } from "../view/observers.js";
import { area, check, select, text } from "./fields.js";
import { handOut } from "./hand-out.js";
import { shownOn } from "./shown.js";
import type { AuthorPanelStores } from "./stores.js";

const kindWords: Record<Kind, string> = {
  "possible-goals": "Which goals are possible",
  belief: "Where the agent can be",
  walk: "A walk that is good enough",
  best: "The best walk",
  placement: "Place something in a cell",
  guess: "Guess the goal",
};

/** Where a state is more than a cell. */
const STATES = "Which states are possible";

const varyWords: Record<Vary, string> = {
  start: "the start",
  goals: "the goals",
  walls: "the walls",
  true_goal: "the true goal",
  plan: "the walk",
};

const variants = {
  link: "A link asks each student for a name or number, and the question is the one that belongs to it.",
  page: "A page of your own says whose question it is by the attribute student or seed.",
};

const marks = html`<details><summary>Marks</summary>
  <p>An answer that was checked has a code, which students hand in. <code>mo-copp grade exercise.json codes.csv</code> checks
    every answer again and writes a table with scores; with <code>--student COLUMN</code> it also sees whether the question was
    that of the name in the column.</p>
  <p>A code proves that this answer was given to this question. It does not prove who gave it, when, or with whose help.</p>
</details>`;

export function authorPanel(playground: AuthorPanelStores): TemplateResult {
  const { exerciseDraft: draft } = playground;
  const shown = shownOn(playground);
  if (shown === null) return html`<p>An exercise is made of a problem with a plan: open one.</p>`;
  const fields = draft.fitting(shown.document);
  const about = asksAboutWalk(fields.kind);
  return html`<div class="author">
    ${select(
      "Kind of question",
      fields.kind,
      kindsOf(shown.document),
      (kind) => (kind === "belief" && shown.document.format !== "gridworld" ? STATES : kindWords[kind]),
      (kind) => draft.edit({ kind }),
    )}
    ${text("Title", fields.title, (title) => draft.edit({ title }))}
    ${area("Before the question", fields.introduction, (introduction) => draft.edit({ introduction }))}
    ${about ? aboutWalk(playground, fields, shown) : nothing}
    ${fields.kind === "placement" ? placement(playground, fields, shown) : nothing}
    ${
      fields.kind === "walk"
        ? html`${text("Goal difference of at least", subjectOf(fields, shown).difference, (difference) => draft.edit({ difference }))}
          ${text("At most so many steps", fields.atMost, (atMost) => draft.edit({ atMost }))}`
        : nothing
    }
    ${fields.kind === "best" ? check("It must be a shortest one of the best", fields.shortest, (shortest) => draft.edit({ shortest })) : nothing}
    ${area("Hints, one a line", fields.hints, (hints) => draft.edit({ hints }))}
    ${text("Attempts (empty: any number)", fields.attempts, (attempts) => draft.edit({ attempts }))}
    ${check("Lock: the problem cannot be opened without the question", fields.lock, (lock) => draft.edit({ lock }))}
    ${fields.lock ? nothing : lockedKeys(playground, fields)}
    ${check("Hide what the observers believe", hidesBeliefs(fields), (hide) => draft.edit({ hidesBeliefs: hide }))}
    <fieldset><legend>Other for each student</legend>
      ${variableOf(shown.document, fields.kind).map((name) =>
        check(varyWords[name], fields.vary.includes(name), (on) =>
          draft.edit({ vary: toggled(fields.vary, name, on) }),
        ),
      )}
      ${fields.vary.length === 0 ? nothing : html`<p>${playground.links.value?.asksName ? `${variants.link} ` : ""}${variants.page}</p>`}
    </fieldset>
    ${handOut(playground)}
    ${marks}
  </div>`;
}

const solversOpen =
  "Opened without the question, the problem is solved: the solvers, the best values and the best plan are open to students then.";
const solversClosed =
  "Opened without the question, the problem keeps its solvers and best values back until the question is answered or no attempt is left.";

/** Parts of the problem that stay as they are when it is opened without the question. */
function lockedKeys({ problem, exerciseDraft: draft }: AuthorPanelStores, fields: DraftFields): TemplateResult {
  const keys = Object.keys(problem.document.value?.value ?? {}).filter((key) => key !== "format" && key !== "exercise");
  return html`<p class="open-solver">${fields.lockedKeys.length === 0 ? solversOpen : solversClosed}</p>
    <fieldset><legend>Locked all the same, by their keys in the document</legend>
    ${keys.map((key) =>
      check(key.replaceAll("_", " "), fields.lockedKeys.includes(key), (on) =>
        draft.edit({ lockedKeys: toggled(fields.lockedKeys, key, on) }),
      ),
    )}
  </fieldset>`;
}

function aboutWalk({ exerciseDraft: draft }: AuthorPanelStores, fields: DraftFields, shown: Shown): TemplateResult {
  const { observer, step } = subjectOf(fields, shown);
  return html`${select(
    "Whose view",
    observer,
    roles,
    (role) => `the ${called[role]}`,
    (role) => draft.edit({ observer: role }),
  )}
    <p>${whichSteps(fields.kind, step, shown)}</p>`;
}

function whichSteps(kind: Kind, step: number, shown: Shown): string {
  const steps = counted(step, "step");
  if (kind === "guess") return `The question is about all ${steps} of the plan: who guesses must be able to tell.`;
  if (shown.step > 0)
    return `The question is about the ${steps} shown on the boards: go to the step that is to be asked about.`;
  const which = step === shown.steps.length - 1 ? `all ${steps}` : `the first ${steps}`;
  return `The question is about ${which} of the plan; to ask about others, go to the step on the boards.`;
}

function placement({ exerciseDraft: draft }: AuthorPanelStores, fields: DraftFields, shown: Shown): TemplateResult {
  const { place, goal } = subjectOf(fields, shown);
  return html`${select(
    "What is placed",
    place,
    placesOf(shown.document),
    (place) => place,
    (place) => draft.edit({ place }),
  )}
    ${select(
      "Goal",
      goal,
      shown.goals,
      (name) => name,
      (goal) => draft.edit({ goal }),
    )}
    ${check("The goal must be possible then", fields.possible, (possible) => draft.edit({ possible }))}`;
}

const toggled = (list: readonly string[], name: string, on: boolean): string[] =>
  on ? [...list, name] : list.filter((other) => other !== name);
