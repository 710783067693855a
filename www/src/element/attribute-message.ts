// The message about attributes that can't be used, beside other messages: it goes when the attributes are right.
import type { Playground } from "../playground/playground.js";
import { propertiesAlone, settingNames } from "./attributes.js";
import type { PageQuestion } from "./page-question.js";
import { mistakes } from "./settings.js";

/** Attributes that are for a question alone. */
export const ofQuestion: ReadonlySet<string> = new Set(["required"]);

/** Attributes that change how a playground looks and behaves, and not what is open in it. */
export const manners: ReadonlySet<string> = new Set([
  "step",
  "hide",
  "keys",
  "theme",
  "link",
  "loading",
  ...propertiesAlone,
  ...ofQuestion,
]);

/** Attributes that a message may be about. */
const remarked: ReadonlySet<string> = new Set([
  ...[...settingNames, ...manners],
  ...["seed", "student", "watch", "root"],
]);

export class AttributeMessage {
  /** What was said last: the sentences about attributes, the rest of the message, and all of it together. */
  private said: { found: readonly string[]; rest: string | null; all: string } | null = null;

  constructor(
    private readonly host: Element,
    private readonly playground: Playground,
    private readonly question: PageQuestion,
  ) {}

  /** Says what is wrong with any attribute. */
  sayAll(): void {
    this.say(remarked);
  }

  /** Says what is wrong with these attributes. */
  say(names: ReadonlySet<string>): void {
    const { answer, problem, solving } = this.playground;
    const goals = problem.scene.value?.goals.length ?? null;
    const open = { goals, asks: this.question.asking !== "none" };
    const found = mistakes(this.host, names, open);
    const shown = answer.error.peek();
    // A message that was closed, or that another one replaced, has nothing to take back.
    const before = this.said !== null && this.said.all === shown ? this.said : null;
    const wrong = before === null ? [] : mistakes(this.host, remarked, open);
    const kept = before?.found.filter((mistake) => wrong.includes(mistake)) ?? [];
    if (found.length === 0 && kept.length === (before?.found.length ?? 0)) return;
    const rest = before === null ? shown : before.rest;
    const others = rest === null || found.some((mistake) => rest.includes(mistake)) ? null : rest;
    const sentences = [...new Set([...kept, ...found])];
    if (others === null && sentences.length === 0) {
      this.said = null;
      answer.dismiss();
      return;
    }
    const message = [...(others === null ? [] : [others]), ...sentences].join(" ");
    this.said = { found: sentences, rest: others, all: message };
    solving.refuse(message, answer.again.peek());
  }
}
