// Workers that do just what a test tells them, in place of a browser's.
import assert from "node:assert/strict";
import type { CoreMessage, Message, Reply } from "../../../www/src/worker/protocol.js";

export class ScriptedWorker {
  static all: ScriptedWorker[] = [];
  readonly heard: Message[] = [];
  ended = false;
  onmessage: ((event: { data: Reply }) => void) | null = null;
  onerror: ((event: { message: string; preventDefault(): void }) => void) | null = null;

  constructor() {
    ScriptedWorker.all.push(this);
  }
  postMessage(message: Message | CoreMessage): void {
    // Where the cores are is told to each.
    if (!("core" in message)) this.heard.push(message);
  }
  terminate(): void {
    this.ended = true;
  }
  say(reply: Reply): void {
    this.onmessage?.({ data: reply });
  }
  /** The newest one. */
  static get last(): ScriptedWorker {
    return ScriptedWorker.all.at(-1) ?? assert.fail("no worker was started");
  }
}
Object.assign(globalThis, { Worker: ScriptedWorker });
