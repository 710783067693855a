// Dialogs: a click beside one closes it, and so does a page that hides what it stands in: an unseen dialog would leave the
// whole page inert.

export function openModal(dialog: HTMLDialogElement): void {
  dialog.showModal();
  // Each way of being hidden ends the intersection with the window; the size tells nothing of some.
  const drawn = new IntersectionObserver(() => {
    if (dialog.open && !dialog.checkVisibility()) dialog.close();
    if (!dialog.open) drawn.disconnect();
  });
  drawn.observe(dialog);
}

export function closeAround(event: MouseEvent): void {
  const dialog = event.currentTarget as HTMLDialogElement;
  if (event.target !== dialog) return;
  const { left, right, top, bottom } = dialog.getBoundingClientRect();
  const inside = event.clientX >= left && event.clientX <= right && event.clientY >= top && event.clientY <= bottom;
  if (!inside) dialog.close();
}
