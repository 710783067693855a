// The address that a link to a made exercise begins with: the page's own, without what it asks of the playground.
import { settingNames } from "./attributes.js";

/** What the address of the playground's own page may ask of it (site.ts): attributes by their names. */
export const addressKeys = [...settingNames, "hide", "theme", "keys", "exercise", "seed", "student"] as const;

export function linkAddressOf(host: Element): string {
  const address = new URL(location.href);
  address.hash = "";
  // Any other page reads its address for itself.
  const keys = host.getAttribute("root") === "page" ? addressKeys : [];
  for (const key of keys) if (address.searchParams.has(key)) address.searchParams.delete(key);
  return address.href;
}
