// `npm run setup`: finds or installs everything that building and testing need, and does no more.
import { needs, setUp } from "./setup/all.mjs";

await setUp(...Object.keys(needs));
