/** A file's name with the present time, such as `log-2026-11-30T101500.csv`. */
export const timedName = (stem: string, ending: string): string =>
  `${stem}-${new Date().toISOString().slice(0, 19).replaceAll(':', '')}.${ending}`;

/** Hands a text or bytes to the person as a file. */
export function download(
  content: string | Blob | Uint8Array<ArrayBuffer>,
  name: string,
  type = 'application/json',
): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  link.download = name;
  link.click();
  // The browser reads the address after the click; a minute is time enough.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
