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
