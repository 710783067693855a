// The gallery: named problems, each with what it shows. The documents themselves are loaded when they are wanted.

/** Another way to see the problem, one click away. */
export interface NamedPlan {
  title: string;
  /** The plan to show; without one, the best. */
  plan?: readonly string[];
  /** The plan is for another true goal than the document's. */
  trueGoal?: string;
}

export interface Entry {
  /** Its file in `www/problems/`, and its name in addresses and attributes. */
  name: string;
  title: string;
  /** One sentence: what it shows. */
  about: string;
  plans?: readonly NamedPlan[];
}

const times = (count: number, action: string): string[] => [...Array(count).keys()].map(() => action);

export const entries: readonly Entry[] = [
  {
    name: "eight-by-eight",
    title: "The paper’s gridworld",
    about:
      "The straight way, 14 moves, leaves the enemy three of four goals; a detour of two moves more leaves it all four, and the friend one.",
    plans: [
      {
        title: "Straight there",
        plan: [
          ...[...times(3, "north"), ...times(2, "east"), "north"],
          ...[...times(3, "east"), ...times(3, "north"), ...times(2, "east")],
        ],
      },
      { title: "With a detour" },
    ],
  },
  {
    name: "head-fake",
    title: "Head fake past a decoy",
    about:
      "A camera watches the door to two decoys. The agent shows itself there and turns away unseen: now the enemy must think of the decoys.",
    plans: [{ title: "Straight there", plan: [...times(3, "north"), ...times(3, "east")] }, { title: "Head fake" }],
  },
  {
    name: "delivery",
    title: "The paper’s delivery",
    about:
      "The friend reads each barcode’s factory, the enemy just counts: both from A tell the friend all, one from each leaves it four goals.",
    plans: [
      { title: "Both from A", trueGoal: "a1+a2" },
      { title: "One from each", trueGoal: "a1+b1" },
    ],
  },
  {
    name: "blind-enemy",
    title: "A blind enemy counts",
    about:
      "The enemy is told only that a move was made, but time rules out what is too far: the agent dawdles, nine moves to a goal three away.",
    plans: [{ title: "Straight there", plan: ["north", "west", "west"] }, { title: "Dawdling" }],
  },
  {
    name: "blind-friend",
    title: "A blind friend",
    about: "No plan speaks to a friend who is told nothing: GD is at most 0, whatever the plan.",
  },
  {
    name: "camera-zone",
    title: "Around the cameras",
    about:
      "Through the enemy’s cameras it is 8 moves, and the enemy knows all in the end; 12 moves around them leave it every goal.",
    plans: [{ title: "Through", plan: times(8, "east") }, { title: "Around" }],
  },
  {
    name: "corridor",
    title: "One step too far",
    about:
      "In a narrow corridor the enemy is told only of the turn at the end. One step past the door and back, and it may have been any of four doors.",
    plans: [
      { title: "Straight there", plan: ["east", "east", "north"] },
      { title: "Past and back", plan: ["east", "east", "east", "west", "north"] },
    ],
  },
  {
    name: "three-rooms",
    title: "Three rooms",
    about:
      "The enemy is told every move, but not in which room. A walk along the wall fits two of the three rooms; the best walk fits them all.",
    plans: [
      { title: "Along the wall", plan: [...times(4, "north"), ...times(2, "east")] },
      { title: "As in every room" },
    ],
  },
  {
    name: "parity",
    title: "Parity rules out decoys",
    about:
      "Each move changes the colour of the cell, as on a chessboard: goals of the wrong colour are ruled out. GD is at most 0.5, whatever the plan.",
  },
  {
    name: "stay-and-wait",
    title: "Stay and wait",
    about:
      "The same grid, but the agent may stand still, and one pause spoils the enemy’s count: all five goals stay possible, and GD is 1.",
    plans: [
      { title: "Straight there", plan: ["south", "south"] },
      { title: "Wait, then go", plan: [...times(3, "stay"), ...times(2, "south")] },
    ],
  },
  {
    name: "city",
    title: "A city at night",
    about:
      "Streets of 32 × 32 cells and cameras at six crossings: 32 moves straight there tell the enemy all, 44 moves on other streets nothing.",
    plans: [
      { title: "Straight there", plan: [...times(20, "north"), ...times(12, "east")] },
      { title: "Other streets" },
    ],
  },
  {
    name: "goal-in-sight",
    title: "A goal that cannot be hidden",
    about: "The enemy has a camera at the goal, so it knows in the end: GD is at most 0, whatever the plan.",
  },
  {
    name: "not-seen",
    title: "Not to be seen tells, too",
    about:
      "The enemy has cameras at all goals but the true one. Not to be seen there gives it away: GD is at most 0, whatever the plan.",
  },
  {
    name: "delivery-larger",
    title: "A bigger delivery",
    about:
      "Three of eight packages, 56 possible goals: the fewer choices a factory leaves, the more its barcode tells the friend.",
    plans: [
      { title: "All from A", trueGoal: "a1+a2+a3" },
      { title: "Two from B", trueGoal: "a1+b1+b2" },
      { title: "One from each", trueGoal: "a1+b1+c1" },
    ],
  },
  {
    name: "box-pushing",
    title: "Pushing a box",
    about:
      "A robot pushes a box, and the enemy tells turns from moves: in 4 actions it knows the goal, in 11 by a roundabout way it knows nothing.",
    plans: [
      { title: "Straight up", plan: ["move-forward", "turn-left", "move-forward", "move-forward"] },
      { title: "A roundabout way" },
    ],
  },
  {
    name: "recycling-robot",
    title: "A recycling robot",
    about:
      "A can goes into one of three bins. 9 actions tell the enemy which; with a spare charge and a pause, 14 tell the friend alone.",
    plans: [
      {
        title: "Straight there",
        plan: ["south", "south", "west", "charge", "south", "pick-up", "west", "west", "drop"],
      },
      { title: "Charge and pause" },
    ],
  },
  {
    name: "blocks",
    title: "Towers of blocks",
    about:
      "The enemy is told what is done, not with which block. A detour of 16 actions gives the tower away; the shortest way, 14, hides it.",
    plans: [
      {
        title: "A detour",
        plan: [
          ...["(unstack e a)", "(put-down e)", "(unstack a b)", "(stack a e)", "(unstack b d)", "(put-down b)"],
          ...["(pick-up c)", "(stack c b)", "(pick-up d)", "(stack d c)", "(unstack a e)", "(put-down a)"],
          ...["(pick-up e)", "(stack e d)", "(pick-up a)", "(stack a e)"],
        ],
      },
      { title: "The shortest" },
    ],
  },
  {
    name: "blocks-unseen",
    title: "Towers in the dark",
    about:
      "The enemy is not told how the blocks stand at first: 501 ways are possible. After 12 actions all five goals still are.",
  },
  {
    name: "logistics",
    title: "Trucks and an airplane",
    about:
      "Two packages fly to the other city. Loading both onto the truck there, and bringing one of them back, leaves the enemy three of five goals.",
    plans: [
      {
        title: "Straight there",
        plan: [
          ...["(load-airplane p1 plane1 airport1)", "(load-airplane p2 plane1 airport1)"],
          ...["(fly-airplane plane1 airport1 airport2)", "(unload-airplane p1 plane1 airport2)"],
          ...["(load-truck p1 truck2 airport2)", "(drive-truck truck2 airport2 place2)"],
          ...["(unload-truck p1 truck2 place2)", "(unload-airplane p2 plane1 airport2)"],
        ],
      },
      {
        title: "For nothing",
        plan: [
          ...["(load-airplane p2 plane1 airport1)", "(load-airplane p1 plane1 airport1)"],
          ...["(fly-airplane plane1 airport1 airport2)", "(unload-airplane p2 plane1 airport2)"],
          ...["(unload-airplane p1 plane1 airport2)", "(load-truck p2 truck2 airport2)"],
          ...["(load-truck p1 truck2 airport2)", "(drive-truck truck2 airport2 place2)"],
          ...["(unload-truck p1 truck2 place2)", "(drive-truck truck2 place2 airport2)"],
          "(unload-truck p2 truck2 airport2)",
        ],
      },
    ],
  },
  {
    name: "driverlog",
    title: "Drivers on foot",
    about:
      "The same 11 actions, but one package stays in the truck while its driver fetches another: that leaves the enemy five goals, not three.",
    plans: [
      {
        title: "Unload at once",
        plan: [
          ...["(load-truck p1 truck2 s1)", "(load-truck p2 truck2 s1)", "(board-truck driver1 truck2 s1)"],
          ...["(drive-truck truck2 s1 s2 driver1)", "(unload-truck p1 truck2 s2)", "(unload-truck p2 truck2 s2)"],
          ...["(leave-truck driver1 truck2 s2)", "(walk driver1 s2 f2-3)", "(walk driver1 f2-3 s3)"],
          ...["(board-truck driver1 truck1 s3)", "(drive-truck truck1 s3 s2 driver1)"],
        ],
      },
      {
        title: "Unload last",
        plan: [
          ...["(load-truck p1 truck2 s1)", "(load-truck p2 truck2 s1)", "(board-truck driver1 truck2 s1)"],
          ...["(drive-truck truck2 s1 s2 driver1)", "(unload-truck p1 truck2 s2)"],
          ...["(leave-truck driver1 truck2 s2)", "(walk driver1 s2 f2-3)", "(walk driver1 f2-3 s3)"],
          ...["(board-truck driver1 truck1 s3)", "(drive-truck truck1 s3 s2 driver1)"],
          "(unload-truck p2 truck2 s2)",
        ],
      },
    ],
  },
];

export const entryNamed = (name: string): Entry | undefined => entries.find((entry) => entry.name === name);
