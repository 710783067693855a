// Offering a text as a file.

export function download(text: string, type: string, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  // The browser may read it after the click has been handled.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
