// Every key that the page listens to. Whoever adds a key adds it here.

export interface KeyGroup {
  title: string;
  /** Where these keys work. */
  where: string;
  keys: readonly { keys: readonly string[]; does: string }[];
}

export const keyGroups: readonly KeyGroup[] = [
  {
    title: "Steps",
    where: "Anywhere but in fields and lists, which have keys of their own",
    keys: [
      { keys: ["←", "→"], does: "One step back, one step forward" },
      { keys: ["Home", "End"], does: "First step, last step" },
      { keys: ["Space"], does: "Play or pause" },
    ],
  },
  {
    title: "Anywhere",
    where: "Outside text fields",
    keys: [
      { keys: ["?"], does: "Open this help" },
      { keys: ["Escape"], does: "Close what is open" },
      { keys: ["Tab", "Shift+Tab"], does: "Next control, control before" },
    ],
  },
  {
    title: "Tabs",
    where: "On a tab of the workbench",
    keys: [
      { keys: ["←", "→"], does: "Tab before, next tab" },
      { keys: ["Home", "End"], does: "First tab, last tab" },
    ],
  },
];
