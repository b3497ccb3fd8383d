/** Puts a text on the clipboard, or a picture that may still be in the making. Answers whether the browser let it. */
export async function putOnClipboard(content: string | Promise<Blob>): Promise<boolean> {
  try {
    if (typeof content === 'string') await navigator.clipboard.writeText(content);
    // Some browsers copy a picture only if it is promised before anything is waited for.
    else await navigator.clipboard.write([new ClipboardItem({ 'image/png': content })]);
    return true;
  } catch {
    return false;
  }
}
