// Ways to hand an exercise out: tried as a student, as a link, as code for a page, as a file.
import { html, nothing, type TemplateResult } from "lit";
import type { ProblemDocument } from "../problem/types.js";
import { LONGEST_LINK, MOST_TEXT, pack } from "../share/packed.js";
import { restore } from "../share/restore.js";
import { stateOf } from "../share/shared-state.js";
import { download } from "../view/download.js";
import { isSound, objectionWords } from "./objections.js";
import { shownOn } from "./shown.js";
import type { AuthorPanelStores } from "./stores.js";

const words = { "": "", copied: "Copied.", refused: "The page may not use the clipboard: copy the text from here." };

export function handOut(playground: AuthorPanelStores): TemplateResult {
  const { exerciseDraft: draft } = playground;
  const links = playground.links.value;
  const link = ({ begin }: NonNullable<typeof links>) =>
    html`<button type="button" @click=${() => void checked(playground, (text) => copyLink(playground, begin(), text))}>Copy a link</button>`;
  return html`<div class="actions">
      <button type="button" class="primary" @click=${() => void attempt(playground)}>Try it as a student</button>
      ${links === null ? nothing : link(links)}
      <button type="button" @click=${() => void checked(playground, (text) => copyText(playground, codeOf(text)))}>Copy code for a page</button>
      <button type="button" @click=${() => void checked(playground, save)}>Save as a file</button>
    </div>
    <p role="alert">${objection(playground)}</p>
    <p role="status">${words[draft.copier.said.value]}</p>
    ${
      draft.shown.value === ""
        ? ""
        : html`<label>To copy <textarea readonly rows="3" .value=${draft.shown.value}
            @focus=${(event: Event) => (event.target as HTMLTextAreaElement).select()}></textarea></label>`
    }`;
}

/** What was said of this exercise; of another step or problem it says nothing. */
function objection(playground: AuthorPanelStores): string {
  const { fields, objection } = playground.exerciseDraft;
  const said = objection.value;
  if (said === null || said.text !== documentOf(playground)) return "";
  const { difference, atMost, attempts, kind } = fields.value;
  return objectionWords(said, { goal_difference: difference, at_most: atMost, attempts }, kind);
}

/** The document with its exercise; null while there is none. */
export function documentOf(playground: AuthorPanelStores): string | null {
  const shown = shownOn(playground);
  if (shown === null) return null;
  const { exercise: _, ...document } = shown.document as ProblemDocument & { exercise?: unknown };
  return JSON.stringify({ ...document, exercise: playground.exerciseDraft.block(shown) }, null, 2);
}

/** An exercise that is wrong stays in the form, with the word of why; one that is trivial, has poor variants or a long list of states, until it is asked for again. */
async function checked(playground: AuthorPanelStores, handOn: (text: string) => unknown): Promise<void> {
  const text = documentOf(playground);
  if (text === null) return;
  const { exercise, exerciseDraft: draft } = playground;
  const known = draft.objection.value;
  const proof = await exercise.prove(text);
  if (proof === null) return;
  const warned = known?.text === text && known.fault === null;
  const sound = isSound(proof);
  const right = sound || (proof.fault === null && warned);
  draft.objection.value = sound ? null : { text, ...proof };
  if (right) await handOn(text);
}

function attempt(playground: AuthorPanelStores): Promise<void> {
  const { exerciseDraft: draft, exercise, edits } = playground;
  // The step too: it is what the question is about.
  const before = stateOf(playground);
  return checked(playground, async (text) => {
    const back = () => {
      exercise.close();
      if (before !== null) void restore(playground, before);
    };
    draft.tried.value = { text, before: before === null ? null : JSON.stringify(before), back };
    if (!(await edits.open(text))) draft.tried.value = null;
  });
}

const save = (text: string) => download(`${text}\n`, "application/json", "exercise.json");

async function copyLink(playground: AuthorPanelStores, address: string, document: string): Promise<void> {
  const state = JSON.stringify({ document, form: {}, step: 0, tab: "", mode: "plan" });
  const packed = state.length > MOST_TEXT ? null : await pack(state);
  if (packed === null || packed.length > LONGEST_LINK) {
    playground.exerciseDraft.shown.value = "This problem is too large for a link: save it as a file instead.";
    return;
  }
  await copyText(playground, `${address}#${packed}`);
}

async function copyText({ exerciseDraft: draft }: AuthorPanelStores, text: string): Promise<void> {
  await draft.copier.copy(text);
  draft.shown.value = draft.copier.said.value === "refused" ? text : "";
}

/** The element's script and the element with the document in it. `<` would end a script. */
const codeOf = (
  document: string,
): string => `<!-- The folder mo-copp is the folder dist of a release, beside the page. -->
<script type="module" src="mo-copp/mo-copp-playground.js"></script>
${"vary" in JSON.parse(document).exercise ? '<!-- seed="7" or student="NAME" in the next line: the variant of a number or a name. -->\n' : ""}<mo-copp-playground link="off" name="answer">
<script type="application/json">
${document.replaceAll("<", "\\u003c")}
</script>
</mo-copp-playground>
`;
