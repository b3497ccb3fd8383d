/** What stands around bytes in logs and is none of them: where it ends, and whether it says when. */
export interface Furniture {
  readonly kind: 'time' | 'noise';
  readonly end: number;
}

const DATE = String.raw`(?:\d{4}[-/.]\d{1,2}[-/.]\d{1,2}|\d{1,2}[-/.]\d{1,2}[-/.]\d{4})`;
const TIME = String.raw`\d{1,2}:[0-5]\d:[0-5]\d(?:[.,]\d{1,9}|:\d{3})?(?: ?[AP]M\b)?(?:Z|[-+]\d\d:?\d\d)?(?![:\w])`;

interface Piece {
  readonly kind: Furniture['kind'];
  /** The characters it may begin with. */
  readonly first: RegExp;
  readonly form: RegExp;
}

const digits = /[0-9]/;
const piece = (kind: Piece['kind'], first: RegExp, form: string | RegExp): Piece => ({
  kind,
  first,
  form: new RegExp(form, 'iy'),
});

/** All of them bounded, so that trying them at every place of a text takes time linear in its length. */
const PIECES: readonly Piece[] = [
  piece('time', digits, `${DATE}[T ,]{0,3}${TIME}`),
  piece('time', digits, TIME),
  piece('time', digits, `${DATE}(?![-/.:\\w])`),
  // Seconds, as of a capture: `(1436509052.249713)`, `0.012345`.
  piece('time', digits, /\d{1,12}\.\d{3,9}(?![.\w])/),
  // A count: `8 bytes`, `9600 baud`.
  piece('noise', digits, /\d{1,7} ?(?:more )?(?:bytes?|octets?|chars?|ms|µs|us|bauds?|bps|reg(?:ister)?s?)\b/),
  // The counter of Modbus Poll: `Rx:000010-01 03`, `000010-Tx:01 03`.
  piece('noise', digits, /\d{5,8}-(?=[0-9a-f]{2}\b|:|[tr]x:)/),
  // An internet address, which unlike dotted bytes is not all pairs.
  piece('noise', digits, /(?!\d\d(?:\.\d\d){3})\d{1,3}(?:\.\d{1,3}){3}(?::\d{1,5})?(?![.\w])/),
  // The level and the source of a line: `[D][uart_debug:114]`, `main.c:42`.
  piece('noise', /\[/, /\[[A-Z]{1,2}\](?=\[[^\][]{0,60}[g-z_])/),
  piece('noise', /\[/, /\[[^\][\s]{0,40}[g-z_][^\][\s]{0,40}:\d{1,5}\]:?/),
  // How many bytes follow, as candump says: `[8]  01 03`.
  piece('noise', /\[/, /\[\d{1,3}\](?=\s{1,4}[0-9a-f]{2}(?:\s|$))/),
  piece('noise', /[a-z_]/i, /[a-z_]\w{0,40}\.[a-z]{1,4}:\d{1,6}(?=[:\s)\]])/),
  // Where a packet lies, and its length: `@3FFB890C/7:`.
  piece('noise', /@/, /@[0-9a-f]{4,16}(?:\/\d{1,6})?:?/),
];

/** What stands at a place of a line, if it is no byte. */
export function furnitureAt(line: string, at: number): Furniture | undefined {
  const first = line[at] as string;
  for (const { kind, first: starts, form } of PIECES) {
    if (!starts.test(first)) continue;
    form.lastIndex = at;
    if (form.test(line) && (kind !== 'time' || !standsAlone(line, at, form.lastIndex))) {
      return { kind, end: form.lastIndex };
    }
  }
  return undefined;
}

/** Whether a line holds nothing else, so that `10:31:12` is three bytes in it rather than when others came. */
const standsAlone = (line: string, from: number, to: number) =>
  to - from <= 8 && line.length < 80 && line.trim().length === to - from;
