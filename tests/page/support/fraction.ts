// A goal difference as the page writes it: in lowest terms, with a true minus.
export function fraction(above: number, below: number): string {
  const common = (one: number, other: number): number => (other === 0 ? one : common(other, one % other));
  const shared = common(Math.abs(above), below);
  const text = below === shared ? String(Math.abs(above) / shared) : `${Math.abs(above) / shared}/${below / shared}`;
  return above < 0 ? `−${text}` : text;
}

/** Of a value that is a number of goals by the number of goals less one. */
export const difference = (value: number | null, goals: number): string =>
  fraction(Math.round((value ?? 0) * (goals - 1)), goals - 1);
