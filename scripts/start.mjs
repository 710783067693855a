// `npm start`: sets up what is missing, builds, serves the page and prints its address.
// PORT and HOST may be set; a port in use moves on to the next, unless PORT asked for it.
import { buildPage } from "./lib/build-page.mjs";
import { buildWasm } from "./lib/build-wasm.mjs";
import { dist } from "./lib/paths.mjs";
import { serve } from "./lib/static-server.mjs";
import { setUp } from "./setup/all.mjs";

await setUp("page");
if ((await buildWasm()) !== 0 || (await buildPage()) !== 0) {
  console.error("\nThe build failed; the messages above say why.");
  process.exit(1);
}

const asked = process.env.PORT;
const { server, address } = await serve(dist, {
  port: Number(asked ?? 4173),
  host: process.env.HOST ?? "127.0.0.1",
  anyPort: asked === undefined,
}).catch((error) => {
  console.error(`\nThe page can't be served: ${error.message}`);
  process.exit(1);
});
console.log(`\nThe playground is at ${address}\nStop it with Ctrl+C.`);
for (const signal of ["SIGINT", "SIGTERM"]) {
  process.on(signal, () => {
    server.close();
    server.closeAllConnections();
  });
}
