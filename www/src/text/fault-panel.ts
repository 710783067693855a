// The line below a text field that says what is wrong and leads there. It is read out when it changes.
import type { Extension } from "@codemirror/state";
import { EditorView, type Panel, showPanel, type ViewUpdate } from "@codemirror/view";
import { faultOf, goToFault } from "./fault-marks.js";

const ID = "faults";

const panel =
  (fine: string) =>
  (view: EditorView): Panel => {
    const dom = document.createElement("div");
    dom.className = "cm-faults";
    const text = document.createElement("p");
    text.id = ID;
    text.setAttribute("role", "status");
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = "Go to the error (F8)";
    button.addEventListener("click", () => goToFault(view));
    dom.append(text, button);
    const say = () => {
      const mark = faultOf(view.state);
      const line = mark === null ? 0 : view.state.doc.lineAt(mark.from).number;
      const named = mark !== null && /\bline \d/.test(mark.message);
      const words = mark === null ? fine : `Error${named ? "" : ` in line ${line}`}: ${mark.message}`;
      if (text.textContent !== words) text.textContent = words;
      // It stays where it is, or would not be read out when there is something to say.
      dom.classList.toggle("cm-silent", words === "");
      button.hidden = mark === null;
    };
    say();
    const update = ({ startState, state, docChanged }: ViewUpdate) => {
      if (docChanged || faultOf(startState) !== faultOf(state)) say();
    };
    return { dom, update };
  };

const described = EditorView.contentAttributes.of(({ state }) =>
  faultOf(state) === null ? null : { "aria-invalid": "true", "aria-describedby": ID },
);

/** `fine` is said where nothing is wrong. */
export const faultPanel = (fine: string): Extension => [showPanel.of(panel(fine)), described];
