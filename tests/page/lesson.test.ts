// The lesson of an hour (docs/lesson.md): its slots follow one another, its exercises fit into them, and none is forgotten.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

const lesson = readFileSync(new URL("../../docs/lesson.md", import.meta.url), "utf8");

/** The least that a slot has beside its exercises. */
const TALK = 1;
/** The least that the hour has beside its exercises. */
const ALL_TALK = 10;

/** Minutes of each exercise by its number. */
const minutes = new Map(
  [...lesson.matchAll(/^\| \[`(\d\d)-[^|]*\|.*\| (\d+) \|$/gm)].map(([, number = "", time]) => [number, Number(time)]),
);

const slots = [...lesson.matchAll(/^\| (\d+)–(\d+) \|.*\| ([\d, ]+) \|$/gm)].map(([, begin, end, exercises = ""]) => ({
  begin: Number(begin),
  end: Number(end),
  exercises: exercises.split(", "),
}));

const timeOf = (exercises: readonly string[]): number =>
  exercises.reduce((sum, number) => sum + (minutes.get(number) ?? Number.NaN), 0);

test("the exercises of each slot leave time to explain them, and the slots make an hour", () => {
  assert.equal(minutes.size, 12);
  let now = 0;
  for (const { begin, end, exercises } of slots) {
    assert.equal(begin, now);
    const left = end - begin - timeOf(exercises);
    assert(left >= TALK, `${begin}–${end}: ${left} minutes beside ${exercises.join(", ")}`);
    now = end;
  }
  assert.equal(now, 60);
  assert(60 - timeOf(slots.flatMap(({ exercises }) => exercises)) >= ALL_TALK);
});

test("each exercise is in the plan or at home, and the time to explain is what is said", () => {
  const planned = slots.flatMap(({ exercises }) => exercises);
  const [, atHome = ""] = /^.*At home: ([\d, ]+)\.$/m.exec(lesson) ?? [];
  assert.deepEqual([...planned, ...atHome.split(", ")].sort(), [...minutes.keys()].sort());
  assert.equal(60 - timeOf(planned), 13);
  assert(lesson.includes("thirteen minutes in all"));
});
