// Text that takes the place of several lines, or brings several, and comes neither from the keyboard nor from the
// clipboard, as from dictation. Left to itself the browser would put it in with style attributes, which the page's policy
// forbids.
import { EditorView } from "@codemirror/view";

/** Chromium tells nobody outside of a shadow root what is selected in it, and has this instead. */
function selected(root: DocumentOrShadowRoot): AbstractRange | null {
  const selection = (root as Partial<Pick<Document, "getSelection">>).getSelection?.() ?? null;
  return selection !== null && selection.rangeCount > 0 ? selection.getRangeAt(0) : null;
}

/** Not all lines are drawn. Who selects all by the browser's own means ends behind those that are. */
function endsUndrawn({ endContainer, endOffset }: AbstractRange, { contentDOM }: EditorView): boolean {
  const end = endContainer === contentDOM ? contentDOM.childNodes[endOffset - 1] : endContainer;
  const last = contentDOM.lastElementChild;
  return last?.matches(".cm-gap") === true && last.contains(end ?? null);
}

export const insertLines = EditorView.domEventHandlers({
  beforeinput(event, view) {
    const text = event.data;
    if (event.isComposing || text === null) return false;
    const range = event.getTargetRanges()[0] ?? selected(view.root);
    if (range === null || (range.collapsed && text.length < 2)) return false;
    const { state } = view;
    const from = view.posAtDOM(range.startContainer, range.startOffset);
    const to = endsUndrawn(range, view) ? state.doc.length : view.posAtDOM(range.endContainer, range.endOffset);
    view.dispatch({
      changes: { from, to, insert: state.toText(text) },
      selection: { anchor: from + state.toText(text).length },
      scrollIntoView: true,
      userEvent: "input.type",
    });
    event.preventDefault();
    return true;
  },
});
