/** What stands around bytes in logs and is none of them: where it ends, and whether it says when. */
export interface Furniture {
  readonly kind: 'time' | 'noise';
  readonly end: number;
}

const DATE = String.raw`(?:(?:19|20)\d\d[-/.]\d{1,2}[-/.]\d{1,2}|\d{1,2}[-/.]\d{1,2}[-/.](?:19|20)\d\d)`;
const CLOCK = String.raw`(?:[01]?\d|2[0-3]):[0-5]\d:[0-5]\d(?:[.,]\d{1,9}|:\d{3})?(?: ?[AP]M\b)?(?:Z|[-+]\d\d:?\d\d)?(?![:\w])`;

const oneOf = (...forms: readonly string[]): RegExp => new RegExp(forms.join('|'), 'iy');

// All forms are bounded, so that trying them at every place of a text takes time linear in its length.

const TIME = oneOf(
  `(?:${DATE}|\\d\\d[-/.]\\d\\d[-/.]\\d\\d(?=[T ]))[T ,]{0,3}${CLOCK}`,
  CLOCK,
  `${DATE}(?![-/.:\\w])`,
  // Minutes and seconds.
  String.raw`[0-5]?\d:[0-5]\d\.\d{3,6}(?![.:\w])`,
  // Seconds, as of a capture: `(1436509052.249713)`, `0.012345`.
  String.raw`\d{1,12}\.\d{3,9}(?![.\w])`,
);

/** What is no byte, by what it begins with. */
const NOISE = {
  digit: oneOf(
    // A count: `8 bytes`, `9600 baud`.
    String.raw`\d{1,7} ?(?:more )?(?:bytes?|octets?|chars?|ms|µs|us|bauds?|bps|reg(?:ister)?s?)\b`,
    // The counter of Modbus Poll: `Rx:000010-01 03`, `000010-Tx:01 03`.
    String.raw`\d{5,8}-(?=[0-9a-f]{2}\b|:|[tr]x:)`,
    // An internet address, which unlike dotted bytes is not all pairs.
    String.raw`(?!\d\d(?:\.\d\d){3})\d{1,3}(?:\.\d{1,3}){3}(?::\d{1,5})?(?![.\w])`,
  ),
  // Where a line of a log comes from: `main.c:42`.
  letter: oneOf(String.raw`[a-z_]\w{0,40}\.[a-z]{1,4}:\d{1,6}(?=[:\s)\]])`),
  '[': oneOf(
    // The same as ESPHome has it, after the level: `[D][uart_debug:114]`.
    String.raw`\[[A-Z]{1,2}\](?=\[[^\][]{0,60}[g-z_])`,
    String.raw`\[[^\][\s]{0,40}[g-z_][^\][\s]{0,40}:\d{1,5}\]:?`,
    // How many bytes follow, as candump says: `[8]  01 03`.
    String.raw`\[\d{1,3}\](?=\s{1,4}[0-9a-f]{2}(?:\s|$))`,
  ),
  // Where a packet lies, and its length: `@3FFB890C/7:`.
  '@': oneOf(String.raw`@[0-9a-f]{4,16}(?:\/\d{1,6})?:?`),
} as const;

/** What stands at a place of a line, if it is no byte; `first` is what it begins with. */
export function furnitureAt(line: string, at: number, first: keyof typeof NOISE): Furniture | undefined {
  if (first === 'digit') {
    TIME.lastIndex = at;
    if (TIME.test(line)) return { kind: 'time', end: TIME.lastIndex };
  }
  const noise = NOISE[first];
  noise.lastIndex = at;
  return noise.test(line) ? { kind: 'noise', end: noise.lastIndex } : undefined;
}
