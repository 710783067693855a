// What the page's own thread does while something happens: how long its longest task works, the time that other
// programs take from it left out.
import assert from "node:assert/strict";
import type { Page } from "playwright-core";

interface TraceEvent {
  name: string;
  ph: string;
  pid: number;
  tid: number;
  /** Microseconds of work of the thread itself. */
  tdur?: number;
  dur?: number;
  args: { name?: string };
}

export interface Work {
  /** The longest task, in milliseconds of work. */
  longest: number;
  /** All of them. */
  total: number;
}

/** Watches the page's main thread while `work` goes on. */
export async function watched(page: Page, work: () => Promise<void>): Promise<Work> {
  const browser = page.context().browser() ?? assert.fail("no browser");
  await browser.startTracing(page, { categories: ["toplevel", "__metadata"] });
  await work();
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString()) as { traceEvents: TraceEvent[] };
  const mains = traceEvents.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain");
  const tasks = traceEvents
    .filter(({ name, ph }) => name === "ThreadControllerImpl::RunTask" && ph === "X")
    .filter(({ pid, tid }) => mains.some((main) => main.pid === pid && main.tid === tid))
    .map(({ tdur, dur }) => (tdur ?? dur ?? 0) / 1000);
  assert.notEqual(tasks.length, 0);
  return { longest: Math.max(...tasks), total: tasks.reduce((sum, task) => sum + task, 0) };
}
