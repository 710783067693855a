// Puts the exercises beside the playground, whose address opens them: `index.html?src=exercises/NAME.json`.
import { exerciseFiles } from "./files.mjs";

/** A plugin of Vite. */
export const exercises = () => ({
  name: "exercises",
  generateBundle() {
    for (const [name, source] of exerciseFiles())
      this.emitFile({ type: "asset", fileName: `exercises/${name}`, source });
  },
  configureServer(server) {
    server.middlewares.use((request, response, next) => {
      const wanted = /\/exercises\/([\w-]+\.json)$/.exec(request.url ?? "")?.[1];
      const [, source] = exerciseFiles().find(([name]) => name === wanted) ?? [];
      if (source === undefined) return next();
      response.setHeader("Content-Type", "application/json");
      response.end(source);
    });
  },
});
