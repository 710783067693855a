// The element as one script that needs no other file: for pages opened from disk, and for hosts that take one file.
import "./embed.js";
