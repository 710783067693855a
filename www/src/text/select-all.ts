// Who selects all by the browser's own means, as on a phone, selects the lines that are drawn. All are meant.
import { EditorSelection, EditorState, type Extension } from "@codemirror/state";
import type { EditorView } from "@codemirror/view";

export const selectAll = (view: () => EditorView): Extension =>
  EditorState.transactionFilter.of((transaction) => {
    if (transaction.docChanged || !transaction.isUserEvent("select") || transaction.selection === undefined) {
      return transaction;
    }
    const { from, to } = transaction.selection.main;
    const { length } = transaction.startState.doc;
    const drawn = view().viewport;
    const all = from === 0 && drawn.from === 0 && to >= drawn.to && to < length;
    return all ? [transaction, { selection: EditorSelection.single(0, length) }] : transaction;
  });
