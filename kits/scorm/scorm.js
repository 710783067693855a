// Score and state of the playground for a course system that speaks SCORM 1.2.
(() => {
  /** SCORM 1.2 keeps no more characters. */
  const MOST_STATE = 4096;
  const PASSED = 50;
  const QUIET_MS = 1000;

  /** The course system's interface stands in a window around this one, or in the one that opened it. */
  function find(from) {
    for (let at = from, depth = 0; depth < 20; depth += 1) {
      try {
        if (at.API) return at.API;
        if (at.parent === at) return at.opener ? find(at.opener) : null;
        at = at.parent;
      } catch {
        return null; // Of another origin.
      }
    }
    return null;
  }

  const api = find(window);
  if (api === null || String(api.LMSInitialize("")) !== "true") return;
  // Without it some course systems forget what was kept.
  api.LMSSetValue("cmi.core.exit", "suspend");
  const get = (name) => String(api.LMSGetValue(name) ?? "");
  const playground = document.querySelector("mo-copp-playground");

  try {
    const kept = JSON.parse(get("cmi.suspend_data") || "null");
    if (kept !== null) playground.state = kept;
  } catch {
    // Kept by another program: the playground begins as its page says.
  }
  let best = get("cmi.core.score.raw") === "" ? -1 : Number(get("cmi.core.score.raw"));
  if (best < 0) api.LMSSetValue("cmi.core.lesson_status", "incomplete");

  playground.addEventListener("mo-copp-score", ({ detail }) => {
    const points = Math.round(detail.score * 100);
    if (points <= best) return;
    best = points;
    api.LMSSetValue("cmi.core.score.min", "0");
    api.LMSSetValue("cmi.core.score.max", "100");
    api.LMSSetValue("cmi.core.score.raw", String(points));
    api.LMSSetValue("cmi.core.lesson_status", points >= PASSED ? "passed" : "incomplete");
    api.LMSCommit("");
  });

  function keep() {
    const text = JSON.stringify(playground.state);
    if (text.length > MOST_STATE || text === "null") return;
    api.LMSSetValue("cmi.suspend_data", text);
    api.LMSCommit("");
  }
  let timer;
  for (const name of ["mo-copp-step", "mo-copp-outcome", "mo-copp-answer"]) {
    playground.addEventListener(name, () => {
      clearTimeout(timer);
      timer = setTimeout(keep, QUIET_MS);
    });
  }
  let ended = false;
  addEventListener("pagehide", () => {
    if (ended) return;
    ended = true;
    clearTimeout(timer);
    keep();
    api.LMSFinish("");
  });
})();
