// The attributes of the element. No code but their names: the element's script stays small.

/** What is opened, and how it is solved. */
export const settingNames = ["src", "problem", "plan", "step", "solver", "k", "j", "horizon"] as const;

/** How the playground behaves in its page. */
const manners = ["hide", "link", "theme", "keys", "loading"] as const;

/** What an exercise is asked with. */
const questions = ["exercise", "seed", "student"] as const;

/** Followed live. */
export const followed: readonly string[] = [...settingNames, ...manners, ...questions];

/** Looked at once: when the element comes into the page, when its form is sent, when the first one starts the core. */
const once = ["name", "required", "disabled", "watch", "worker-url", "wasm-url"] as const;

/** Attributes without a value: being there is all that they say. */
export const flags: readonly string[] = ["watch", "required", "disabled"];

/** What is no attribute, and may be taken for one: its being there is said. */
export const propertiesAlone = ["document", "state"] as const;

export const attributes: readonly string[] = [...followed, ...once];

/** How an attribute without a value says that it is not there. */
export const no = "false";

/** Whether an attribute without a value is there; a framework that writes the values of others says `false` for no. */
export const isOn = (element: Element, name: string): boolean =>
  element.hasAttribute(name) && element.getAttribute(name) !== no;

/** Whether a text names a step; one beyond the last is the last. */
export const isStep = (text: string): boolean => /^\s*\d+\s*$/.test(text);
