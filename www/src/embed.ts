// What other pages load to use the element: one address that stays the same, while the files behind it change their
// names with what is in them. It is small: what draws the playground is loaded when an element nears what is seen.
import { define } from "./element/define.js";
import { MoCoppPlayground } from "./element/mo-copp-playground.js";

define(MoCoppPlayground);

export { inside } from "./element/inside.js";
export { MoCoppPlayground };
