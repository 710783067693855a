/** Defines <mo-copp-playground>; all that it needs is in the script. */
import "../element/index.js";
