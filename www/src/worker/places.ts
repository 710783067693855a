// Where the worker and the core are, for a page that places these files itself: by the attributes `worker-url` and
// `wasm-url` of a playground. The workers serve the whole page, so the first playground that names them decides.

export interface Places {
  worker: string | null;
  /** The full core. */
  wasm: string | null;
}

let chosen: Places = { worker: null, wasm: null };

export const chosenPlaces = (): Places => chosen;

export function choosePlaces({ worker, wasm }: Places): void {
  chosen = { worker: chosen.worker ?? worker, wasm: chosen.wasm ?? wasm };
}
