// Brings the boards into view when a game begins: its button stands below them.

/** What stays of the window for the boards is what the bar of the steps leaves. */
export function boardsInView(element: Element | null, panel: string): void {
  const [stage, board] = [element?.querySelector(".stage"), element?.querySelector(panel)];
  if (!stage || !board) return;
  const bar = element?.querySelector(".stepper")?.clientHeight ?? 0;
  const { top, bottom } = board.getBoundingClientRect();
  if (top < 0 || bottom > innerHeight - bar) stage.scrollIntoView({ block: "start" });
}
