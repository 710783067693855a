// Edits of delivery documents, without a browser: what each does, and that the core takes whatever comes of them.
import assert from "node:assert/strict";
import { test } from "node:test";
import * as goals from "../../www/src/problem/delivery-goals.js";
import * as places from "../../www/src/problem/delivery-places.js";
import * as sensor from "../../www/src/problem/delivery-sensor.js";
import { written } from "../../www/src/problem/text.js";
import type { DeliveryDocument, Role } from "../../www/src/problem/types.js";
import { scene, solve, taken } from "./support/core.js";
import { Dice } from "./support/dice.js";
import { figure1 as delivery } from "./support/documents.js";

const figure = JSON.parse(delivery) as DeliveryDocument;
const roles: readonly Role[] = ["adversarial", "cooperative"];

function made(edited: DeliveryDocument | string): DeliveryDocument {
  assert(typeof edited !== "string", String(edited));
  return edited;
}

test("names carry through to the true goal and the sensors", () => {
  const renamed = made(places.renamePackage(made(places.renameFactory(figure, 0, "North")), "a1", "box"));
  assert.equal(renamed.true_goal, "box+a2");
  assert.deepEqual(renamed.observers.cooperative.sensor.load, { North: "barcode A", B: "barcode B" });
  assert.equal(solve(written(renamed), { solver: "exact" }).outcome.goal_difference, 1);
  assert.match(String(places.renamePackage(figure, "a1", "a+1")), /can’t hold/);
  assert.match(String(places.renamePackage(figure, "a1", "B")), /taken/);
  assert.match(String(places.renameFactory(figure, 0, " ")), /needed/);
  assert.equal(made(places.renameFactory(figure, 0, "A")).factories[0]?.name, "A");
});

test("removing a package mends the true goal and how many are delivered", () => {
  const three = made(places.removePackage(figure, "a2"));
  assert.deepEqual([three.deliver, three.true_goal], [2, "a1+b1"]);
  const two = made(places.removePackage(three, "b1"));
  assert.deepEqual([two.deliver, two.true_goal], [1, "a1"]);
  assert.match(String(places.removePackage(two, "b2")), /At least two/);
  assert.match(String(places.removeFactory(two, 0)), /At least two/);
  assert.deepEqual(made(places.removeFactory(figure, 0)).observers.cooperative.sensor.load, { B: "barcode B" });
});

test("a new factory and its packages are read by who reads factories", () => {
  const more = made(places.addPackage(made(places.addFactory(figure)), 2));
  assert.deepEqual(more.factories[2], { name: "C", packages: ["c1"] });
  assert.deepEqual(more.observers.cooperative.sensor.load, { A: "barcode A", B: "barcode B", C: "barcode C" });
  assert.equal(sensor.deliveryPresetOf(more, "cooperative"), "factories");
  const each = sensor.useDeliveryPreset(more, "cooperative", "packages");
  assert.deepEqual(made(places.addPackage(each, 0)).observers.cooperative.sensor.load, {
    a1: "barcode a1",
    a2: "barcode a2",
    b1: "barcode b1",
    b2: "barcode b2",
    c1: "barcode c1",
    a3: "barcode a3",
  });
});

test("no more candidate goals than the core takes", () => {
  let document = figure;
  let refused = "";
  while (refused === "") {
    const edited = places.addPackage(document, 1);
    if (typeof edited === "string") refused = edited;
    else document = edited;
  }
  assert.equal(goals.packagesOf(document).length, 45);
  assert.match(refused, /2 of 46 packages would make 1,035 candidate goals; at most 1,024/);
  assert.equal(taken(written(document)), true);
  assert.match(String(goals.setDeliver(document, 3)), /14,190/);
  document = made(goals.setDeliver(document, 44));
  assert.equal(taken(written(document)), true);
  assert.equal(goals.trueGoalOf(document).length, 44);
});

test("the sets are the core's goals, in its order", () => {
  const three = made(goals.setDeliver(made(places.addPackage(figure, 0)), 3));
  for (const document of [figure, three]) {
    const names = goals.goalSets(document).map((set) => set.join("+"));
    assert.deepEqual(
      names,
      scene(written(document)).goals.map(({ name }) => name),
    );
    assert.equal(names.length, goals.setCount(goals.packagesOf(document).length, document.deliver));
  }
});

test("symbols: a package's own goes first, none may lack", () => {
  const own = made(sensor.setLoadSymbol(figure, "cooperative", "a1", "special"));
  assert.equal(sensor.deliveryPresetOf(own, "cooperative"), null);
  assert.equal(sensor.symbolFor(sensor.loadOf(own, "cooperative"), "a1"), "special");
  assert.deepEqual(made(sensor.setLoadSymbol(own, "cooperative", "a1", "")), figure);
  assert.match(String(sensor.setLoadSymbol(figure, "cooperative", "A", " ")), /a1 needs a symbol/);
  assert.match(String(sensor.setLoadSymbol(figure, "adversarial", "", "")), /needed/);
  assert.match(String(sensor.setDeliverSymbol(figure, "adversarial", "")), /needed/);
});

/** Any edit that the page can make. */
function anyEdit(document: DeliveryDocument, dice: Dice): DeliveryDocument | string {
  const role = dice.of(roles);
  const index = dice.below(Math.max(1, document.factories.length));
  const packages = goals.packagesOf(document);
  const name = () => dice.of(["A", "x", "a1", "", "p+q", "__proto__", "the delivery area", "truck", "toString", "7"]);
  const some = () => dice.of([...packages, ...sensor.factoryNames(document)]);
  const edits: (() => DeliveryDocument | string)[] = [
    () => places.addFactory(document),
    () => places.renameFactory(document, index, name()),
    () => places.removeFactory(document, index),
    ...Array.from({ length: 3 }, () => () => places.addPackage(document, index)),
    () => places.renamePackage(document, dice.of(packages), name()),
    () => places.removePackage(document, dice.of(packages)),
    () => goals.setDeliver(document, 1 + dice.below(6)),
    () => goals.withTrueGoal(document, [dice.of(packages), dice.of(packages)]),
    () => sensor.useDeliveryPreset(document, role, dice.of(["same", "factories", "packages"] as const)),
    () => sensor.setLoadSymbol(document, role, some(), dice.of(["", "p", "q"])),
    () => sensor.setDeliverSymbol(document, role, dice.of(["", "d", "p"])),
  ];
  return dice.of(edits)();
}

test("the core takes whatever is made of a delivery", () => {
  let count = 0;
  for (let seed = 0; seed < 40; seed += 1) {
    const dice = new Dice(seed);
    let document = figure;
    for (let edit = 0; edit < 60; edit += 1) {
      const edited = anyEdit(document, dice);
      if (typeof edited === "string") continue;
      assert.equal(taken(written(edited)), true, `seed ${seed}, edit ${edit}: ${written(document)}`);
      // What the page writes is read again as it was.
      assert.deepEqual(JSON.parse(written(edited)), edited);
      document = edited;
      count += 1;
    }
  }
  assert(count > 1000, `only ${count} edits were made`);
});
