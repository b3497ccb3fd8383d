/** Puts a text on the clipboard, or what may still be in the making: a picture, or a text of the type `text/plain`. Answers whether the browser let it. */
export async function putOnClipboard(content: string | Promise<Blob>, type = 'image/png'): Promise<boolean> {
  try {
    if (typeof content === 'string') await navigator.clipboard.writeText(content);
    // Some browsers copy such a thing only if it is promised before anything is waited for.
    else await navigator.clipboard.write([new ClipboardItem({ [type]: content })]);
    return true;
  } catch {
    return false;
  }
}
