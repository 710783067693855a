// HiGHS, an independent integer-program solver, in a Python environment of the project's own:
// a Rust test has it solve the LP files that mo-copp writes. The tests get its Python by MO_COPP_HIGHS_PYTHON.
import { existsSync, rmSync } from "node:fs";
import { join } from "node:path";
import { which } from "../lib/environment.mjs";
import { inRoot, venv } from "../lib/paths.mjs";
import { read, run } from "../lib/run.mjs";
import { aptInstall } from "./debian.mjs";
import { SetupError, say } from "./report.mjs";

export const highsPython = join(venv, "bin", "python");
const requirements = inRoot("scripts", "setup", "python-requirements.txt");

export async function ensureHighs() {
  const found = version();
  if (found !== null) return say("HiGHS", `highspy ${found} in .tools/venv`);
  say("HiGHS", "installing highspy into .tools/venv");
  if (!(await makeVenv())) {
    throw new SetupError("A Python environment could not be made.", "apt-get install python3 python3-venv   (as root)");
  }
  const args = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--requirement", requirements];
  if ((await run(highsPython, args)) !== 0 || version() === null) {
    throw new SetupError("highspy could not be installed.", `${highsPython} ${args.join(" ")}`);
  }
}

const version = () =>
  existsSync(highsPython)
    ? read(highsPython, ["-c", "import highspy; from importlib.metadata import version; print(version('highspy'))"])
    : null;

async function makeVenv() {
  const make = async () => {
    rmSync(venv, { recursive: true, force: true });
    return which("python3") !== null && (await run("python3", ["-m", "venv", venv])) === 0;
  };
  // On Debian, python3 comes without what `venv` needs until python3-venv is there.
  return (await make()) || ((await aptInstall("python3", "python3-venv")) && (await make()));
}
