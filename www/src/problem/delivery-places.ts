// Edits of factories and the packages that lie there. Whatever follows from one (the true goal, how many are delivered,
// what the observers are told) is put right with it.
import {
  JOINT,
  MOST_PACKAGES,
  packagesOf,
  possibleNumbers,
  setDeliver,
  tooMany,
  trueGoalOf,
  withTrueGoal,
} from "./delivery-goals.js";
import { factoryNames, mended } from "./delivery-sensor.js";
import { freeName, nameFault, tidied } from "./names.js";
import type { DeliveryDocument } from "./types.js";

type Factory = DeliveryDocument["factories"][number];

const namesOf = (document: DeliveryDocument): string[] => [...factoryNames(document), ...packagesOf(document)];

const withFactory = (document: DeliveryDocument, index: number, change: (factory: Factory) => Factory) => ({
  ...document,
  factories: document.factories.map((factory, at) => (at === index ? change(factory) : factory)),
});

/** A, B, C and so on; with the letters used up, F1, F2 and so on. */
const factoryName = (number: number): string => (number <= 26 ? String.fromCharCode(64 + number) : `F${number - 26}`);

/** More than anybody draws; without packages, too, a factory is work for the core. */
export const MOST_FACTORIES = 26;

export function addFactory(document: DeliveryDocument): DeliveryDocument | string {
  if (document.factories.length >= MOST_FACTORIES) return `At most ${MOST_FACTORIES} factories are possible.`;
  const name = freeName(namesOf(document), factoryName);
  return { ...document, factories: [...document.factories, { name, packages: [] }] };
}

export function renameFactory(document: DeliveryDocument, index: number, text: string): DeliveryDocument | string {
  const before = document.factories[index]?.name ?? "";
  const name = tidied(text);
  const fault = nameFault(name, withoutOne(namesOf(document), before));
  if (fault !== null) return fault;
  return mended(
    withFactory(document, index, (factory) => ({ ...factory, name })),
    (key) => (key === before ? name : key),
  );
}

/** Its packages go with it. */
export function removeFactory(document: DeliveryDocument, index: number): DeliveryDocument | string {
  return settled({ ...document, factories: document.factories.filter((_, at) => at !== index) });
}

/** Called after its factory: a1, a2 and so on at A. */
export function addPackage(document: DeliveryDocument, index: number): DeliveryDocument | string {
  const count = packagesOf(document).length + 1;
  if (count > MOST_PACKAGES) return `At most ${MOST_PACKAGES} packages are possible.`;
  if (!possibleNumbers(count).includes(document.deliver)) return tooMany(count, document.deliver);
  const stem = (document.factories[index]?.name ?? "p").toLowerCase().replaceAll(JOINT, "");
  const name = freeName(namesOf(document), (number) => `${stem}${number}`);
  const added = withFactory(document, index, ({ packages, ...rest }) => ({ ...rest, packages: [...packages, name] }));
  return mended(withTrueGoal(added, trueGoalOf(document)));
}

export function renamePackage(document: DeliveryDocument, before: string, text: string): DeliveryDocument | string {
  const name = tidied(text);
  const fault = nameFault(name, withoutOne(namesOf(document), before));
  if (fault !== null) return fault;
  if (name.includes(JOINT)) return `A package’s name can’t hold “${JOINT}”, which joins the names of a goal.`;
  const follow = (old: string) => (old === before ? name : old);
  const factories = document.factories.map((factory) => ({ ...factory, packages: factory.packages.map(follow) }));
  return mended({ ...document, factories, true_goal: trueGoalOf(document).map(follow).join(JOINT) }, follow);
}

export function removePackage(document: DeliveryDocument, name: string): DeliveryDocument | string {
  const factories = document.factories.map((factory) => ({
    ...factory,
    packages: factory.packages.filter((one) => one !== name),
  }));
  return settled({ ...document, factories });
}

/** After packages are gone: fewer are delivered where there are too few left. */
function settled(document: DeliveryDocument): DeliveryDocument | string {
  const numbers = possibleNumbers(packagesOf(document).length);
  const fewer = numbers.filter((number) => number <= document.deliver).at(-1) ?? numbers[0];
  if (fewer === undefined) return "At least two packages stay: with one there is nothing to guess.";
  const delivered = setDeliver({ ...document, deliver: fewer }, fewer);
  return typeof delivered === "string" ? delivered : mended(delivered);
}

function withoutOne(names: readonly string[], name: string): string[] {
  const at = names.indexOf(name);
  return names.filter((_, index) => index !== at);
}
