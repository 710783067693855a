// Comparing version numbers such as 1.88 and 1.95.0.

const parts = (version) => version.split(/[.+-]/).map((part) => Number.parseInt(part, 10) || 0);

export function atLeast(version, oldest) {
  const [have, want] = [parts(version), parts(oldest)];
  for (let place = 0; place < want.length; place += 1) {
    const difference = (have[place] ?? 0) - want[place];
    if (difference !== 0) return difference > 0;
  }
  return true;
}

/** The first version number in a line such as "wasm-pack 0.15.1", or null. */
export const versionIn = (text) => /\d+\.\d+\.\d+/.exec(text ?? "")?.[0] ?? null;
