// Where the table of the steps is scrolled to.

/** Keeps the row of the step shown in sight, without moving the page; who scrolls the table is let alone. */
export function followRow(root: ParentNode, step: number): void {
  const box = root.querySelector<HTMLElement>(".steps-scroll");
  const row = box?.querySelector<HTMLElement>("[aria-current=step]");
  if (!box || !row || box.dataset.followed === String(step)) return;
  box.dataset.followed = String(step);
  const head = box.querySelector("thead")?.clientHeight ?? 0;
  const top = row.offsetTop - head;
  const bottom = row.offsetTop + row.offsetHeight;
  if (top < box.scrollTop) box.scrollTop = top;
  else if (bottom > box.scrollTop + box.clientHeight) box.scrollTop = bottom - box.clientHeight;
}
