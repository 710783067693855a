// Debian packages, where apt-get is there and we may use it: as root, or by a sudo that asks no password.
import { which } from "../lib/environment.mjs";
import { read, run } from "../lib/run.mjs";

let listsFresh = false;

/** Installs the packages; false where that isn't possible on this machine or fails. */
export async function aptInstall(...packages) {
  const apt = rootCommand();
  if (apt === null) return false;
  if (!listsFresh) {
    if ((await run(apt[0], [...apt.slice(1), "update", "-qq"])) !== 0) return false;
    listsFresh = true;
  }
  const install = ["install", "-y", "-qq", "--no-install-recommends", ...packages];
  return (await run(apt[0], [...apt.slice(1), ...install], { env: { DEBIAN_FRONTEND: "noninteractive" } })) === 0;
}

function rootCommand() {
  if (which("apt-get") === null) return null;
  if (process.getuid?.() === 0) return ["apt-get"];
  if (which("sudo") !== null && read("sudo", ["-n", "true"]) !== null) return ["sudo", "-n", "apt-get"];
  return null;
}
