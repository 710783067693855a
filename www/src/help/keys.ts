// Every key that the page listens to. Whoever adds a key adds it here.
import { boardKeys } from "../gesture/keys.js";

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
    title: "Boards",
    where: "On a board of a grid, to edit it",
    keys: boardKeys.map(([keys, does]) => ({ keys: keys.split(" or "), does })),
  },
  {
    title: "Walking",
    where: "On the agent’s board, once you have taken over (tab “Play”)",
    keys: [
      { keys: ["Arrow keys"], does: "Go one cell" },
      { keys: ["S", "."], does: "Stay, where that is allowed" },
      { keys: ["Backspace"], does: "Take the last step back" },
    ],
  },
  {
    title: "Anywhere",
    where: "Outside text fields",
    keys: [
      { keys: ["Ctrl+Z"], does: "Take back the last edit" },
      { keys: ["Ctrl+Shift+Z", "Ctrl+Y"], does: "Make it again" },
      { keys: ["?"], does: "Open this help" },
      { keys: ["Escape"], does: "Close what is open" },
      { keys: ["Tab", "Shift+Tab"], does: "Next control, control before" },
    ],
  },
  {
    title: "Text",
    where: "In a text field of the tab “Document”",
    keys: [
      { keys: ["Ctrl+Enter"], does: "Use this problem" },
      { keys: ["F8"], does: "Go to the error" },
      { keys: ["Ctrl+Z"], does: "Take back what was typed" },
      { keys: ["Tab", "Shift+Tab"], does: "Indent, less" },
      { keys: ["Escape, then Tab"], does: "Leave the field for the next control" },
    ],
  },
  {
    title: "Pictures of the trade-off",
    where: "On a point",
    keys: [
      { keys: ["Arrow keys"], does: "Go to the next point there" },
      { keys: ["Enter", "Space"], does: "Show its plan on the boards" },
    ],
  },
  {
    title: "Numbers",
    where: "In a field between − and +",
    keys: [{ keys: ["↑", "↓"], does: "One more, one less" }],
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
