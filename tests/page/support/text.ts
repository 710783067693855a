// The text fields of the tab "Document", as a person reads and works them.
import type { Page } from "playwright-core";

export const field = (page: Page, name = "Problem document (JSON)") => page.getByLabel(name, { exact: true });

/** Waits until a field shows this text, as far as its lines are drawn. */
export const textIs = (page: Page, text: string, name = "Problem document (JSON)") =>
  page.waitForFunction(
    ([text = "", name]) =>
      Array.from(document.querySelectorAll(".text-field"), (element) => element.shadowRoot)
        .map((root) => root?.querySelector(`[aria-label="${name}"]`))
        .some((content) => {
          const lines = Array.from(content?.querySelectorAll(".cm-line") ?? [], (line) => line.textContent).join("\n");
          const more = content?.lastElementChild?.matches(".cm-gap") === true;
          return content && (more ? lines.length > 400 && text.startsWith(lines) : lines === text);
        }),
    [text, name],
  );

/** Each line of the field, and under it in brackets the message that stands there. */
export const linesOf = (page: Page, name = "Problem document (JSON)"): Promise<string[]> =>
  field(page, name).evaluate((content) =>
    Array.from(content.children, (child) =>
      child.classList.contains("cm-line") ? (child.textContent ?? "") : `[${child.textContent}]`,
    ),
  );

/** What is said below a field. */
export const said = (page: Page, words: string | RegExp) =>
  page.locator(".cm-faults").getByRole("status").getByText(words);

/** Pastes as from the clipboard. */
export const paste = (page: Page, text: string, name = "Problem document (JSON)") =>
  field(page, name).evaluate((content, text) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", text);
    content.dispatchEvent(
      new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true, composed: true }),
    );
  }, text);

/** Replaces the first of some words in a field by others, with the mouse and the keyboard. */
export async function retype(page: Page, word: string, other: string, name?: string): Promise<void> {
  await field(page, name).scrollIntoViewIfNeeded();
  const box = await field(page, name).evaluate((content, word) => {
    const texts = document.createTreeWalker(content, NodeFilter.SHOW_TEXT);
    for (let text = texts.nextNode(); text !== null; text = texts.nextNode()) {
      const at = text.textContent?.search(new RegExp(`\\b${word}\\b`)) ?? -1;
      if (at < 0) continue;
      const range = document.createRange();
      range.setStart(text, at);
      range.setEnd(text, at + word.length);
      const { x, y, width, height } = range.getBoundingClientRect();
      return { x: x + width / 2, y: y + height / 2 };
    }
    throw new Error(`“${word}” is not drawn`);
  }, word);
  await page.mouse.dblclick(box.x, box.y);
  await page.keyboard.type(other);
}

/** Puts a text in the place of all that stands in a field. */
export async function put(page: Page, text: string, name?: string): Promise<void> {
  await field(page, name).focus();
  await page.keyboard.press("Control+a");
  if (text === "") await page.keyboard.press("Delete");
  else await page.keyboard.insertText(text);
}
