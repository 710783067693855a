// The core as the build puts it into the one script.
declare module "virtual:core" {
  const base64: string;
  export default base64;
}
