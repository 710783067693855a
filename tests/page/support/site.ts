// The built page, served under a sub-path as a course site would.
import { after } from "node:test";
import { dist } from "../../../scripts/lib/paths.mjs";
import { serve } from "../../../scripts/lib/static-server.mjs";

const { server, address } = await serve(dist, { base: "/course/week-3/" });
after(() => {
  server.close();
  server.closeAllConnections();
});

export { address };
