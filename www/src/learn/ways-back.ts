// A way back to the sentence whose link has scrolled a figure into sight: a button that follows the link, for the keyboard
// too, and stands at the foot of the window while the link is out of sight.
import { bringIntoView, isSeen } from "../element/into-view.js";
import { button } from "./button.js";

export function waysBack(): void {
  let link: HTMLElement | null = null;
  const back = button("Back to the text", () => {
    if (link === null) return;
    bringIntoView(link, "center");
    link.focus({ preventScroll: true });
    back.remove();
  });
  back.className = "way-back";
  const watch = new IntersectionObserver((entries) => {
    back.hidden = entries.at(-1)?.isIntersecting ?? false;
  });
  // Before the figure is scrolled to.
  document.addEventListener(
    "click",
    ({ target }) => {
      const part = target instanceof Element ? target.closest<HTMLElement>("a[data-mo-copp-for]") : null;
      const figure = document.getElementById(part?.dataset.moCoppFor ?? "");
      if (part === null || figure === null || isSeen(figure)) return;
      watch.disconnect();
      link = part;
      back.hidden = true;
      part.after(back);
      watch.observe(part);
    },
    true,
  );
}
