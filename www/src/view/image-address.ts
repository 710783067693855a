// An SVG picture as an image: it needs no styles of the page, and none of its own reach the page.

/** An address that content policies allow by `img-src data:`. */
export const imageAddress = (svg: string): string => `data:image/svg+xml,${encodeURIComponent(svg)}`;
