// How PDDL is coloured and indented. Whether it is right the core says.
import { LanguageSupport, StreamLanguage } from "@codemirror/language";

/** The column behind which each open bracket's content stands. */
interface Nesting {
  open: number[];
}

const words = /^(?:define|and|or|not|imply|forall|exists|when|either)$/i;
const number = /^-?\d+(?:\.\d+)?$/;

const pddlLanguage = StreamLanguage.define<Nesting>({
  name: "pddl",
  startState: () => ({ open: [] }),
  copyState: ({ open }) => ({ open: [...open] }),
  token(stream, state) {
    if (stream.eatSpace()) return null;
    const next = stream.next();
    if (next === ";") {
      stream.skipToEnd();
      return "comment";
    }
    if (next === "(") {
      state.open.push(stream.column() + 2);
      return "bracket";
    }
    if (next === ")") {
      state.open.pop();
      return "bracket";
    }
    stream.eatWhile(/[^\s();]/);
    const word = stream.current();
    if (word.startsWith(":")) return "keyword";
    if (word.startsWith("?")) return "variableName";
    if (number.test(word)) return "number";
    return words.test(word) ? "operatorKeyword" : null;
  },
  indent: ({ open }) => open.at(-1) ?? 0,
  languageData: { commentTokens: { line: ";" }, indentOnInput: /^\s*\)$/ },
});

export const pddl = (): LanguageSupport => new LanguageSupport(pddlLanguage);
