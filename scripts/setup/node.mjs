// The Node this script runs on; everything before `npm ci` uses its standard library alone.
import { SetupError, say } from "./report.mjs";

const oldest = [20, 19];

export async function ensureNode() {
  const [major, minor] = process.versions.node.split(".").map(Number);
  if (major < oldest[0] || (major === oldest[0] && minor < oldest[1])) {
    throw new SetupError(
      `Node ${process.versions.node} is too old; ${oldest.join(".")} or later is needed.`,
      "Install Node 20 LTS or later.",
    );
  }
  say("Node", process.versions.node);
}
