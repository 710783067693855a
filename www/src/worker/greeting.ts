// The first word of a worker whose script the page places itself (`worker-url`): a script that is not this version's may
// run without an error, and would be waited for without end.
import { VERSION } from "./names.js";
import { chosenPlaces } from "./places.js";

/** A script that has come is at work at once; its host is asked for it only where no word has come by then. */
const WORD_MS = 3000;
/** So long after the script is known to be there, its silence is an answer. */
const SILENCE_MS = 5000;

export interface Hello {
  kind: "hello";
  version: string;
}

export class Greeting {
  private readonly placed = chosenPlaces().worker;
  private over = this.placed === null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly refuse: (message: string) => void) {
    if (!this.over) this.timer = setTimeout(() => void this.ask(), WORD_MS);
  }

  /** Whether a message is for the page, and no greeting. What is said before a greeting ends the worker. */
  takes<Message>(message: Message): message is Exclude<Message, Hello> {
    const { kind, version } = Object(message) as { kind?: unknown; version?: unknown };
    const greets = kind === "hello";
    if (this.over) return !greets;
    if (greets && version === VERSION) this.end();
    else if (greets) this.fail(`found version “${version}”, expected “${VERSION}”`);
    else this.fail("its first message is none of the worker’s");
    return false;
  }

  end(): void {
    this.over = true;
    clearTimeout(this.timer);
  }

  /** How long a script is on its way is the network's affair, and an address that does not answer is an error of its own. */
  private async ask(): Promise<void> {
    await fetch(new URL(this.placed ?? "", document.baseURI)).then(
      (response) => response.text(),
      () => null,
    );
    if (this.over) return;
    this.timer = setTimeout(() => this.fail("it runs, and gives no sign"), SILENCE_MS);
  }

  private fail(found: string): void {
    if (this.over) return;
    this.end();
    this.refuse(
      `what worker-url names, “${this.placed}”, is not its script: ${found}. It is the file solver.worker-….js of the same release as the element`,
    );
  }
}
