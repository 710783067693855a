// What stands below the picture of what the observers are told, and what is too long for that.
import type { Sentence, Told } from "./sensor.js";

/** More letters than these are a text to look things up in. */
const MOST = 600;

const lengthOf = (sentence: Sentence): number =>
  typeof sentence === "string" ? sentence.length : sentence.said.length + sentence.each.join("").length;

/** The longest sentences go into the rest, until the others are short. */
export function parted({ sentences, texts = [] }: Told): { shown: readonly Sentence[]; rest: Told } {
  let left = sentences.reduce((sum, sentence) => sum + lengthOf(sentence), 0);
  const long = new Set<Sentence>();
  for (const sentence of [...sentences].sort((one, other) => lengthOf(other) - lengthOf(one))) {
    if (left <= MOST) break;
    long.add(sentence);
    left -= lengthOf(sentence);
  }
  const part = (isLong: boolean) => sentences.filter((sentence) => long.has(sentence) === isLong);
  return { shown: part(false), rest: { sentences: part(true), texts } };
}
