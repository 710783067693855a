// What a transport domain is made of: places, the ways between them, cities, vehicles, drivers and packages. Logistics and
// Driverlog, as the competitions write them and as this project does, say so by types or by predicates of one argument.
import { type Atom, atomOf, hasPredicate, type PddlScene } from "../pddl/atoms.js";

export type Sign = "truck" | "plane" | "driver" | "package";

export interface Place {
  name: string;
  /** "road to s1, s2" */
  ways: string[];
}

export interface World {
  /** The places of each city; one nameless city where there are none. */
  cities: { name: string; places: Place[] }[];
  /** What each thing that moves looks like. */
  signs: ReadonlyMap<string, Sign>;
}

/** Things are at places, and in things. */
export const isTransport = (scene: PddlScene): boolean => hasPredicate(scene, "at", 2) && hasPredicate(scene, "in", 2);

export function worldOf(scene: PddlScene): World {
  const initial = scene.initial.map(atomOf);
  const still = initial.filter(({ predicate }) =>
    scene.predicates.some(({ name, changes }) => name === predicate && !changes),
  );
  const kinds = kindsOf(scene, still);
  const places = placesOf(scene, initial, kinds);
  return { cities: citiesOf(places, still), signs: signsOf(scene, places, kinds, initial) };
}

/** The types of each object, and the predicates of one argument that always hold of it. */
function kindsOf(scene: PddlScene, still: readonly Atom[]): Map<string, Set<string>> {
  const kinds = new Map(
    scene.objects.map(({ name, types }) => [name, new Set(types.filter((type) => type !== "object"))]),
  );
  for (const { predicate, objects } of still) {
    if (objects.length === 1) kinds.get(objects[0] ?? "")?.add(predicate);
  }
  return kinds;
}

/** What something is at, and what is of the same kind as that. */
function placesOf(scene: PddlScene, initial: readonly Atom[], kinds: ReadonlyMap<string, Set<string>>): string[] {
  const facts = [...initial, ...scene.goals.flatMap((goal) => goal.facts.map(atomOf))];
  const at = facts.filter(({ predicate }) => predicate === "at");
  const reached = new Set(at.map(({ objects }) => objects[1] ?? ""));
  const things = new Set(at.map(({ objects }) => objects[0] ?? ""));
  const ofThings = new Set([...things].flatMap((name) => [...(kinds.get(name) ?? [])]));
  const ofPlaces = new Set(
    [...reached].flatMap((name) => [...(kinds.get(name) ?? [])]).filter((kind) => !ofThings.has(kind)),
  );
  return scene.objects
    .map(({ name }) => name)
    .filter((name) => reached.has(name) || [...(kinds.get(name) ?? [])].some((kind) => ofPlaces.has(kind)));
}

function citiesOf(places: readonly string[], still: readonly Atom[]): World["cities"] {
  const known = new Set(places);
  const links = still.filter(({ objects }) => objects.length === 2 && objects.every((name) => known.has(name)));
  const place = (name: string): Place => ({ name, ways: waysFrom(name, links) });
  const belongs = still.filter(
    ({ predicate, objects }) => predicate.includes("city") && known.has(objects[0] ?? "") && objects.length === 2,
  );
  if (belongs.length > 0) {
    const names = [...new Set(belongs.map(({ objects }) => objects[1] ?? ""))];
    const of = (city: string) =>
      belongs.filter(({ objects }) => objects[1] === city).map(({ objects }) => objects[0] ?? "");
    const housed = new Set(belongs.map(({ objects }) => objects[0] ?? ""));
    const others = places.filter((name) => !housed.has(name));
    const cities = names.map((name) => ({ name, places: of(name).map(place) }));
    return others.length === 0 ? cities : [...cities, { name: "", places: others.map(place) }];
  }
  // Roads stay in a city, routes go through the air.
  const roads = links.filter(({ predicate }) => predicate === "road");
  if (!links.some(({ predicate }) => predicate === "route") || roads.length === 0) {
    return [{ name: "", places: places.map(place) }];
  }
  return components(places, roads).map((city) => ({ name: "", places: city.map(place) }));
}

function waysFrom(name: string, links: readonly Atom[]): string[] {
  const ways = new Map<string, string[]>();
  for (const { predicate, objects } of links) {
    const [from, to = ""] = objects;
    if (from === name) ways.set(predicate, [...(ways.get(predicate) ?? []), to]);
  }
  return [...ways].map(([way, targets]) => `${way} to ${targets.join(", ")}`);
}

/** Places that roads connect, in the order of their first places. */
function components(places: readonly string[], roads: readonly Atom[]): string[][] {
  const groups: Set<string>[] = places.map((name) => new Set([name]));
  for (const { objects } of roads) {
    const joined = groups.filter((group) => objects.some((name) => group.has(name)));
    const [first, ...rest] = joined;
    for (const group of rest) {
      for (const name of group) first?.add(name);
      groups.splice(groups.indexOf(group), 1);
    }
  }
  return groups.map((group) => places.filter((name) => group.has(name)));
}

function signsOf(
  scene: PddlScene,
  places: readonly string[],
  kinds: ReadonlyMap<string, Set<string>>,
  initial: readonly Atom[],
): Map<string, Sign> {
  const known = new Set(places);
  const moved = new Set(
    initial.filter(({ predicate }) => predicate === "at" || predicate === "in").map(({ objects }) => objects[0]),
  );
  const signs = new Map<string, Sign>();
  for (const { name } of scene.objects) {
    const sign = signOf([...(kinds.get(name) ?? [])]);
    if (!known.has(name) && (sign !== "package" || moved.has(name))) signs.set(name, sign);
  }
  return signs;
}

function signOf(kinds: readonly string[]): Sign {
  const is = (pattern: RegExp) => kinds.some((kind) => pattern.test(kind));
  if (is(/driver/)) return "driver";
  if (is(/plane/)) return "plane";
  return is(/truck|vehicle|van|car$|ship|train/) ? "truck" : "package";
}
