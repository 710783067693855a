// Which tab of the workbench is open.
import { signal } from "@preact/signals-core";

export class Workbench {
  readonly tab = signal("solve");

  open(name: string): void {
    this.tab.value = name;
  }
}
