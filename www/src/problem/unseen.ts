// Characters of a name that the eye can't see: they take no room of their own, or turn the text around. Two names could
// look alike by them, or one like nothing at all.

/** Where such characters belong to what is seen: emoji of several parts, and letters of scripts that join. */
const seen = [
  "\\p{Extended_Pictographic}\\u{fe0f}?(?:\\u{200d}\\p{Extended_Pictographic}\\u{fe0f}?)*",
  "[0-9#*]\\u{fe0f}\\u{20e3}",
  "(?<=[\\p{Script=Arabic}\\p{Script=Syriac}\\p{Script=Devanagari}\\p{Script=Bengali}\\p{Script=Malayalam}\\p{Script=Sinhala}\\p{Script=Kannada}\\p{Script=Telugu}\\p{Script=Tamil}])[\\u{200c}\\u{200d}](?=\\p{Letter})",
].join("|");

/** Controls, format characters, separators of lines, fillers, and what chooses between forms of a letter. */
const unseen =
  "[\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}\\u{34f}\\u{115f}\\u{1160}\\u{17b4}\\u{17b5}\\u{180b}-\\u{180f}\\u{2800}\\u{3164}\\u{fe00}-\\u{fe0f}\\u{ffa0}\\u{e0100}-\\u{e01ef}]";

const either = new RegExp(`(${seen})|${unseen}`, "gu");
const some = new RegExp(unseen, "u");

const code = (character: string): string =>
  `U+${(character.codePointAt(0) ?? 0).toString(16).toUpperCase().padStart(4, "0")}`;

/** The same name with every character that can't be seen written as its number. */
export const visible = (name: string): string =>
  some.test(name)
    ? name.replace(either, (character, whole: string | undefined) => whole ?? `⟨${code(character)}⟩`)
    : name;

/** The numbers of the characters that can't be seen. */
export function unseenIn(name: string): string[] {
  if (!some.test(name)) return [];
  return [...name.matchAll(either)].flatMap(([character, whole]) => (whole === undefined ? [code(character)] : []));
}
