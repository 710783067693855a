// What the page saves as files. The browser may run elsewhere: its files come as streams.
import { buffer } from "node:stream/consumers";
import type { Download, Page } from "playwright-core";

interface Saved {
  name: string;
  text: string;
  bytes: Buffer;
}

async function savedAs(download: Download): Promise<Saved> {
  const bytes = await buffer(await download.createReadStream());
  return { name: download.suggestedFilename(), text: bytes.toString("utf8"), bytes };
}

/** What a button saves; `group`: the group that it stands in, where several have that name. */
export async function saved(page: Page, button: string, group = ""): Promise<Saved> {
  const place = group === "" ? page : page.getByRole("group", { name: group });
  const download = page.waitForEvent("download");
  await place.getByRole("button", { name: button, exact: true }).click();
  return savedAs(await download);
}
