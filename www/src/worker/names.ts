// The name of the workers, as the browser's tools show it.
export const NAME = "mo-copp solver";
