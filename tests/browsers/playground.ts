// Finding and working the playground's parts by the names that a person sees.
import { type Driver, waitFor } from "./drivers/driver.js";

/** An expression: the playground with these attributes. */
export const playground = (attributes: string) =>
  `document.querySelector(${JSON.stringify(`mo-copp-playground${attributes}`)})`;

/** An expression: the visible element of this name. */
export const named = (
  selector: string,
  name: string,
  root = "document",
) => `all(${JSON.stringify(selector)}, ${root}).find(
  (one) => (one.getAttribute("aria-label") ?? one.textContent).trim() === ${JSON.stringify(name)} && one.getClientRects().length > 0)`;

/** A button; the tabs are none. */
export const button = (name: string, root?: string) => named("button:not([role=tab])", name, root);

/** An expression: the field whose label begins so. */
export const labelled = (label: string) => `all("label")
  .filter(({ textContent }) => textContent.trim().startsWith(${JSON.stringify(label)}))
  .map((label) => label.control ?? label.querySelector("input, select"))[0]`;

/** Presses what may have to appear first. */
export async function press(driver: Driver, element: string): Promise<void> {
  await waitFor(driver, element);
  await driver.click(element);
}

/** Opens a tab of the workbench. */
export const show = (driver: Driver, tab: string) => press(driver, named("[role=tab]", tab));

/** Chooses in a field of choices, as its change would tell the page. */
export async function choose(driver: Driver, label: string, value: string): Promise<void> {
  await waitFor(driver, labelled(label));
  await driver.evaluate(`((field) => {
    field.value = ${JSON.stringify(value)};
    field.dispatchEvent(new Event("input", { bubbles: true, composed: true }));
    field.dispatchEvent(new Event("change", { bubbles: true, composed: true }));
    return null;
  })(${labelled(label)})`);
}
