// An exercise: its question, a picture, the controls to answer it by, what was said of the answer, and its code.
import type { ReadonlySignal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit";
import type { ExerciseVerdict, Question } from "../core.js";
import type { Edits } from "../state/edits.js";
import type { Exercise } from "../state/exercise.js";
import type { ExerciseDraft } from "../state/exercise-draft.js";
import { imageAddress } from "../view/image-address.js";
import { counted } from "../view/numbers.js";
import { answerForm } from "./answer-form.js";
import { answerOnPaper } from "./answer-on-paper.js";
import { codeField } from "./code-field.js";
import { counterexample } from "./counterexample.js";
import { nameForm } from "./name-form.js";
import { problemInWords, wordsOnPaper } from "./problem-in-words.js";

export interface ExerciseViewStores {
  exercise: Exercise;
  exerciseDraft: Pick<ExerciseDraft, "tried">;
  edits: Pick<Edits, "leaveExercise">;
  /** Nothing can be opened there, and answers are written by hand. */
  onPaper: ReadonlySignal<boolean>;
}

export function exerciseView({ exercise, exerciseDraft, edits, onPaper }: ExerciseViewStores): TemplateResult {
  const posed = exercise.posed.value;
  if (posed === null) return html`<p class="waiting" role="status">Loading the exercise…</p>`;
  const { question } = posed;
  const tried = exerciseDraft.tried.value;
  return html`<section class="card exercise" part="exercise" aria-labelledby="exercise-title" data-kind=${question.kind}
      data-seed=${question.seed}>
    <fieldset class="whole" role="presentation" ?disabled=${exercise.disabled.value}>
    <h2 id="exercise-title">${question.title ?? "Exercise"}</h2>
    ${question.introduction === undefined ? nothing : html`<p class="introduction">${question.introduction}</p>`}
    ${exercise.asksName.value ? nameForm(exercise) : nothing}
    ${exercise.asksName.value && exercise.name.value === null ? unnamed(onPaper.value) : asked(exercise, question, onPaper.value)}
    ${
      tried?.text !== posed.text
        ? nothing
        : html`<p class="way"><button type="button" @click=${() => {
            exerciseDraft.tried.value = null;
            tried.back();
          }}>Back to editing</button></p>`
    }
    ${wayToProblem(exercise, question, edits)}
    </fieldset>
  </section>`;
}

/** Before there is a name there is no question, on paper either. */
const unnamed = (onPaper: boolean): TemplateResult | typeof nothing =>
  onPaper ? html`<p>Each student has another question: give a name on the page, then print it.</p>` : nothing;

/** Where the true goal is to be found, the problem has none to be opened with before. */
function wayToProblem(
  { attempts, foundGoal }: Exercise,
  question: Question,
  edits: ExerciseViewStores["edits"],
): TemplateResult | typeof nothing {
  if (question.lock === true) return nothing;
  if (question.kind !== "guess" || foundGoal.value !== null)
    return html`<p class="way"><button type="button" @click=${() => void edits.leaveExercise()}>Open the problem in the playground</button></p>`;
  const isOver = question.attempts !== undefined && attempts.value >= question.attempts;
  return isOver ? nothing : html`<p class="way">The problem can be opened once its goal is found.</p>`;
}

/** The question with all that belongs to it. */
const asked = (
  exercise: Exercise,
  question: Question,
  onPaper: boolean,
): TemplateResult => html`<p class="question" id="exercise-question">${question.question}</p>
    <div class="asked">
      <div class="picture">${pictures(exercise, question)} ${pictureSigns(exercise, question)} ${problemInWords(question)}</div>
      <form class="answer" aria-describedby="exercise-question" @submit=${(event: Event) => event.preventDefault()}>
        ${onPaper ? answerOnPaper(exercise, question) : nothing} ${answerForm(exercise, question)}
        <div class="actions">
          <button type="button" class="primary" aria-disabled=${String(!exercise.canTry.value)} @click=${() => void exercise.check()}>
            Check the answer</button>
          ${hintButton(exercise, question)}
        </div>
        <p class="tally">${tally(exercise, question)}</p>
        ${hints(exercise, question)}
        <div role="status" class="verdict">${said(exercise)}</div>
        ${codeField(exercise)}
      </form>
    </div>
    ${onPaper ? wordsOnPaper(question) : nothing}`;

const boardNames = { actor: "The agent", adversarial: "The enemy", cooperative: "The friend" };
const boardWords = {
  actor: "Where the agent is",
  adversarial: "What the enemy believes",
  cooperative: "What the friend believes",
};

function pictures(exercise: Exercise, question: Question): TemplateResult {
  const steps = stepsShown(exercise, question);
  const when = steps === 0 ? "before the first step" : `after ${counted(steps, "step")}`;
  return html`<div class="pictures">${exercise.pictures.value.map(
    ({ board, svg }) => html`<figure data-of=${board}>
      <figcaption>${boardNames[board]}</figcaption>
      <img alt="${boardWords[board]}, ${when}" src=${imageAddress(svg)} />
    </figure>`,
  )}</div>`;
}

/** How many steps the pictures show: of the walk that is told, or of the one that is being given. */
const stepsShown = (exercise: Exercise, { form, plan }: Question): number =>
  form.choice === "action" ? exercise.choices.value.length : (plan?.length ?? 0);

/** The faint signs of pictures. `begins`: where something began, which is seen once it is elsewhere. */
const faint: Record<string, readonly { sign: string; begins?: true }[]> = {
  gridworld: [{ sign: "○ start", begins: true }],
  "box-pushing": [
    { sign: "○ start of the robot", begins: true },
    { sign: "□ where the box begins, once it is elsewhere", begins: true },
  ],
  "recycling-robot": [
    { sign: "○ start of the robot", begins: true },
    { sign: "▯ where the can begins, once it is elsewhere", begins: true },
    { sign: "ϟ charger" },
  ],
};

/** What the faint signs of the pictures mean. */
function pictureSigns(exercise: Exercise, question: Question): TemplateResult | typeof nothing {
  const { format = "" } = question.document as { format?: string };
  const signs = (faint[format] ?? []).filter(({ begins }) => !begins || stepsShown(exercise, question) > 0);
  return signs.length === 0 ? nothing : html`<p class="signs">${signs.map(({ sign }) => sign).join(" · ")}</p>`;
}

function tally({ attempts }: Exercise, question: Question): string {
  const made = attempts.value;
  if (question.attempts === undefined) return made === 0 ? "" : `${counted(made, "attempt")} so far.`;
  const left = question.attempts - made;
  return left > 0 ? `${counted(left, "attempt")} left.` : "No attempts left.";
}

function hintButton(exercise: Exercise, question: Question): TemplateResult | typeof nothing {
  const left = question.hints.length - exercise.hints.value;
  if (question.hints.length === 0 || exercise.verdict.value?.right) return nothing;
  return html`<button type="button" aria-disabled=${String(left === 0)} @click=${() => exercise.hint()}>${
    left === 0 ? "No more hints" : `Show a hint (${left} left)`
  }</button>`;
}

function hints(exercise: Exercise, question: Question): TemplateResult | typeof nothing {
  const shown = question.hints.slice(0, exercise.hints.value);
  return html`<ol class="hints" aria-label="Hints" aria-live="polite" ?hidden=${shown.length === 0}>${shown.map(
    (hint) => html`<li>${hint}</li>`,
  )}</ol>`;
}

/** What is said of an answer without any choice. */
const empty = (needsChoice: boolean): string =>
  needsChoice ? "Nothing is chosen yet." : "Nothing is chosen. If that is your answer, check it again.";

function said({ verdict, error, checking, unsure, needsChoice }: Exercise): TemplateResult | string {
  if (checking.value) return "Checking…";
  if (error.value !== null) return html`<p>${error.value}</p>`;
  if (unsure.value) return html`<p>${empty(needsChoice.value)}</p>`;
  return verdict.value === null ? "" : judged(verdict.value);
}

function judged({ right, findings }: ExerciseVerdict): TemplateResult {
  if (right) return html`<p data-verdict="right"><b>Right.</b></p>`;
  return html`<p data-verdict="wrong"><b>Not right.</b></p>
    ${findings.map((finding) => html`<p>${finding.text}</p>${finding.counterexample === undefined ? "" : counterexample(finding.counterexample)}`)}`;
}
