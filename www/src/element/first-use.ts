// When the full core is worth its way, before anything needs it: on the playground's own page at once, in a page of
// other people once somebody is at work in the playground, and not for those who only read past it.
import { pagePool } from "../worker/pool.js";
import { isOwnPage } from "./settings.js";
import { signs } from "./signs.js";

export class FirstUse {
  constructor(private readonly host: HTMLElement) {}

  listen(): void {
    if (isOwnPage(this.host)) pagePool.lookAhead();
    else for (const sign of signs) this.host.addEventListener(sign, this.begun, true);
  }

  release(): void {
    for (const sign of signs) this.host.removeEventListener(sign, this.begun, true);
  }

  private readonly begun = () => {
    this.release();
    pagePool.lookAhead();
  };
}
