// Numbers as the page writes them.

const short = new Intl.NumberFormat("en", { maximumFractionDigits: 3 });
const whole = new Intl.NumberFormat("en", { maximumFractionDigits: 0 });

/** More candidate goals than this make fractions that are hard to read. */
const LARGEST_BELOW = 999;

/**
 * A goal difference, or a bound of one, as the core writes it and the article has it: a fraction in its lowest terms where it
 * is one, else at most three decimals; with a true minus sign and no minus zero.
 */
export function differenceText(value: number): string {
  for (let below = 1; below <= LARGEST_BELOW; below += 1) {
    const above = Math.round(value * below);
    if (Math.abs(above / below - value) >= 1e-9) continue;
    const text = below === 1 ? String(Math.abs(above)) : `${Math.abs(above)}/${below}`;
    return above < 0 ? `−${text}` : text;
  }
  return short.format(value + 0).replace("-", "−");
}

export const wholeNumber = (value: number): string => whole.format(value);

/** "1 move", "2 moves". */
export const counted = (count: number, thing: string): string =>
  `${wholeNumber(count)} ${thing}${count === 1 ? "" : "s"}`;

/** A time as people say it: short ones finely, long ones roughly. */
export function duration(seconds: number): string {
  if (seconds < 0.001) return "under 1 ms";
  if (seconds < 1) return `${whole.format(seconds * 1000)} ms`;
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  return `${whole.format(Math.floor(seconds / 60))} min ${whole.format(Math.floor(seconds % 60))} s`;
}
