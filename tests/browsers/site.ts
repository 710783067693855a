// The built page on a server of this process, which remembers what was asked for.
import { dist } from "../../scripts/lib/paths.mjs";
import { serve } from "../../scripts/lib/static-server.mjs";

export interface Site {
  address: string;
  /** Whether a file was asked for whose name begins so. */
  fetched(name: string): boolean;
  close(): void;
}

export async function site(): Promise<Site> {
  const { server, address } = await serve(dist, { base: "/course/week-3/" });
  const asked: string[] = [];
  server.on("request", ({ url }) => asked.push(url?.split("/").at(-1) ?? ""));
  return {
    address,
    fetched: (name) => asked.some((file) => file.startsWith(`${name}-`)),
    close: () => {
      server.close();
      server.closeAllConnections();
    },
  };
}
