// What the words of the page mean, with the paper's symbols and where the paper says so.
import { html, type MathMLTemplateResult, mathml, type TemplateResult } from "lit";
import type { Term } from "./terms.js";

export interface Definition {
  term: Term;
  name: string;
  symbol?: TemplateResult;
  meaning: TemplateResult;
  source?: string;
}

export type See = (term: Term, text: string) => TemplateResult;

const math = (content: MathMLTemplateResult): TemplateResult => html`<math>${content}</math>`;
const letter = (name: string): TemplateResult => math(mathml`<mi>${name}</mi>`);
const bold = (name: string): TemplateResult => math(mathml`<mi mathvariant="normal" class="bold">${name}</mi>`);
const of = (name: string, below: string): TemplateResult =>
  math(mathml`<msub><mi>${name}</mi><mi>${below}</mi></msub>`);
const beliefAt = (time: string): TemplateResult =>
  math(mathml`<msubsup><mi>ℬ</mi><mi>${time}</mi><mi>i</mi></msubsup>`);
const survivors = (observer: string) => mathml`<msubsup><mi>𝒢</mi><mi>${observer}</mi><mi>π</mi></msubsup>`;
const count = (observer: string) =>
  mathml`<mrow><mo stretchy="false">|</mo>${survivors(observer)}<mo stretchy="false">|</mo></mrow>`;

const differenceFormula = html`<math display="block" alttext="GD(π) = (|G_X| − |G_C|) / (n − 1)">
  <mi>GD</mi><mo stretchy="false">(</mo><mi>π</mi><mo stretchy="false">)</mo><mo>=</mo>
  <mfrac><mrow>${count("X")}<mo>−</mo>${count("C")}</mrow><mrow><mi>n</mi><mo>−</mo><mn>1</mn></mrow></mfrac>
</math>`;

