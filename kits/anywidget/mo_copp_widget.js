// The widget's side in the browser: an element whose step, plan, document and outcome are the model's.

/** The script defines the element once a page. */
let defined = null;

function define(script) {
  if (customElements.get("mo-copp-playground") !== undefined) return Promise.resolve();
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  defined ??= import(/* webpackIgnore: true */ address).finally(() => URL.revokeObjectURL(address));
  return defined;
}

async function render({ model, el }) {
  await define(model.get("_script"));
  const playground = document.createElement("mo-copp-playground");
  playground.setAttribute("link", "off");
  for (const name of ["problem", "hide", "theme", "solver"]) follow(model, playground, name);
  const plan = model.get("plan");
  if (plan.length > 0) playground.setAttribute("plan", plan.join(","));
  if (model.get("step") >= 0) playground.setAttribute("step", String(model.get("step")));
  if (model.get("document") !== null) playground.document = model.get("document");
  listen(model, playground);
  el.append(playground);
  return () => playground.remove();
}

/** An attribute that Python sets. */
function follow(model, playground, name) {
  const set = () => {
    const value = model.get(name);
    if (value === "") playground.removeAttribute(name);
    else playground.setAttribute(name, value);
  };
  set();
  model.on(`change:${name}`, set);
}

/** What is shown goes to Python; what Python sets is shown. */
function listen(model, playground) {
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
    if (String(model.get("step")) !== playground.dataset.step) void playground.goTo(model.get("step"));
  });
  model.on("change:document", () => {
    const document = model.get("document");
    if (document !== null && !same(document, playground.document)) playground.document = document;
  });
  model.on("change:plan", () => {
    const plan = model.get("plan");
    if (!same(plan, playground.state?.plan ?? [])) playground.setAttribute("plan", plan.join(","));
  });
}

export default { render };
