// The page tools that the author kits are tried with (their style sheets too), and
// two independent programs that tests compare with, in a Python environment of the project's own: HiGHS solves the LP
// files that mo-copp writes (the tests get its Python by MO_COPP_HIGHS_PYTHON), pyperplan carries out the plans of
// `mo-copp plan` (MO_COPP_PYPERPLAN_PYTHON).
import { existsSync, rmSync } from "node:fs";
import { join } from "node:path";
import { which } from "../lib/environment.mjs";
import { inRoot, venv } from "../lib/paths.mjs";
import { read, run } from "../lib/run.mjs";
import { aptInstall } from "./debian.mjs";
import { SetupError, say } from "./report.mjs";

export const venvPython = join(venv, "bin", "python");
const requirements = inRoot("scripts", "setup", "python-requirements.txt");

export async function ensurePythonPackages() {
  const found = versions();
  if (found !== null) return say("HiGHS", `${found} in .tools/venv`);
  say("HiGHS", "installing highspy, pyperplan and the tools of the author kits into .tools/venv");
  if (!(await makeVenv())) {
    throw new SetupError("A Python environment could not be made.", "apt-get install python3 python3-venv   (as root)");
  }
  const args = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--requirement", requirements];
  if ((await run(venvPython, args)) !== 0 || versions() === null) {
    throw new SetupError("The Python packages could not be installed.", `${venvPython} ${args.join(" ")}`);
  }
}

const script = `
import anywidget, highspy, material, pypandoc, pyperplan.planner, sphinx, sphinx_rtd_theme
from importlib.metadata import version
print(f"highspy {version('highspy')}, pyperplan {version('pyperplan')} and the tools of the author kits")`;

const versions = () => (existsSync(venvPython) ? read(venvPython, ["-c", script]) : null);

async function makeVenv() {
  const make = async () => {
    rmSync(venv, { recursive: true, force: true });
    return which("python3") !== null && (await run("python3", ["-m", "venv", venv])) === 0;
  };
  // On Debian, python3 comes without what `venv` needs until python3-venv is there.
  return (await make()) || ((await aptInstall("python3", "python3-venv")) && (await make()));
}
