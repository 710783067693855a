// Letting waiting messages be taken between two slices of work.
// A message channel, not a timer: browsers slow nested timers down to four milliseconds and more.

const waiting: (() => void)[] = [];
/** Made when it is needed: where there is no page, an open channel would keep the program from ending. */
let channel: MessageChannel | null = null;

export function nextTurn(): Promise<void> {
  channel ??= opened();
  const { port2 } = channel;
  return new Promise((resolve) => {
    waiting.push(resolve);
    port2.postMessage(null);
  });
}

function opened(): MessageChannel {
  const made = new MessageChannel();
  made.port1.onmessage = () => waiting.shift()?.();
  return made;
}
