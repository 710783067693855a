// Offering a text, or what was made of one, as a file.

export function download(content: string | Blob, type: string, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  // The browser may read it after the click has been handled.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
