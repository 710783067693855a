// The problem that the page begins with.
import document from "../../problems/eight-by-eight.json?raw";

export const exampleDocument: string = document;
