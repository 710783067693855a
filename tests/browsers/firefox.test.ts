// The scenarios in Firefox.
import { launch } from "./drivers/firefox.js";
import { inBrowser } from "./run.js";

inBrowser("Firefox", launch);
