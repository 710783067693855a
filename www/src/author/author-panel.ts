// The form that makes an exercise of the open problem: its kind, what is locked and hidden, what varies, and ways to hand
// it out.
import { html, nothing, type TemplateResult } from "lit";
import { asksAboutWalk, type DraftFields, hidesBeliefs, kinds, variable } from "../state/exercise-draft.js";
import { counted } from "../view/numbers.js";
import { area, check, select, text } from "./fields.js";
import { handOut } from "./hand-out.js";
import type { AuthorPanelStores } from "./stores.js";

const kindWords: Record<DraftFields["kind"], string> = {
  "possible-goals": "Which goals are possible",
  belief: "Where the agent can be",
  walk: "A walk that is good enough",
  best: "The best walk",
  placement: "Place a camera, a wall or a start",
  guess: "Guess the goal",
};

const varyWords: Record<string, string> = {
  start: "the start",
  goals: "the goals",
  walls: "the walls",
  true_goal: "the true goal",
  plan: "the walk",
};

export function authorPanel(playground: AuthorPanelStores): TemplateResult {
  const { exerciseDraft: draft } = playground;
  const fields = draft.fields.value;
  const about = asksAboutWalk(fields.kind);
  return html`<div class="author">
    ${select(
      "Kind of question",
      fields.kind,
      kinds,
      (kind) => kindWords[kind],
      (kind) => draft.edit({ kind }),
    )}
    ${text("Title", fields.title, (title) => draft.edit({ title }))}
    ${area("Before the question", fields.introduction, (introduction) => draft.edit({ introduction }))}
    ${about ? aboutWalk(playground, fields) : nothing}
    ${fields.kind === "placement" ? placement(playground, fields) : nothing}
    ${
      fields.kind === "walk"
        ? html`${text("Goal difference of at least", fields.difference, (difference) => draft.edit({ difference }))}
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
      ${variable
        .filter((name) => about || name !== "plan")
        .map((name) =>
          check(varyWords[name] ?? name, fields.vary.includes(name), (on) =>
            draft.edit({ vary: toggled(fields.vary, name, on) }),
          ),
        )}
    </fieldset>
    ${handOut(playground)}
  </div>`;
}

/** Parts of the problem that stay as they are when it is opened without the question. */
function lockedKeys({ problem, exerciseDraft: draft }: AuthorPanelStores, fields: DraftFields): TemplateResult {
  const keys = Object.keys(problem.document.value?.value ?? {}).filter((key) => key !== "format" && key !== "exercise");
  return html`<fieldset><legend>Locked all the same, by their keys in the document</legend>
    ${keys.map((key) =>
      check(key.replaceAll("_", " "), fields.lockedKeys.includes(key), (on) =>
        draft.edit({ lockedKeys: toggled(fields.lockedKeys, key, on) }),
      ),
    )}
  </fieldset>`;
}

function aboutWalk({ timeline, exerciseDraft: draft }: AuthorPanelStores, { observer }: DraftFields): TemplateResult {
  const words = { adversarial: "the enemy", cooperative: "the friend" };
  return html`${select(
    "Whose view",
    observer,
    ["adversarial", "cooperative"] as const,
    (role) => words[role],
    (role) => draft.edit({ observer: role }),
  )}
    <p>The question is about the ${counted(timeline.step.value, "step")} shown on the boards: go to the step that is to be asked about.</p>`;
}

function placement({ problem, exerciseDraft: draft }: AuthorPanelStores, fields: DraftFields): TemplateResult {
  const goals = problem.scene.value?.goals.map(({ name }) => name) ?? [];
  return html`${select(
    "What is placed",
    fields.place,
    ["camera", "wall", "start"] as const,
    (place) => place,
    (place) => draft.edit({ place }),
  )}
    ${select(
      "Goal",
      fields.goal === "" ? (goals[0] ?? "") : fields.goal,
      goals,
      (name) => name,
      (goal) => draft.edit({ goal }),
    )}
    ${check("The goal must be possible then", fields.possible, (possible) => draft.edit({ possible }))}`;
}

const toggled = (list: readonly string[], name: string, on: boolean): string[] =>
  on ? [...list, name] : list.filter((other) => other !== name);
