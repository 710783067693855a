// Which tab of the workbench is open.
import { signal } from "@preact/signals-core";

let made = 0;

export class Workbench {
  /** What the ids of this playground's parts begin with: several may stand in one page. */
  readonly id = `mo-copp-${++made}`;
  readonly tab = signal("solve");

  open(name: string): void {
    this.tab.value = name;
  }
}
