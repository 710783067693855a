// GNU parallel, with which a Rust test runs the shards of an experiment. Nothing else needs it, so the tests go on
// without it where it can't be installed, and that one says that it was skipped.
import { read } from "../lib/run.mjs";
import { aptInstall } from "./debian.mjs";
import { say } from "./report.mjs";

export async function ensureParallel() {
  if (version() !== null) return say("GNU parallel", version());
  say("GNU parallel", "installing the Debian package");
  await aptInstall("parallel");
  if (version() === null) {
    say("GNU parallel", "could not be installed: its test is skipped (apt-get install parallel   as root)");
  }
}

// Another program of that name, of moreutils, is not it.
const version = () => /^GNU parallel (\S+)/.exec(read("parallel", ["--version"]) ?? "")?.[1] ?? null;
