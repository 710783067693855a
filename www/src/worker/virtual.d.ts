// The core as the build puts it into the one script.
declare module "virtual:core" {
  const base64: string;
  export default base64;
}

/** The npm package lzma1; its own types are sources that this project's compiler would check. */
declare module "virtual:lzma" {
  export function decompress(packed: Uint8Array): Uint8Array;
}
