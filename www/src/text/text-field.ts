// A text field for JSON or PDDL: CodeMirror in a shadow root.
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching, indentOnInput, type LanguageSupport } from "@codemirror/language";
import { Compartment, EditorState, type Text } from "@codemirror/state";
import { type Command, drawSelection, EditorView, keymap, lineNumbers } from "@codemirror/view";
import { colours } from "./colours.js";
import type { Mark } from "./fault.js";
import { faultMarks, goToFault, showFault } from "./fault-marks.js";
import { faultPanel } from "./fault-panel.js";
import { insertLines } from "./insert-lines.js";
import { selectAll } from "./select-all.js";

/** Longer lines are not wrapped: only what is seen of one is drawn then. */
const LONGEST_WRAPPED = 4000;

export interface Settings {
  /** The name for those who hear it. */
  label: string;
  /** What is said below it where nothing is wrong in it. */
  fine: string;
  language: LanguageSupport;
  /** The person changed the text. */
  changed: () => void;
  /** The person wants the text to be used. */
  submit: () => void;
  /** The person wants to see what is wrong; it may be in another field. */
  next: () => void;
}

export class TextField {
  /** What stands in the page. */
  readonly element = document.createElement("div");
  private readonly view: EditorView;
  private readonly wrapping = new Compartment();
  /** The text that was asked for last, and what the field made of it. */
  private known: { doc: Text; text: string } | null = null;

  constructor(private readonly settings: Settings) {
    this.element.className = "text-field";
    const root = this.element.attachShadow({ mode: "open" });
    this.view = new EditorView({ root, parent: root, state: this.state("") });
  }

  get text(): string {
    const { doc } = this.view.state;
    if (this.known?.doc !== doc) this.known = { doc, text: doc.toString() };
    return this.known.text;
  }

  get doc(): Text {
    return this.view.state.doc;
  }

  /** Another text takes the place of this one and of all that was done to it. */
  show(text: string): void {
    if (this.text === text) return;
    const { anchor } = this.view.state.selection.main;
    const { scrollTop } = this.view.scrollDOM;
    this.view.setState(this.state(text));
    this.view.dispatch({ selection: { anchor: Math.min(anchor, this.doc.length) } });
    this.view.scrollDOM.scrollTop = scrollTop;
  }

  /** Another text takes the place of this one, as if it had been typed: the field's undo brings this one back. */
  replace(text: string): void {
    this.view.dispatch({
      changes: { from: 0, to: this.doc.length, insert: text },
      selection: { anchor: 0 },
      scrollIntoView: true,
      userEvent: "input.paste",
    });
  }

  mark(mark: Mark | null): void {
    showFault(this.view, mark);
  }

  /** Puts the cursor at what is wrong; false where nothing is. */
  goToFault(): boolean {
    return goToFault(this.view);
  }

  private state(text: string): EditorState {
    const { label, fine, language, submit, next } = this.settings;
    const run = (action: () => void) => () => {
      action();
      return true;
    };
    return EditorState.create({
      doc: text,
      extensions: [
        keymap.of([
          { key: "Mod-Enter", run: run(submit) },
          { key: "F8", run: run(next) },
          // Whoever has no mouse leaves with Escape, then Tab.
          { key: "Escape", run: tabLeaves(true) },
        ]),
        lineNumbers(),
        faultMarks,
        faultPanel(fine),
        history(),
        drawSelection(),
        indentOnInput(),
        bracketMatching(),
        language,
        colours,
        this.wrapping.of(wraps(text) ? EditorView.lineWrapping : []),
        keymap.of([...defaultKeymap, ...historyKeymap, indentWithTab]),
        EditorView.contentAttributes.of({
          "aria-label": label,
          tabindex: "0",
          spellcheck: "false",
          autocapitalize: "off",
        }),
        insertLines,
        selectAll(() => this.view),
        EditorView.domEventHandlers({
          // The page takes files.
          drop: (event) => event.dataTransfer?.types.includes("Files") ?? false,
          blur: (_, view) => tabLeaves(false)(view),
        }),
        EditorView.updateListener.of(({ docChanged, transactions }) => {
          if (docChanged && transactions.length > 0) this.typed();
        }),
      ],
    });
  }

  private typed(): void {
    this.view.setTabFocusMode(false);
    const wrapped = this.view.lineWrapping;
    if (wrapped !== wraps(this.text)) {
      this.view.dispatch({ effects: this.wrapping.reconfigure(wrapped ? [] : EditorView.lineWrapping) });
    }
    this.settings.changed();
  }
}

/** Whether Tab goes on to the next control, or indents. Whatever else the key is for is done as well. */
const tabLeaves =
  (leaves: boolean): Command =>
  (view) => {
    view.setTabFocusMode(leaves);
    return false;
  };

function wraps(text: string): boolean {
  for (let from = 0; from < text.length; ) {
    const end = text.indexOf("\n", from);
    const to = end === -1 ? text.length : end;
    if (to - from > LONGEST_WRAPPED) return false;
    from = to + 1;
  }
  return true;
}
