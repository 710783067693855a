// The styles of the pictures that not every problem needs: the stand-alone page fetches them with the pictures' code. In
// a shadow root all styles are there from the beginning.

type Load = () => Promise<unknown>;

let load: Load = async () => undefined;

export const loadViewStyles: Load = () => load();

export function bringViewStyles(from: Load): void {
  load = from;
}
