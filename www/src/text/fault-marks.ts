// Shows what is wrong at its place: the words underlined, a sign beside the line and the message under it.
import { type EditorState, type Extension, MapMode, RangeSet, StateEffect, StateField } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView, GutterMarker, gutter, WidgetType } from "@codemirror/view";
import type { Mark } from "./fault.js";

const show = StateEffect.define<Mark | null>();

/** While the text changes the mark stays with its words, until the core has read the new text. */
const shown = StateField.define<Mark | null>({
  create: () => null,
  update(mark, transaction) {
    for (const effect of transaction.effects) if (effect.is(show)) return effect.value;
    if (mark === null || !transaction.docChanged) return mark;
    const from = transaction.changes.mapPos(mark.from, 1, MapMode.TrackDel);
    // What it was about is gone.
    if (from === null) return null;
    return { ...mark, from, to: Math.max(from, transaction.changes.mapPos(mark.to, -1)) };
  },
});

export const faultOf = (state: EditorState): Mark | null => state.field(shown);

export function showFault(view: EditorView, mark: Mark | null): void {
  const before = faultOf(view.state);
  const same = before?.message === mark?.message && before?.from === mark?.from && before?.to === mark?.to;
  if (!same) view.dispatch({ effects: show.of(mark) });
}

/** Puts the cursor at what is wrong. */
export function goToFault(view: EditorView): boolean {
  const mark = faultOf(view.state);
  if (mark === null) return false;
  view.focus();
  view.dispatch({
    selection: { anchor: mark.from },
    effects: EditorView.scrollIntoView(mark.from, { y: "center" }),
  });
  return true;
}

class Message extends WidgetType {
  constructor(private readonly message: string) {
    super();
  }

  override eq(other: Message): boolean {
    return other.message === this.message;
  }

  override toDOM(): HTMLElement {
    const element = document.createElement("div");
    element.className = "cm-fault-message";
    element.append(document.createElement("span"));
    (element.firstChild as Element).textContent = this.message;
    return element;
  }

  override ignoreEvent(): boolean {
    return false;
  }
}

const words = Decoration.mark({ class: "cm-fault" });
const wholeLine = Decoration.line({ class: "cm-fault-line" });

function decorations(state: EditorState): DecorationSet {
  const mark = faultOf(state);
  if (mark === null) return Decoration.none;
  const line = state.doc.lineAt(mark.from);
  // Where something is missing, what stands before it is underlined.
  const to = Math.min(mark.to, line.to);
  const from = to > mark.from ? mark.from : Math.max(line.from, mark.from - 1);
  const message = Decoration.widget({ widget: new Message(mark.message), block: true, side: 1 });
  const ranges = [wholeLine.range(line.from), message.range(line.to)];
  if (from < Math.max(to, mark.from)) ranges.push(words.range(from, Math.max(to, mark.from)));
  return Decoration.set(ranges, true);
}

class Sign extends GutterMarker {
  override toDOM(): Node {
    return document.createTextNode("!");
  }
}

const sign = new Sign();

const signs = gutter({
  class: "cm-fault-gutter",
  markers: ({ state }) => {
    const mark = faultOf(state);
    return mark === null ? RangeSet.empty : RangeSet.of([sign.range(state.doc.lineAt(mark.from).from)]);
  },
  lineMarkerChange: (update) => faultOf(update.startState) !== faultOf(update.state),
});

export const faultMarks: Extension = [shown, EditorView.decorations.compute([shown, "doc"], decorations), signs];
