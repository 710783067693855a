// Goal differences as they are typed: decimals and fractions. With n goals each is m/(n − 1) for some whole m, and what is
// typed with three decimals means the nearest of these.

/** What three decimals leave open. */
const ROUNDED = 0.0005;

/** The number that a text means, among `goals` goals; null where it is none. */
export function differenceIn(text: string, goals: number): number | null {
  // A decimal comma is one, and a minus sign.
  const typed = text
    .trim()
    .replace("−", "-")
    .replace(/^(-?\d+),(\d+)$/, "$1.$2");
  const [, above, below] = /^(-?\d{1,6})\s*[/⁄]\s*(\d{1,6})$/.exec(typed) ?? [];
  const value = above === undefined ? Number(typed) : Number(above) / Number(below);
  if (typed === "" || !Number.isFinite(value)) return null;
  return nearest(value, goals) ?? value;
}

/** The goal difference that a number is within rounding; null where it is none. */
function nearest(value: number, goals: number): number | null {
  const whole = goals - 1;
  if (whole < 1) return null;
  const exact = Math.round(value * whole) / whole;
  // No minus zero.
  return Math.abs(exact - value) <= ROUNDED ? exact + 0 : null;
}
