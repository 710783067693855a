// A drawing through which a unit flows: each button lights the arcs of another plan.
import { button } from "./button.js";

interface Flow {
  plan: string;
  arcs: string[];
  said: string;
}

export function flows(drawing: HTMLElement): void {
  const all: Flow[] = JSON.parse(drawing.dataset.flows ?? "[]");
  const said = drawing.querySelector(".said");
  const group = document.createElement("div");
  group.className = "buttons";
  group.setAttribute("role", "group");
  group.setAttribute("aria-label", "Send the unit along a plan");
  const show = (flow: Flow, pressed: Element) => {
    for (const arc of drawing.querySelectorAll<SVGPathElement>("[data-arc]"))
      arc.classList.toggle("lit", flow.arcs.includes(arc.dataset.arc ?? ""));
    for (const other of group.children) other.setAttribute("aria-pressed", String(other === pressed));
    if (said !== null && said.textContent !== flow.said) said.textContent = flow.said;
  };
  for (const flow of all) {
    const choice = button(flow.plan, () => show(flow, choice));
    group.append(choice);
  }
  drawing.prepend(group);
  const [flow, pressed] = [all[0], group.firstElementChild];
  if (flow !== undefined && pressed !== null) show(flow, pressed);
}
