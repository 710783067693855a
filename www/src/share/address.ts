// The page's address as the place where a playground's state is kept: written while one works, read at the start and
// whenever somebody follows another link.
import { effect } from "@preact/signals-core";
import type { Solving } from "../state/solving.js";
import { pressed } from "../view/pressed.js";
import { isOwn, leadsSomewhere } from "./fragment.js";
import { LinkError, LONGEST_LINK, MOST_TEXT, pack, unpack } from "./packed.js";
import { type RestoreStores, restore } from "./restore.js";
import { keptState, readState, type SharedState, type TriedStores } from "./shared-state.js";

export interface AddressStores extends RestoreStores, TriedStores {
  solving: Solving;
}

/** Some browsers take a hundred changes of the address in half a minute, and then no more. */
const QUIET_MS = 400;

/** One playground of a page keeps its state in the address: the first that may. */
let owner: Address | null = null;

export class Address {
  /** What a link to the present state ends with; null where it was not worked out yet, or is too long. */
  private packed: string | null = null;
  private stop: (() => void) | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** The text that `packed` holds. */
  private text = "";
  /** How many links are being opened: what is between two states is not worth an address. */
  private restoring = 0;

  constructor(
    private readonly playground: AddressStores,
    /** Whether the page is another's: then fragments that are not ours are its own. */
    private readonly guest: boolean,
    /** Why a state may not be opened in this page; null where it may. */
    private readonly refusal: (state: SharedState) => string | null,
  ) {}

  /** Takes the address over, where no other playground has it. */
  claim(): boolean {
    if (owner !== null && owner !== this) return false;
    owner = this;
    window.addEventListener("hashchange", this.follow);
    this.stop ??= effect(() => this.watch());
    return true;
  }

  release(): void {
    if (owner === this) owner = null;
    window.removeEventListener("hashchange", this.follow);
    clearTimeout(this.timer);
    this.stop?.();
    this.stop = undefined;
  }

  /** Opens what the address holds: null where it holds nothing of ours. */
  async read(): Promise<boolean | null> {
    const fragment = location.hash.slice(1);
    if (fragment === "" || this.isForeign(fragment)) return null;
    this.restoring += 1;
    try {
      const state = readState(await unpack(fragment));
      const refused = this.refusal(state);
      if (refused !== null) throw new LinkError(refused);
      return await restore(this.playground, state);
    } catch (error) {
      if (!(error instanceof LinkError)) throw error;
      this.playground.solving.refuse(error.message);
      return false;
    } finally {
      this.restoring -= 1;
      // The address says what is on the page, not what could not be opened.
      this.text = "";
      this.watch();
    }
  }

  /** The link to the present state; null where it would be too long. */
  async link(): Promise<string | null> {
    await this.update();
    return this.present();
  }

  /** The link to the present state, if it is known already. */
  present(): string | null {
    const fragment = this.packed;
    if (fragment === null || this.text !== this.wanted()) return null;
    return `${withoutFragment()}#${fragment}`;
  }

  private readonly follow = () => {
    // What is on the page may have gone on from what the address held.
    if (location.hash.slice(1) === this.packed && this.text === this.wanted()) return;
    clearTimeout(this.timer);
    void this.read();
  };

  /** Runs again whenever the state changes. */
  private watch(): void {
    const wanted = this.wanted();
    const busy = this.playground.timeline.playing.value || pressed.value;
    clearTimeout(this.timer);
    if (wanted === null || busy || wanted === this.text) return;
    this.timer = setTimeout(() => void this.write(), QUIET_MS);
  }

  private wanted(): string | null {
    return keptState(this.playground);
  }

  private async write(): Promise<void> {
    if (this.restoring > 0) return;
    await this.update();
    const fragment = this.packed;
    const present = location.hash.slice(1);
    if (owner !== this || this.text !== this.wanted()) return;
    if (this.guest && present !== "" && this.isForeign(present)) return;
    try {
      // A problem that is too large for a link has none: an old one would be wrong.
      const address = withoutFragment();
      history.replaceState(history.state, "", fragment === null ? address : `${address}#${fragment}`);
    } catch {
      // A page inside another may not be allowed to; the link can be copied all the same.
    }
  }

  /** Whether a fragment is a place of the page, or, where the page is another's, anything but ours: a route, say. */
  private isForeign(fragment: string): boolean {
    return leadsSomewhere(fragment) || (this.guest && !isOwn(fragment));
  }

  private async update(): Promise<void> {
    const wanted = this.wanted();
    if (wanted === null || wanted === this.text) return;
    const packed = wanted.length > MOST_TEXT ? null : await pack(wanted);
    if (wanted !== this.wanted()) return;
    this.text = wanted;
    this.packed = packed === null || packed.length > LONGEST_LINK ? null : packed;
  }
}

/** The whole address of this page: a relative one would be resolved against a `<base>` that may be another page's. */
const withoutFragment = (): string => location.href.replace(/#.*$/s, "");
