// Documents to begin with, one of each kind that is written by hand. Each can be used as it stands.
import { newGrid } from "../problem/new-grid.js";
import { written } from "../problem/text.js";

export interface Template {
  title: string;
  about: string;
  text: string;
}

const delivery = {
  format: "delivery" as const,
  factories: [
    { name: "A", packages: ["a1", "a2"] },
    { name: "B", packages: ["b1"] },
  ],
  deliver: 1,
  true_goal: "a1",
  observers: {
    adversarial: { sensor: { load: "a package", deliver: "delivery" } },
    cooperative: { sensor: { load: { A: "from A", B: "from B" }, deliver: "delivery" } },
  },
};

const explicit = `{
  "format": "explicit",
  "states": ["home", "left", "right"],
  "actions": ["go left", "go right"],
  "transitions": [
    ["home", "go left", "left"],
    ["home", "go right", "right"]
  ],
  "initial_state": "home",
  "goals": [
    {"name": "be left", "states": ["left"]},
    {"name": "be right", "states": ["right"]}
  ],
  "true_goal": "be left",
  "observers": {
    "adversarial": {
      "sensor": [
        ["go left", "left", "moved"],
        ["go right", "right", "moved"]
      ]
    },
    "cooperative": {
      "sensor": [
        ["go left", "left", "moved to the left"],
        ["go right", "right", "moved to the right"]
      ]
    }
  }
}
`;

const pddl = `{
  "format": "pddl",
  "domain": [
    "; A lamp in each room, which can be lit once.",
    "(define (domain lamps)",
    "  (:requirements :strips :typing)",
    "  (:types room)",
    "  (:predicates",
    "    (dark ?room - room)",
    "    (lit ?room - room))",
    "",
    "  (:action light",
    "    :parameters (?room - room)",
    "    :precondition (dark ?room)",
    "    :effect (and (lit ?room) (not (dark ?room)))))"
  ],
  "problem": [
    "(define (problem two-lamps)",
    "  (:domain lamps)",
    "  (:objects kitchen hall - room)",
    "  (:init (dark kitchen) (dark hall)))"
  ],
  "goals": [
    {"name": "light in the kitchen", "condition": "(lit kitchen)"},
    {"name": "light in the hall", "condition": "(lit hall)"}
  ],
  "true_goal": "light in the kitchen",
  "observers": {
    "adversarial": {"sensor": "{name}"},
    "cooperative": {"sensor": "{name} {1}"}
  }
}
`;

export const templates: readonly Template[] = [
  { title: "Gridworld", about: "An empty grid of 4 by 4 cells", text: written(newGrid(4, 4)) },
  { title: "Delivery", about: "Two factories and a truck", text: written(delivery) },
  { title: "Explicit", about: "States and transitions one by one", text: explicit },
  { title: "PDDL", about: "A domain and a problem in PDDL", text: pddl },
];
