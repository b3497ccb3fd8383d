/** Part of every browser and of Node, and without side effects; the types of the pure layers do not name it. */
declare const TextDecoder: new (label?: string) => { decode(bytes: Uint8Array): string };

/** How the text of a file is written. Latin-1 is read as Windows-1252, which is the same but for 0x80 to 0x9F. */
export type TextEncoding = 'utf-8' | 'utf-16le' | 'utf-16be' | 'windows-1252' | 'windows-1250' | 'gb18030';

export interface FileText {
  readonly text: string;
  readonly encoding: TextEncoding;
  /** How many places of the bytes are not UTF-8, if that is what decided against it. */
  readonly odd: number;
}

/** Bytes that are looked at to tell a text from other bytes. */
const SAMPLE = 65_536;
/** The most control characters among them, one of so many. */
const FEW = 200;
const TEXT_CONTROLS: ReadonlySet<number> = new Set([0x09, 0x0a, 0x0c, 0x0d, 0x1b, 0x02, 0x03]);
const SPACE = 0x20;
/** Characters from which on zeros at every second byte are no chance. */
const LEAST_PAIRS = 8;
const HIGH = 0x80;
/** The first byte of a Chinese character in two bytes (GB 2312), and the least of its second. */
const CHINESE = 0xa1;

/** The text in these bytes (UTF-8, UTF-16 by its mark, else Latin-1); `undefined` if they are not a text. */
export function fileText(bytes: Uint8Array): string | undefined {
  const read = readFileText(bytes);
  // Many bytes that are no UTF-8 are either Latin-1 with a few such letters, or no text.
  return read && read.odd * FEW <= bytes.length ? read.text : undefined;
}

/**
 * The text in these bytes and how it is written, by its mark or by evidence: every second byte of UTF-16 is zero, what is not
 * UTF-8 is Chinese if its high bytes come in pairs, Polish if its letters say so, else Windows-1252. `undefined` if they are not a text.
 */
export function readFileText(bytes: Uint8Array): FileText | undefined {
  const wide = wideEncoding(bytes);
  if (wide) return { text: new TextDecoder(wide).decode(bytes), encoding: wide, odd: 0 };
  const sample = bytes.subarray(0, SAMPLE);
  let controls = 0;
  for (const byte of sample) if (byte < SPACE && !TEXT_CONTROLS.has(byte)) controls++;
  if (controls * FEW > sample.length) return undefined;
  const text = new TextDecoder().decode(bytes);
  const odd = oddPlaces(text, bytes);
  if (odd === 0 || odd <= lettersBeyondAscii(text)) return { text, encoding: 'utf-8', odd: 0 };
  if (highBytesInPairs(bytes)) return { text: new TextDecoder('gb18030').decode(bytes), encoding: 'gb18030', odd };
  const western = withoutControls(new TextDecoder('windows-1252').decode(bytes));
  if (!POLISH.test(western)) return { text: western, encoding: 'windows-1252', odd };
  return { text: new TextDecoder('windows-1250').decode(bytes), encoding: 'windows-1250', odd };
}

/** `ł`, `ą` and `ż` inside a word, as they look in Windows-1252; no Western word has such signs. */
const POLISH = /[a-z][³¹¿][a-z]/i;

/** Windows-1252 from 0x80 to 0x9F; five places are not used. Some versions of Node leave them as they are. */
const WINDOWS = '€\u0081‚ƒ„…†‡ˆ‰Š‹Œ\u008dŽ\u008f\u0090‘’“”•–—˜™š›œ\u009džŸ';
const withoutControls = (text: string): string =>
  text.replace(/[\u0080-\u009f]/g, (letter) => WINDOWS[letter.charCodeAt(0) - HIGH] ?? letter);

/** How many characters of the text replace what is not UTF-8. The replacement may also stand in the bytes as they are. */
function oddPlaces(text: string, bytes: Uint8Array): number {
  const replaced = text.split('\ufffd').length - 1;
  if (replaced === 0) return 0;
  let own = 0;
  for (let at = bytes.indexOf(0xef); at >= 0; at = bytes.indexOf(0xef, at + 1)) {
    if (bytes[at + 1] === 0xbf && bytes[at + 2] === 0xbd) own++;
  }
  return replaced - own;
}

function lettersBeyondAscii(text: string): number {
  let count = 0;
  for (let index = 0; index < text.length; index++)
    if (text.charCodeAt(index) >= HIGH && text[index] !== '\ufffd') count++;
  return count;
}

function wideEncoding(bytes: Uint8Array): 'utf-16le' | 'utf-16be' | undefined {
  if (bytes[0] === 0xff && bytes[1] === 0xfe) return 'utf-16le';
  if (bytes[0] === 0xfe && bytes[1] === 0xff) return 'utf-16be';
  const zeros: [number, number] = [0, 0];
  const pairs = Math.min(bytes.length, SAMPLE) >> 1;
  for (let index = 0; index < pairs * 2; index++) if (bytes[index] === 0) zeros[index & 1 ? 1 : 0]++;
  // A text of a map is mostly ASCII, so that most high bytes are zero; its low bytes never are.
  if (pairs < LEAST_PAIRS || bytes.length % 2 !== 0) return undefined;
  if (zeros[0] === 0 && zeros[1] * 2 > pairs) return 'utf-16le';
  return zeros[1] === 0 && zeros[0] * 2 > pairs ? 'utf-16be' : undefined;
}

/** Whether nine of ten runs of bytes beyond ASCII are pairs as in GB 2312; in Western texts such bytes stand alone. */
function highBytesInPairs(bytes: Uint8Array): boolean {
  let runs = 0;
  let paired = 0;
  for (let index = 0; index < bytes.length; index++) {
    const from = index;
    while ((bytes[index] ?? 0) >= CHINESE) index++;
    if (index > from) {
      runs++;
      if ((index - from) % 2 === 0) paired++;
    } else if ((bytes[index] ?? 0) >= HIGH) runs++;
  }
  return runs > 0 && paired * 10 >= runs * 9;
}
