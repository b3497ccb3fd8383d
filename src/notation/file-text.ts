/** Part of every browser and of Node, and without side effects; the types of the pure layers do not name it. */
declare const TextDecoder: new (label?: string) => { decode(bytes: Uint8Array): string };

/** Bytes that are looked at to tell a text from other bytes. */
const SAMPLE = 65_536;
/** The most control characters among them, one of so many. */
const FEW = 200;
const TEXT_CONTROLS: ReadonlySet<number> = new Set([0x09, 0x0a, 0x0c, 0x0d, 0x1b, 0x02, 0x03]);
const SPACE = 0x20;

/** The text in these bytes (UTF-8, UTF-16 by its mark, else Latin-1); `undefined` if they are not a text. */
export function fileText(bytes: Uint8Array): string | undefined {
  if (bytes[0] === 0xff && bytes[1] === 0xfe) return new TextDecoder('utf-16le').decode(bytes);
  if (bytes[0] === 0xfe && bytes[1] === 0xff) return new TextDecoder('utf-16be').decode(bytes);
  const sample = bytes.subarray(0, SAMPLE);
  let controls = 0;
  for (const byte of sample) if (byte < SPACE && !TEXT_CONTROLS.has(byte)) controls++;
  if (controls * FEW > sample.length) return undefined;
  const text = new TextDecoder().decode(bytes);
  // Many bytes that are no UTF-8 are either Latin-1 with a few such letters, or no text.
  const odd = text.split('\ufffd').length - 1;
  if (odd === 0) return text;
  return odd * FEW > bytes.length ? undefined : new TextDecoder('windows-1252').decode(bytes);
}
