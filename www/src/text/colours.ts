// How the text fields look. They stand in a shadow root: its style sheets are objects, which the page's policy allows;
// what CodeMirror would write into the page's head it forbids. The page's colours reach in as properties.
import { HighlightStyle, syntaxHighlighting } from "@codemirror/language";
import { EditorView } from "@codemirror/view";
import { tags } from "@lezer/highlight";

const look = EditorView.theme({
  "&": {
    color: "var(--ink)",
    background: "var(--card)",
    border: "1px solid var(--control)",
    borderRadius: "0.5rem",
    fontSize: "0.875rem",
    overflow: "hidden",
  },
  "&.cm-focused": { outline: "3px solid var(--focus)", outlineOffset: "2px" },
  ".cm-scroller": {
    fontFamily: "ui-monospace, monospace",
    lineHeight: "1.5",
    minHeight: "var(--text-least, 14rem)",
    maxHeight: "min(var(--text-most, 32rem), 70vh)",
    overflow: "auto",
  },
  ".cm-content": { caretColor: "var(--ink)", padding: "0.5rem 0", minWidth: "0" },
  ".cm-cursor": { borderLeftColor: "var(--ink)", borderLeftWidth: "2px" },
  ".cm-gutters": {
    color: "var(--muted)",
    background: "var(--floor)",
    border: "none",
    borderRight: "1px solid var(--line)",
  },
  ".cm-lineNumbers .cm-gutterElement": { minWidth: "1.8rem", padding: "0 0.35rem 0 0.1rem" },
  "& > .cm-scroller > .cm-selectionLayer .cm-selectionBackground": { background: "var(--line)" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground": { background: "var(--friend-tint)" },
  "&.cm-focused .cm-matchingBracket": { background: "none", outline: "1px solid var(--control)" },
  "&.cm-focused .cm-nonmatchingBracket": { background: "none", outline: "1px dashed var(--error)" },
  ".cm-fault": {
    textDecoration: "underline wavy var(--error)",
    textDecorationSkipInk: "none",
    textUnderlineOffset: "0.2em",
  },
  ".cm-fault-line": { background: "var(--error-tint)" },
  // No margins: the field measures heights without them.
  ".cm-fault-message": { padding: "0.15rem 0.5rem 0.35rem" },
  ".cm-fault-message > span": {
    display: "block",
    padding: "0.3rem 0.6rem",
    borderLeft: "0.3rem solid var(--error)",
    borderRadius: "0.4rem",
    background: "var(--error-tint)",
    color: "var(--error)",
    font: "0.9375rem/1.4 system-ui, sans-serif",
    whiteSpace: "pre-wrap",
    overflowWrap: "anywhere",
  },
  ".cm-fault-gutter .cm-gutterElement": {
    width: "1.1rem",
    color: "var(--error)",
    fontWeight: "700",
    textAlign: "center",
  },
  ".cm-panels": { color: "var(--ink)", background: "var(--floor)", font: "0.875rem/1.4 system-ui, sans-serif" },
  ".cm-panels-bottom": { border: "none" },
  ".cm-faults": {
    display: "flex",
    flexWrap: "wrap",
    alignItems: "center",
    gap: "0.25rem 0.75rem",
    padding: "0.3rem 0.6rem",
    borderTop: "1px solid var(--line)",
  },
  ".cm-silent": { padding: "0", border: "none" },
  ".cm-faults p": { flex: "1 1 10rem", margin: "0", minWidth: "0", overflowWrap: "anywhere" },
  ".cm-faults button": {
    minHeight: "2rem",
    padding: "0.1rem 0.6rem",
    font: "inherit",
    color: "inherit",
    background: "var(--card)",
    border: "1px solid var(--control)",
    borderRadius: "0.4rem",
    cursor: "pointer",
  },
  ".cm-faults button:focus-visible": { outline: "3px solid var(--focus)", outlineOffset: "1px" },
  ".cm-faults [hidden]": { display: "none" },
});

const syntax = HighlightStyle.define([
  { tag: [tags.propertyName, tags.variableName], color: "var(--friend)" },
  { tag: [tags.number, tags.bool, tags.null], color: "var(--focus)" },
  { tag: tags.keyword, color: "var(--focus)", fontWeight: "600" },
  { tag: tags.operatorKeyword, fontWeight: "600" },
  { tag: tags.comment, color: "var(--muted)", fontStyle: "italic" },
  { tag: [tags.bracket, tags.separator], color: "var(--muted)" },
]);

export const colours = [look, syntaxHighlighting(syntax)];