/** In an order in which each word is explained by words before it, as far as there is one. */
export const glossary = (see: See): Definition[] => [
  {
    ...{ term: "agent", name: "Agent", symbol: bold("A"), source: "Definition 1; there: actor." },
    meaning: html`Whoever acts. It knows what it does, what the observers’ sensors tell them, and what they believe.`,
  },
  {
    ...{ term: "observer", name: "Observer", source: "Definition 1." },
    meaning: html`Someone who watches: the ${see("enemy", "enemy")} or the ${see("friend", "friend")}. It knows all that is
      possible, but not where the agent is nor which of the ${see("candidate-goal", "candidate goals")} it is after.`,
  },
  {
    ...{ term: "enemy", name: "Enemy", symbol: bold("X"), source: "Definition 1; there: adversarial observer." },
    meaning: html`The observer who should stay in doubt. On the boards: red, a diamond.`,
  },
  {
    ...{ term: "friend", name: "Friend", symbol: bold("C"), source: "Definition 1; there: cooperative observer." },
    meaning: html`The observer who should understand. On the boards: blue, a disc.`,
  },
  {
    ...{ term: "sensor", name: "Sensor", symbol: of("𝒪", "i"), source: "Definition 1." },
    meaning: html`What an observer is told of a step: one ${see("symbol", "symbol")} for each action and the state it
      leads to. Several steps may give the same symbol; then the observer cannot tell them apart.`,
  },
  {
    ...{
      term: "symbol",
      name: "Symbol",
      symbol: of("o", "t"),
      source: "Definition 1, where Ω stands for all of them.",
    },
    meaning: html`What a ${see("sensor", "sensor")} says of one step, such as “horizontal”.`,
  },
  {
    ...{ term: "camera", name: "Camera" },
    meaning: html`A cell in which an observer sees the agent exactly, whatever its ${see("sensor", "sensor")} says elsewhere.`,
  },
  {
    ...{ term: "belief", name: "Belief", symbol: beliefAt("t"), source: "Section 2, belief update." },
    meaning: html`All the places (in general: states) where the agent can be, after all an observer was told. With each
      symbol it becomes: every place that some action leads to from a place in the belief before, with just this
      symbol. The place where the agent really is, is always in it.`,
  },
  {
    ...{ term: "initial-belief", name: "First belief", symbol: beliefAt("0"), source: "Definition 1." },
    meaning: html`The places where an observer holds the agent possible before the first step. The start is one of them.`,
  },
  {
    ...{
      term: "candidate-goal",
      name: "Candidate goal",
      symbol: letter("𝒢"),
      source: "Definition 1; there are n of them.",
    },
    meaning: html`A goal that the agent might have. Both observers know them all.`,
  },
  {
    ...{ term: "true-goal", name: "True goal", symbol: of("G", "A"), source: "Definition 1." },
    meaning: html`The candidate goal that the agent really has, marked with a star. No observer knows it.`,
  },
  {
    ...{ term: "decoy", name: "Decoy" },
    meaning: html`Any candidate goal but the true one.`,
  },
  {
    ...{ term: "possible", name: "Possible, ruled out", symbol: math(survivors("i")), source: "Section 2, solutions." },
    meaning: html`A goal is possible for an observer when it is reached in some state of the observer’s
      ${see("belief", "belief")}; the paper says that it survives. It is ruled out when it is reached in none and no
      actions lead to it from any of them, or when the plan is over. In between it is not possible now and may still
      come. Only what is possible at the end of the plan counts. The true goal always is.`,
  },
  {
    ...{ term: "obfuscation", name: "Obfuscation", symbol: math(count("X")), source: "Section 2." },
    meaning: html`Keeping many goals possible for the enemy.`,
  },
  {
    ...{ term: "legibility", name: "Legibility", symbol: math(count("C")), source: "Section 2." },
    meaning: html`Leaving few goals possible for the friend; with one left, it is the true goal (Proposition 1).`,
  },
  {
    ...{ term: "goal-difference", name: "Goal difference", symbol: letter("GD"), source: "Definition 2." },
    meaning: html`How good a plan is: the goals possible for the enemy at its end, less those possible for the friend, over
      the number of goals less one. ${differenceFormula} 1 is the best there can be: the enemy knows nothing and the friend
      everything. Below 0 the enemy knows more than the friend.`,
  },
  {
    ...{ term: "head-fake", name: "Head fake", source: "From the paper’s title." },
    meaning: html`Doing what looks like going for a ${see("decoy", "decoy")}, for the enemy’s eyes, on the way to the true
      goal.`,
  },
  {
    ...{ term: "plan", name: "Plan", symbol: letter("π"), source: "Section 2." },
    meaning: html`A sequence of actions that ends at the true goal.`,
  },
  {
    ...{ term: "length", name: "Plan length, horizon", symbol: letter("𝒯"), source: "Section 3." },
    meaning: html`The number of actions of a plan. With a length given, only plans of just that many actions are looked at.`,
  },
  {
    ...{ term: "k", name: "k", symbol: letter("k"), source: "Section 3, goal constraints." },
    meaning: html`At least so many goals stay possible for the enemy: where all of them are equally likely to it, it names the true
      one with a chance of at most 1/k. Together with ${see("j", "j")}, the goal difference is at least (k − j)/(n − 1) (Proposition 4).`,
  },
  {
    ...{ term: "j", name: "j", symbol: letter("j"), source: "Section 3, goal constraints." },
    meaning: html`At most so many goals stay possible for the friend: where all of them are equally likely to it, it names the true
      one with a chance of at least 1/j.`,
  },
  {
    ...{ term: "exact", name: "Exact search" },
    meaning: html`Follows where the agent can be with what both believe, the most promising first, and stops where no
      plan can be better. It finds the largest goal difference there is, for one length or for all, and proves it.`,
  },
  {
    ...{ term: "integer-program", name: "Integer program", source: "Section 3, “MO-COPP as Integer Program”." },
    meaning: html`The problem for one length, written as linear inequalities over whole numbers and given to a general
      solver.`,
  },
  {
    ...{ term: "encoding", name: "Encoding" },
    meaning: html`How the ${see("integer-program", "integer program")} is written. “As in the paper” has a variable for each
      state in each belief at each time. “Belief flow” lets the plan flow through pairs of a state and a belief, which is
      much faster.`,
  },
  {
    ...{ term: "satisficing", name: "Satisficing search" },
    meaning: html`Takes the first plan within the bounds ${see("k", "k")} and ${see("j", "j")}, or proves that there is
      none. It begins as ${see("search", "heuristic search")}; where that finds nothing soon, it goes on as
      ${see("exact", "exact search")} does.`,
  },
  {
    ...{ term: "search", name: "Heuristic search", source: "Algorithm 1." },
    meaning: html`Goes first where the true goal seems near, the decoys near for the enemy and far for the friend. It takes
      the first plan within the bounds ${see("k", "k")} and ${see("j", "j")}, which need not be the best.`,
  },
  {
    ...{ term: "baseline", name: "Baseline", source: "Section 4." },
    meaning: html`A plan for the true goal that minds no observer, to compare with.`,
  },
  {
    ...{ term: "trade-off", name: "Trade-off" },
    meaning: html`Leaving the enemy more goals may leave the friend more as well. The picture has a point for every pair of
      numbers that some plan reaches.`,
  },
  {
    ...{ term: "proved-optimal", name: "Proved optimal" },
    meaning: html`No plan of those asked for has a larger goal difference: the search has covered all of them.`,
  },
  {
    ...{ term: "best-found", name: "Best found" },
    meaning: html`The solver was stopped, or met a limit, before the proof. There may be a better plan.`,
  },
  {
    ...{ term: "bound", name: "Bound and gap" },
    meaning: html`While a solver looks for the best plan: no plan can be better than the bound; the gap is how far the best one
      found is below it.`,
  },
  {
    ...{ term: "no-plan", name: "No plan" },
    meaning: html`It is proved that no plan does what was asked. A longer plan or a smaller k may be possible.`,
  },
];
