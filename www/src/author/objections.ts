// Why an exercise is not handed out, in the words of the form that makes it.
import type { Proof } from "../state/exercise.js";
import type { Objection } from "../state/exercise-draft.js";
import { asksAboutWalk, type Kind } from "../state/exercise-subject.js";
import { wholeNumber } from "../view/numbers.js";

/** The fields of the form by the keys of the block. */
const fields: Record<string, string> = {
  title: "Title",
  introduction: "Before the question",
  observer: "Whose view",
  goal: "Goal",
  place: "What is placed",
  goal_difference: "Goal difference of at least",
  at_most: "At most so many steps",
  hints: "Hints",
  attempts: "Attempts",
  lock: "Lock",
  vary: "Other for each student",
};

/** What is in the way of an answer, and what can be done about it. */
const reasons: readonly [RegExp, (...found: string[]) => string][] = [
  [
    /^the walk does not end in (.+)$/,
    (_, goal) => `The walk must end in ${goal}: show a plan that does on the boards.`,
  ],
  [
    /^the symbols leave (\d+) goals/,
    (_, count) =>
      `Nobody can tell the goal: ${count} goals fit the symbols. Choose the other view, or show another plan.`,
  ],
  [
    /^no cell answers/,
    () => "No cell is a right answer: choose another goal, another view, or something else to place.",
  ],
  [/^no walk answers/, () => "No walk is as good as that: ask for a smaller goal difference or for more steps."],
];

const again = "Press the button again to hand it out all the same.";

/** More states are a list in which they are searched for. */
const MOST_STATES = 100;

const crowded = (states: number): string =>
  `A student chooses among ${wholeNumber(states)} states: a smaller problem leaves fewer (a smaller floor, more walls, fewer objects), and the question which goals are possible takes none.`;

/** Whether there is nothing to say of an exercise before it is handed out. */
export const isSound = ({ fault, remarks, variants, states }: Proof): boolean =>
  fault === null && remarks.length === 0 && variants.length === 0 && states <= MOST_STATES;

/** `typed`: what stands in fields for numbers, by the keys of the block; `kind`: that of the question. */
export function objectionWords(
  { fault, remarks, variants, states }: Pick<Objection, "fault" | "remarks" | "variants" | "states">,
  typed: Readonly<Record<string, string | null>>,
  kind: Kind,
): string {
  if (fault !== null) return faultWords(fault, typed, kind);
  const said = [
    ...(remarks.length === 0 ? [] : [`This question is trivial: ${remarks.join("; ")}.`]),
    ...(variants.length === 0 ? [] : [`Of what is other for each student: ${variants.join("; ")}.`]),
  ];
  if (states > MOST_STATES) said.push(crowded(states));
  return said.length === 0 ? "" : [...said, again].join(" ");
}

/** What helps where few problems drawn have a question. */
function rarely(kind: Kind, vary: readonly string[]): string {
  if (asksAboutWalk(kind) && !vary.includes("plan"))
    return "The walk is the same for all, and few problems have room for it: let the walk be other, too.";
  const easier = kind === "walk" ? "Ask for a smaller goal difference or for more steps, or let" : "Let";
  return `${easier} ${vary.length > 1 ? "less" : "something else"} be other for each student, or nothing.`;
}

function faultWords(
  { message, path, found, expected }: NonNullable<Objection["fault"]>,
  typed: Readonly<Record<string, string | null>>,
  kind: Kind,
): string {
  const [block, key] = /^exercise(?:\.(\w+))?/.exec(path ?? "") ?? [];
  if (block === undefined || found === undefined || expected === undefined) return message;
  const trivial = /^a question of which (.+)$/.exec(found)?.[1];
  if (trivial !== undefined)
    return `A trivial question cannot be other for each student: ${trivial}. Make it harder, or let nothing be other.`;
  const [, vary, drawn] = /^(.+), where (.+ seeds? drawn .+)$/.exec(found) ?? [];
  if (vary !== undefined && drawn !== undefined)
    return `Some students would get no question: ${drawn}. ${rarely(kind, vary.split(", "))}`;
  if (key === undefined) return reasonWords(found);
  if (key === "goal_difference" && found === "nothing")
    return "Say which goal difference the walk must have at least, or how many steps at most.";
  const also = key === "goal_difference" ? ", or a fraction such as 2/3" : "";
  // The core was given a number: of a fraction, all its decimals.
  const text = typed[key]?.trim();
  const seen = text === undefined || text === "" || text === found ? found : JSON.stringify(text);
  return `${fields[key] ?? key}: ${seen} can’t be used; it takes ${expected}${also}.`;
}

function reasonWords(found: string): string {
  for (const [reason, words] of reasons) {
    const match = reason.exec(found);
    if (match !== null) return words(...match);
  }
  return `This question can’t be asked: ${found}.`;
}
