// Long lists in turns: the first of them at once, the others a few at a time, so that the page stays alive meanwhile.
import { noChange, nothing, render, type TemplateResult } from "lit";
import { AsyncDirective } from "lit/async-directive.js";
import { type ChildPart, type DirectiveResult, directive } from "lit/directive.js";

/** That many are drawn in one go: a few milliseconds of work. */
const AT_ONCE = 40;

type Draw<Item> = (item: Item, index: number) => TemplateResult;

class InTurns extends AsyncDirective {
  /** What stands behind each part of the list. */
  private ends: Comment[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;

  render<Item>(_items: readonly Item[], _draw: Draw<Item>): typeof noChange {
    return noChange;
  }

  override update<Item>(part: ChildPart, [items, draw]: [readonly Item[], Draw<Item>]): typeof noChange {
    clearTimeout(this.timer);
    const count = Math.max(1, Math.ceil(items.length / AT_ONCE));
    for (const end of this.ends.splice(count)) {
      render(nothing, end.parentNode as HTMLElement, { renderBefore: end });
      end.remove();
    }
    this.go(part, items, draw, 0, count);
    return noChange;
  }

  override disconnected(): void {
    clearTimeout(this.timer);
  }

  private go<Item>(part: ChildPart, items: readonly Item[], draw: Draw<Item>, at: number, count: number): void {
    const end = this.ends[at] ?? this.another(part);
    const from = at * AT_ONCE;
    const drawn = items.slice(from, from + AT_ONCE).map((item, index) => draw(item, from + index));
    render(drawn, end.parentNode as HTMLElement, { renderBefore: end });
    if (at + 1 < count) this.timer = setTimeout(() => this.go(part, items, draw, at + 1, count));
  }

  private another(part: ChildPart): Comment {
    const end = document.createComment("");
    part.parentNode.insertBefore(end, part.endNode);
    this.ends.push(end);
    return end;
  }
}

const inTurnsDirective = directive(InTurns);

/** `draw` draws an item; what it reads of the state it is given, since later turns do not watch the state. */
export const inTurns = <Item>(items: readonly Item[], draw: Draw<Item>): DirectiveResult =>
  inTurnsDirective(items, draw as Draw<unknown>);
