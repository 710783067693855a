// The scenarios in WebKit.
import { launch } from "./drivers/webkit.js";
import { inBrowser } from "./run.js";

inBrowser("WebKit", launch);
