// Numbers as the page writes them.

const short = new Intl.NumberFormat("en", { maximumFractionDigits: 3 });
const whole = new Intl.NumberFormat("en", { maximumFractionDigits: 0 });

/** At most three decimals, with a true minus sign and no minus zero. */
export const shortNumber = (value: number): string => short.format(value + 0).replace("-", "−");

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
