// Each attribute as a property: what is set is the attribute's text, and `null` or `undefined` takes it away.
import { attributes, flags, isOn } from "./attributes.js";

/** `worker-url` is `workerUrl`. */
const propertyOf = (attribute: string) => attribute.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase());

/** The properties that are attributes. */
export const reflected: readonly string[] = attributes.map(propertyOf);

/** Gives the class of the element its properties. */
export function reflect(prototype: HTMLElement): void {
  for (const attribute of attributes) {
    Object.defineProperty(prototype, propertyOf(attribute), {
      configurable: true,
      enumerable: true,
      get(this: HTMLElement) {
        return flags.includes(attribute) ? isOn(this, attribute) : this.getAttribute(attribute);
      },
      set(this: HTMLElement, value: unknown) {
        const text = textOf(value);
        if (text === null) this.removeAttribute(attribute);
        else this.setAttribute(attribute, text);
      },
    });
  }
}

/** Actions and parts may come as lists, and the block of an exercise as an object. */
function textOf(value: unknown): string | null {
  if (value === null || value === undefined || value === false) return null;
  if (value === true) return "";
  if (Array.isArray(value)) return value.join(",");
  return typeof value === "object" ? JSON.stringify(value) : String(value);
}
