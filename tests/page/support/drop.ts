// Dragging files and text over a part of the page and dropping them there.
import type { Page } from "playwright-core";

export interface Dropped {
  files?: { name: string; text: string }[];
  text?: string;
}

/** Drags something over the page and drops it on a part of it. `meanwhile` runs before the drop. */
export async function drop(page: Page, on: string, what: Dropped, meanwhile?: () => Promise<unknown>): Promise<void> {
  const data = await page.evaluateHandle(({ files = [], text }: Dropped) => {
    const transfer = new DataTransfer();
    for (const file of files) transfer.items.add(new File([file.text], file.name, { type: "application/json" }));
    if (text !== undefined) transfer.setData("text/plain", text);
    return transfer;
  }, what);
  await page.dispatchEvent(on, "dragenter", { dataTransfer: data });
  await page.dispatchEvent(on, "dragover", { dataTransfer: data });
  await meanwhile?.();
  await page.dispatchEvent(on, "drop", { dataTransfer: data });
}
