// What a frame and the page around it say to each other: docs/frames.md has the table. Version 1.
//
// Out go the frame's height, each step, each outcome, the score and the state; in come a step, a theme, a document and a
// state. Beside our own messages stand those that course systems know: `lti.frameResize` and the SPLICE messages. What
// comes from any window but the one around the frame, or has another shape, is ignored.
import type { MoCoppPlayground } from "../element/mo-copp-playground.js";
import { messageId } from "./message-id.js";
import { isObject, isSpliceState, readCommand } from "./shapes.js";

export const PROTOCOL = "mo-copp";
export const VERSION = 1;

/** A state that changes all the time is told when it has come to rest. */
const QUIET_MS = 500;

/** Begins to talk, where there is a page around this one. */
export function talk(playground: MoCoppPlayground): void {
  if (window.parent === window) return;
  const asked = messageId();
  listen(playground, asked);
  tellHeight();
  tellSteps(playground);
  tellScoreAndState(playground);
  tell({ event: "ready" });
  send({
    subject: "SPLICE.getState",
    message_id: asked,
    activity_id: location.href.replace(/#.*$/s, ""),
  });
}

/** Nothing that is told is a secret: it is what the page around the frame asked the frame to show. */
const send = (message: object) => window.parent.postMessage(message, "*");

const tell = (message: object) => send({ type: PROTOCOL, version: VERSION, ...message });

/** `asked`: the message by which the state of the last visit was asked for. */
function listen(playground: MoCoppPlayground, asked: string): void {
  window.addEventListener("message", ({ source, data }: MessageEvent<unknown>) => {
    if (source !== window.parent || !isObject(data)) return;
    if (isSpliceState(data, asked)) {
      playground.state = data.state as typeof playground.state;
      return;
    }
    const command = readCommand(data, PROTOCOL, VERSION);
    if (command === null) return;
    if (command.command === "step") playground.goTo(command.step).catch(() => undefined);
    else if (command.command === "theme") playground.setAttribute("theme", command.theme);
    else if (command.command === "document") playground.document = command.document;
    else playground.state = command.state as typeof playground.state;
  });
}

function tellHeight(): void {
  let told = 0;
  const measure = () => {
    const height = Math.ceil(document.body.getBoundingClientRect().height);
    if (height === told || height === 0) return;
    told = height;
    send({ subject: "lti.frameResize", height });
    tell({ event: "height", height });
  };
  new ResizeObserver(measure).observe(document.body);
  measure();
}

function tellSteps(playground: MoCoppPlayground): void {
  playground.addEventListener("mo-copp-step", (event) =>
    tell({ event: "step", detail: (event as CustomEvent).detail }),
  );
  playground.addEventListener("mo-copp-outcome", (event) => {
    tell({ event: "outcome", detail: (event as CustomEvent).detail });
  });
}

function tellScoreAndState(playground: MoCoppPlayground): void {
  let score: number | null = null;
  let told = "";
  let timer: ReturnType<typeof setTimeout> | undefined;
  const now = () => {
    const { state } = playground;
    const text = JSON.stringify([score, state]);
    if (state === null || text === told) return;
    told = text;
    tell({ event: "state", score, state });
    send({
      subject: "SPLICE.reportScoreAndState",
      message_id: messageId(),
      activity_id: location.href.replace(/#.*$/s, ""),
      ...(score === null ? {} : { score }),
      state,
    });
  };
  const later = () => {
    clearTimeout(timer);
    timer = setTimeout(now, QUIET_MS);
  };
  playground.addEventListener("mo-copp-score", (event) => {
    score = (event as CustomEvent<{ score: number }>).detail.score;
    tell({ event: "score", score });
    later();
  });
  playground.addEventListener("mo-copp-answer", (event) => {
    tell({ event: "answer", detail: (event as CustomEvent).detail });
    later();
  });
  for (const name of ["mo-copp-step", "mo-copp-outcome"]) playground.addEventListener(name, later);
}
