// Edits of what an observer of a delivery is told.
import { packagesOf } from "./delivery-goals.js";
import { tidied } from "./names.js";
import type { DeliveryDocument, DeliveryObserver, Role } from "./types.js";

export type Load = DeliveryObserver["sensor"]["load"];
export type DeliveryPreset = "same" | "factories" | "packages";

export const deliveryPresets: Record<DeliveryPreset, string> = {
  same: "Cannot tell packages apart",
  factories: "Reads the factory",
  packages: "Reads each package",
};

const barcode = (name: string): string => `barcode ${name}`;

/** `Object.fromEntries` alone is safe for every name: with an assignment, one called `__proto__` would be lost. */
const each = (names: readonly string[], symbol: (name: string) => string): Record<string, string> =>
  Object.fromEntries(names.map((name) => [name, symbol(name)]));

export const factoryNames = (document: DeliveryDocument): string[] => document.factories.map(({ name }) => name);

export const loadOf = (document: DeliveryDocument, role: Role): Load => document.observers[role].sensor.load;

/** The symbol that is written down for a factory or a package; undefined where none is. */
export const symbolFor = (load: Load, name: string): string | undefined =>
  typeof load === "string" ? load : Object.entries(load).find(([key]) => key === name)?.[1];

/** Which preset an observer's sensor does the same as; null where it does as none. */
export function deliveryPresetOf(document: DeliveryDocument, role: Role): DeliveryPreset | null {
  const load = loadOf(document, role);
  if (typeof load === "string") return "same";
  const keys = Object.keys(load);
  const factories = factoryNames(document);
  if (keys.every((key) => factories.includes(key)) && different(load)) return "factories";
  const packages = packagesOf(document);
  if (packages.every((name) => keys.includes(name)) && different(load)) return "packages";
  return null;
}

const different = (load: Record<string, string>): boolean =>
  new Set(Object.values(load)).size === Object.keys(load).length;

export function withLoad(document: DeliveryDocument, role: Role, load: Load): DeliveryDocument {
  const observer = document.observers[role];
  const sensor = { ...observer.sensor, load };
  return { ...document, observers: { ...document.observers, [role]: { ...observer, sensor } } };
}

export function useDeliveryPreset(document: DeliveryDocument, role: Role, preset: DeliveryPreset): DeliveryDocument {
  const load: Record<DeliveryPreset, Load> = {
    same: "package",
    factories: each(factoryNames(document), barcode),
    packages: each(packagesOf(document), barcode),
  };
  return withLoad(document, role, load[preset]);
}

/** A symbol for a factory or a package; an empty one takes it away where another stands in for it. */
export function setLoadSymbol(
  document: DeliveryDocument,
  role: Role,
  name: string,
  text: string,
): DeliveryDocument | string {
  const symbol = tidied(text);
  const load = loadOf(document, role);
  if (typeof load === "string") {
    return symbol === "" ? "A symbol is needed." : withLoad(document, role, symbol);
  }
  const others = Object.entries(load).filter(([key]) => key !== name);
  const changed = Object.fromEntries(symbol === "" ? others : [...others, [name, symbol]]);
  const lacking = lackingSymbol(document, changed);
  if (lacking !== null) return `${lacking} needs a symbol: its own or its factory’s.`;
  return withLoad(document, role, changed);
}

export function setDeliverSymbol(document: DeliveryDocument, role: Role, text: string): DeliveryDocument | string {
  const deliver = tidied(text);
  if (deliver === "") return "A symbol for delivering is needed.";
  const observer = document.observers[role];
  const sensor = { ...observer.sensor, deliver };
  return { ...document, observers: { ...document.observers, [role]: { ...observer, sensor } } };
}

/** The first package that no symbol is for. */
function lackingSymbol(document: DeliveryDocument, load: Record<string, string>): string | null {
  const keys = new Set(Object.keys(load));
  for (const { name, packages } of document.factories) {
    const lacking = packages.find((one) => !keys.has(one) && !keys.has(name));
    if (lacking !== undefined) return lacking;
  }
  return null;
}

/** Keys follow a name that changed; those of names that are gone go too. What has no symbol gets a barcode. */
export function mended(
  document: DeliveryDocument,
  renamed: (name: string) => string = (name) => name,
): DeliveryDocument {
  let whole = document;
  for (const role of ["adversarial", "cooperative"] as const) {
    const load = loadOf(whole, role);
    if (typeof load === "string") continue;
    const known = new Set([...factoryNames(whole), ...packagesOf(whole)]);
    const followed = Object.entries(load).map(([key, symbol]) => [renamed(key), symbol] as const);
    const kept = followed.filter(([key]) => known.has(key));
    const byFactory = kept.some(([key]) => factoryNames(whole).includes(key)) || kept.length === 0;
    let complete = Object.fromEntries(kept);
    if (byFactory) {
      const bare = whole.factories.filter(
        ({ name, packages }) => lacks(complete, name) && packages.some((one) => lacks(complete, one)),
      );
      complete = {
        ...complete,
        ...each(
          bare.map(({ name }) => name),
          barcode,
        ),
      };
    } else {
      const bare = packagesOf(whole).filter((name) => lacks(complete, name));
      complete = Object.fromEntries([...Object.entries(complete), ...Object.entries(each(bare, barcode))]);
    }
    whole = withLoad(whole, role, complete);
  }
  return whole;
}

const lacks = (load: Record<string, string>, name: string): boolean => !Object.hasOwn(load, name);
