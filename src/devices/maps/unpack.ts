import { Gunzip, Inflate } from 'fflate';

/** Packed bytes that are unpacked at once: a thousand times as many at most come out. */
const PIECE = 16_384;

/** Thrown where more comes out than a file may hold. */
export class TooLarge extends RangeError {}

/** Unpacks piece by piece; `left` bytes may come out. */
function unpacked(stream: Inflate | Gunzip, packed: Uint8Array, left: number): Uint8Array {
  const parts: Uint8Array[] = [];
  let size = 0;
  stream.ondata = (part) => {
    size += part.length;
    if (size > left) throw new TooLarge();
    parts.push(part);
  };
  for (let at = 0; at < packed.length; at += PIECE)
    stream.push(packed.subarray(at, at + PIECE), at + PIECE >= packed.length);
  const whole = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

/** `most` bytes may come out. @throws TooLarge, or an error of the format. */
export const gunzip = (bytes: Uint8Array, most: number): Uint8Array => unpacked(new Gunzip(), bytes, most);

/**
 * The files of a ZIP archive whose names are wanted, by its directory (APPNOTE 4.3.12); `most` bytes may come out of all together.
 *
 * @throws TooLarge, or an error of the format.
 */
export function unzip(
  bytes: Uint8Array,
  isWanted: (name: string) => boolean,
  most: number,
): ReadonlyMap<string, Uint8Array> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const files = new Map<string, Uint8Array>();
  let end = bytes.length - 22;
  while (end >= 0 && view.getUint32(end, true) !== 0x06054b50) end--;
  if (end < 0) throw new RangeError('no directory');
  const count = view.getUint16(end + 10, true);
  let at = view.getUint32(end + 16, true);
  let left = most;
  for (let index = 0; index < count; index++) {
    if (view.getUint32(at, true) !== 0x02014b50) throw new RangeError('directory damaged');
    const method = view.getUint16(at + 10, true);
    const size = view.getUint32(at + 20, true);
    const nameEnd = at + 46 + view.getUint16(at + 28, true);
    const name = String.fromCharCode(...bytes.subarray(at + 46, nameEnd));
    const local = view.getUint32(at + 42, true);
    at = nameEnd + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
    if (!isWanted(name)) continue;
    const start = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
    const packed = bytes.subarray(start, start + size);
    if (method !== 0 && method !== 8) throw new RangeError(`method ${method}`);
    const file = method === 0 ? packed : unpacked(new Inflate(), packed, left);
    left -= file.length;
    if (left < 0) throw new TooLarge();
    files.set(name, file);
  }
  return files;
}
