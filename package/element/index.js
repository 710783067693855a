// Defines <mo-copp-playground> where there is a document.
export { inside, MoCoppPlayground } from "./mo-copp-playground.js";
