// The worker: the only place that runs the core. One task at a time; a newer one makes the older ones stale.
import type { Eliminations, SolveOptions } from "../core.js";
import { type Core, loadFirst, lookAhead, onCore, type Problem, takeCore } from "./cores.js";
import { asked, judged, proved, sketched } from "./exercises.js";
import { failure, faultIn, unstarted } from "./failure.js";
import { VERSION } from "./names.js";
import type { Answer, CoreMessage, Fault, Message, Reply, Task } from "./protocol.js";
import { inSlices } from "./slices.js";
import { nextTurn } from "./turn.js";

/** What takes longer shows the document first and the plan later; what does not, both at once. */
const SHOW_AFTER_MS = 60;
/** Nobody looks at more states of one belief; where there are more, the trace says what they have in common. */
const MOST_STATES = 100;

let newest = 0;
let cancelled = 0;
let open: { core: Core; document: string; problem: Problem } | null = null;

const post = (reply: Reply) => self.postMessage(reply);
post({ kind: "hello", version: VERSION });
const loaded = loadFirst(() => post({ kind: "ask" })).then(() => post({ kind: "ready" }));
// Each task waits for it and reports its failure; this only keeps the console quiet until one does.
loaded.catch(() => undefined);

self.onmessage = ({ data }: MessageEvent<Message | CoreMessage>) => {
  if ("core" in data) {
    takeCore(data);
  } else if (data.kind === "cancel") {
    cancelled = data.id;
  } else if (data.kind === "ahead") {
    lookAhead();
  } else {
    newest = data.id;
    void handle(data, data.id);
  }
};

async function handle(task: Task, id: number): Promise<void> {
  try {
    await loaded;
  } catch (error) {
    post({ ...unstarted(error), id });
    return;
  }
  try {
    // Requests that came in the meantime are taken first, so that of many only the last is worked on.
    await nextTurn();
    if (id !== newest) return;
    const answer = await onCore((core) => perform(core, task, id), {
      begun: () => post({ kind: "started", id }),
      fetching: () => post({ kind: "fetching", id }),
      stale: () => id !== newest,
    });
    if (answer !== null && id === newest) post({ ...answer, id });
  } catch (error) {
    post({ ...failure(error), id });
  }
}

function perform(core: Core, task: Task, id: number): Answer | Promise<Answer> {
  if (task.kind === "check") return { kind: "checked", fault: checked(core, task.document) };
  if (task.kind === "exercise") return asked(core, task);
  if (task.kind === "prove") return proved(core, task);
  if (task.kind === "judge") return judged(core, task);
  if (task.kind === "sketch") return sketched(core, task);
  const problem = opened(core, task.document);
  switch (task.kind) {
    case "begin":
      return { kind: "begun", scene: problem.scene(), start: problem.overview([], MOST_STATES) };
    case "trace":
      return { kind: "traced", trace: problem.overview(task.plan, MOST_STATES) };
    case "walk":
      return { kind: "walked", trace: problem.overview(task.plan, MOST_STATES), next: problem.next(task.plan) };
    case "explain":
      return { kind: "explained", eliminations: explained(problem, task) };
    case "solve":
      return solve(problem, task.options, id);
    case "picture":
      return { kind: "drawn", svg: problem.picture(task.plan, task.options) };
    case "advise":
      return advise(problem, task.options, id);
  }
}

function explained(problem: Problem, { plan, goal, step }: Extract<Task, { kind: "explain" }>): Eliminations {
  const of = (observer: string) =>
    problem.elimination(plan, observer, goal, step) ?? problem.nearest(plan, observer, goal, step);
  return { adversarial: of("adversarial"), cooperative: of("cooperative") };
}

function checked(core: Core, document: string): Fault | null {
  try {
    new core.Problem(document).free();
    return null;
  } catch (error) {
    const fault = faultIn(error);
    if (fault === null) throw error;
    return fault;
  }
}

function opened(core: Core, document: string): Problem {
  if (open?.core !== core || open.document !== document) {
    const problem = new core.Problem(document);
    open?.problem.free();
    open = { core, document, problem };
  }
  return open.problem;
}

async function solve(problem: Problem, options: SolveOptions, id: number): Promise<Answer> {
  const started = performance.now();
  let shown = false;
  const show = () => {
    if (!shown) post({ kind: "opened", scene: problem.scene(), start: problem.overview([], MOST_STATES), id });
    shown = true;
  };
  const run = start(problem, options, show);
  // One node of an integer program can take long: who waits for it should see what it is about, and can cancel.
  if (options.solver === "ip") show();
  await inSlices(
    run,
    () => {
      if (performance.now() - started > SHOW_AFTER_MS) show();
      return cancelled === id || newest !== id;
    },
    (progress) => post({ kind: "progress", id, progress }),
  );
  const outcome = run.outcome();
  run.free();
  // A newer task may have opened another problem meanwhile; then nobody waits for this answer.
  if (newest !== id) return { kind: "refused", message: "" };
  return { kind: "solved", scene: problem.scene(), outcome, trace: problem.overview(outcome.plan ?? [], MOST_STATES) };
}

async function advise(problem: Problem, options: SolveOptions, id: number): Promise<Answer> {
  const run = problem.remedy(options);
  await inSlices(
    run,
    () => cancelled === id || newest !== id,
    () => undefined,
  );
  const advice = run.outcome();
  run.free();
  return { kind: "advised", advice };
}

/** Options that do not fit are no reason not to show the document. */
function start(problem: Problem, options: SolveOptions, show: () => void): ReturnType<Problem["solve"]> {
  try {
    return problem.solve(options);
  } catch (error) {
    show();
    throw error;
  }
}
