// The workbench: everything that can be done with the problem shown, one tab for each kind of work.
import { html, type TemplateResult } from "lit";
import type { AuthorPanelStores } from "../author/stores.js";
import type { EditPanelStores } from "../edit/edit-panel.js";
import type { PlayPanelStores } from "../play/play-panel.js";
import type { CompareStores } from "../solve/compare/compare.js";
import { type SolverFormStores, solverForm } from "../solve/solver-form.js";
import type { TradeoffStores } from "../solve/tradeoff/tradeoff.js";
import type { Workbench } from "../state/workbench.js";
import type { StepsTableStores } from "../steps/steps-table.js";
import type { DocumentFormStores } from "../text/document-form.js";
import { LazyPanel, type Panel } from "./lazy-panel.js";

/** What the tabs show, taken together: each is given it as what it needs of it alone. */
export interface WorkbenchStores
  extends SolverFormStores,
    EditPanelStores,
    PlayPanelStores,
    CompareStores,
    TradeoffStores,
    StepsTableStores,
    DocumentFormStores,
    AuthorPanelStores {}

export interface Tab {
  name: string;
  title: string;
  panel: Panel<WorkbenchStores>;
}

/** The tabs that solve, or make another question of the problem. */
const solving: ReadonlySet<string> = new Set(["solve", "compare", "trade-off", "exercise"]);

/** The tab that shows what observers believe. */
const BELIEFS = "steps";

const tabsOf = ({ problem: { closed, veiled } }: Pick<WorkbenchStores, "problem">): readonly Tab[] =>
  tabs.filter(({ name }) => !(closed.value && solving.has(name)) && !(veiled.value && name === BELIEFS));

const lazy = <Stores>(load: () => Promise<Panel<Stores>>): Panel<Stores> => new LazyPanel(load).panel;

/** The tabs, in the order shown. Only the first is there from the beginning; the page is shown sooner without the others. */
export const tabs: readonly Tab[] = [
  { name: "solve", title: "Solve", panel: solverForm },
  { name: "edit", title: "Edit", panel: lazy(async () => (await import("../edit/edit-panel.js")).editPanel) },
  { name: "play", title: "Play", panel: lazy(async () => (await import("../play/play-panel.js")).playPanel) },
  { name: "compare", title: "Compare", panel: lazy(async () => (await import("../solve/compare/compare.js")).compare) },
  {
    name: "trade-off",
    title: "Trade-off",
    panel: lazy(async () => (await import("../solve/tradeoff/tradeoff.js")).tradeoff),
  },
  { name: "steps", title: "Steps", panel: lazy(async () => (await import("../steps/steps-table.js")).stepsTable) },
  {
    name: "document",
    title: "Document",
    panel: lazy(async () => (await import("../text/document-form.js")).documentForm),
  },
  {
    name: "exercise",
    title: "Exercise",
    panel: lazy(async () => (await import("../author/author-panel.js")).authorPanel),
  },
];

export function workbench(stores: WorkbenchStores): TemplateResult {
  const bench = stores.workbench;
  const offered = tabsOf(stores);
  // The other tabs would tell the enemy what it must not know.
  const guessing = stores.boards.mode.value === "guess";
  const id = (kind: string, name: string) => `${bench.id}-${kind}-${name}`;
  // A link may name a tab that this page does not have.
  const open = guessing ? "play" : (offered.find(({ name }) => name === bench.tab.value) ?? offered[0])?.name;
  return html`<section class="card workbench" part="workbench" aria-label="Workbench">
    <div class="tabs" role="tablist" aria-label="Workbench" @keydown=${keys(bench, offered)}>
      ${offered.map(
        ({
          name,
          title,
        }) => html`<button type="button" role="tab" id=${id("tab", name)} data-tab=${name} aria-selected=${String(name === open)}
          aria-controls=${id("panel", name)} tabindex=${name === open ? 0 : -1} ?disabled=${guessing && name !== open}
          @click=${() => bench.open(name)}>${title}</button>`,
      )}
    </div>
    ${offered.map(
      ({
        name,
        panel,
      }) => html`<div class="tab-panel" role="tabpanel" id=${id("panel", name)} aria-labelledby=${id("tab", name)}
        ?hidden=${name !== open}>${name === open ? panel(stores) : ""}</div>`,
    )}
  </section>`;
}

/** Arrow keys, Home and End go through the tabs, as in any list of tabs. */
function keys(bench: Workbench, tabs: readonly Tab[]) {
  return (event: KeyboardEvent) => {
    const at = tabs.findIndex(({ name }) => name === bench.tab.value);
    const target: Record<string, number> = {
      ArrowLeft: (at - 1 + tabs.length) % tabs.length,
      ArrowRight: (at + 1) % tabs.length,
      Home: 0,
      End: tabs.length - 1,
    };
    const tab = tabs[target[event.key] ?? -1];
    if (tab === undefined) return;
    event.preventDefault();
    bench.open(tab.name);
    const list = event.currentTarget as HTMLElement;
    list.querySelector<HTMLElement>(`[data-tab="${tab.name}"]`)?.focus();
  };
}
