// How large a document may be: the page and the core take the same.

/** The core's limit in the browser, in bytes (`limits::MAX_TEXT_BYTES`); a test holds them equal. */
export const LARGEST_DOCUMENT = 8 * 1024 * 1024;

/** The same in words. */
export const LARGEST_IN_WORDS = "8 MiB";
