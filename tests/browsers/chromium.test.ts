// The scenarios in Chromium.
import { launch } from "./drivers/chromium.js";
import { inBrowser } from "./run.js";

inBrowser("Chromium", launch);
