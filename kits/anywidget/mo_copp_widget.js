// The widget's side in the browser: an element whose step, plan, document and outcome are the model's. The model is
// Python's, or what a page of MyST says of it: then names may be missing, and nothing is sent back.

/** Attributes of the element that a model may hold; `plan`, `step` and `document` go both ways. */
const attributes = [
  ...["src", "problem", "watch", "solver", "k", "j", "horizon", "hide", "theme", "keys"],
  ...["loading", "worker-url", "wasm-url", "seed", "student", "exercise", "name", "required", "disabled"],
];

/** The script defines the element once a page. */
let defined = null;

function define(model) {
  if (customElements.get("mo-copp-playground") !== undefined) return Promise.resolve();
  const script = model.get("_script");
  defined ??= (script === undefined ? load(addressOf(model)) : loadText(script)).catch((error) => {
    defined = null;
    throw error;
  });
  return defined;
}

/** Without Python the script lies beside this file, or where the page says. */
const addressOf = (model) =>
  model.get("script") === undefined
    ? new URL("mo-copp-playground.js", import.meta.url).href
    : new URL(model.get("script"), document.baseURI).href;

const load = (address) => import(/* webpackIgnore: true */ /* @vite-ignore */ address);

function loadText(script) {
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  return load(address).finally(() => URL.revokeObjectURL(address));
}

async function render({ model, el }) {
  await define(model);
  const playground = document.createElement("mo-copp-playground");
  playground.setAttribute("link", "off");
  for (const name of attributes) follow(model, playground, name);
  const plan = model.get("plan") ?? [];
  if (plan.length > 0) playground.setAttribute("plan", plan.join(","));
  if ((model.get("step") ?? -1) >= 0) playground.setAttribute("step", String(model.get("step")));
  const opened = model.get("document") ?? null;
  if (opened !== null) playground.document = opened;
  listen(model, playground);
  el.append(playground);
  return () => playground.remove();
}

/** What Python calls an attribute: without dashes, and every widget has `keys` for itself. */
const inPython = (name) => (name === "keys" ? "keys_" : name.replaceAll("-", "_"));

/** An attribute that the model sets. */
function follow(model, playground, name) {
  const names = new Set([name, inPython(name)]);
  const set = () => {
    const value = [...names].map((name) => model.get(name)).find((value) => value != null) ?? "";
    if (value === "" || value === false) playground.removeAttribute(name);
    else if (value === true) playground.setAttribute(name, "");
    else playground.setAttribute(name, typeof value === "object" ? JSON.stringify(value) : String(value));
  };
  set();
  for (const name of names) model.on(`change:${name}`, set);
}

/** What is shown goes to Python; what Python sets is shown. */
function listen(model, playground) {
  if (model.get("_script") === undefined) return;
  const tell = (values) => {
    for (const [name, value] of Object.entries(values)) model.set(name, value);
    model.save_changes();
  };
  const same = (one, other) => JSON.stringify(one) === JSON.stringify(other);
  playground.addEventListener("mo-copp-step", ({ detail }) => {
    const { state, document } = playground;
    tell({ step: detail.step, plan: state?.plan ?? [], document });
  });
  playground.addEventListener("mo-copp-outcome", ({ detail }) =>
    tell({ outcome: detail, document: playground.document }),
  );
  model.on("change:step", () => {
    if (String(model.get("step")) === playground.dataset.step) return;
    // A step beyond the last is the last: Python is told which one is shown.
    const told = () => tell({ step: playground.state?.step ?? Number(playground.dataset.step) });
    playground.goTo(model.get("step")).then(told, told);
  });
  model.on("change:document", () => {
    const document = model.get("document");
    if (document !== null && !same(document, playground.document)) playground.document = document;
  });
  model.on("change:plan", () => {
    const plan = model.get("plan");
    if (same(plan, playground.state?.plan ?? [])) return;
    // The attribute may have this text already, from before a walk went on: taken away and set, it is followed again.
    playground.removeAttribute("plan");
    playground.setAttribute("plan", plan.join(","));
  });
}

export default { render };
