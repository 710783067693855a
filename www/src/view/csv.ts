// Tables as comma-separated values (RFC 4180), for a spreadsheet.

/** A cell: null is empty. */
export type Cell = string | number | null;

export const csvText = (rows: readonly (readonly Cell[])[]): string =>
  rows.map((row) => `${row.map(written).join(",")}\r\n`).join("");

function written(cell: Cell): string {
  if (typeof cell !== "string") return cell === null ? "" : String(cell);
  // Names are the document's: a spreadsheet must not take one for a formula.
  const harmless = /^[=+\-@\t\r]/.test(cell) ? `'${cell}` : cell;
  return /[",\r\n]/.test(harmless) ? `"${harmless.replaceAll('"', '""')}"` : harmless;
}
