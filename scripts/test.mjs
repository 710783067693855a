// `npm test`: every check there is. `npm test -- GROUP...`, or the shorter `npm run test:GROUP`, runs some of them.
// Each check runs even when an earlier one failed, so that one run tells everything.
import { setUp } from "./setup/all.mjs";
import { runSteps } from "./test/runner.mjs";
import { groups, steps } from "./test/steps.mjs";

const asked = process.argv.slice(2);
const unknown = asked.find((name) => !(name in groups));
if (unknown !== undefined) {
  console.error(`There is no group "${unknown}". The groups: ${Object.keys(groups).join(", ")}.`);
  process.exit(2);
}
const chosen = asked.length > 0 ? asked : Object.keys(groups);

await setUp(...chosen.flatMap((name) => groups[name]));
process.exitCode = await runSteps(steps.filter((step) => step.groups.some((name) => chosen.includes(name))));
