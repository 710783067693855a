// A drawing that grows by a row at a time. Without scripts, and in print, all of it is there.
import { button } from "./button.js";

export function grows(drawing: HTMLElement): void {
  const svg = drawing.querySelector("svg");
  const rows = [...drawing.querySelectorAll<SVGGElement>("[data-row]")];
  if (svg === null) return;
  const across = svg.viewBox.baseVal.width;
  const said = document.createElement("p");
  said.className = "said";
  said.setAttribute("role", "status");
  let shown = 0;
  /** Draws the rows up to one, says what they come to, and leaves no room for those after it. */
  const draw = (last: number) => {
    for (const [index, row] of rows.entries()) row.classList.toggle("later", index > last);
    svg.setAttribute("viewBox", `0 0 ${across} ${rows[last]?.dataset.down}`);
    const { said: words, known } = rows[last]?.dataset ?? {};
    said.textContent = `${words}. Different nodes so far: ${known}.`;
  };
  const go = (by: number) => {
    shown = Math.min(Math.max(shown + by, 0), rows.length - 1);
    draw(shown);
    // They stay where the focus is.
    back.setAttribute("aria-disabled", String(shown === 0));
    on.setAttribute("aria-disabled", String(shown === rows.length - 1));
  };
  const back = button("Back one step", () => go(-1));
  const on = button("Grow one step", () => go(1));
  const group = document.createElement("div");
  group.className = "buttons";
  group.setAttribute("role", "group");
  group.setAttribute("aria-label", "Grow the automaton");
  group.append(back, on);
  drawing.prepend(group, said);
  addEventListener("beforeprint", () => draw(rows.length - 1));
  addEventListener("afterprint", () => draw(shown));
  go(0);
}
