/** What stands around bytes in logs and is not one of them: when, where on a network, or anything else; and where it ends. */
export interface Furniture {
  readonly kind: 'time' | 'address' | 'noise';
  readonly end: number;
}

const DATE = String.raw`(?:(?:19|20)\d\d[-/.]\d{1,2}[-/.]\d{1,2}|\d{1,2}[-/.]\d{1,2}[-/.](?:19|20)\d\d)`;
const MONTH = '(?:jan|feb|mar|apr|may|jun|jul|aug|sep|oct|nov|dec)[a-z]{0,6}';
/** Node-RED writes `node:` right behind it. */
const END = String.raw`(?:(?!:?\w|[.,]\d)|(?=node: ))`;
const CLOCK = String.raw`(?:[01]?\d|2[0-3]):[0-5]\d:[0-5]\d(?:[.,]\d{1,9}(?:,\d{3})?|:\d{3})?(?: ?[AP]M\b)?(?: ?Z| ?[-+]\d\d:?\d\d)?${END}`;
/** Behind a date its parts may be joined by other marks, or by none. */
const JOINED_CLOCK = String.raw`(?:[01]\d|2[0-3])(?:-[0-5]\d-|\.[0-5]\d\.|[0-5]\d)[0-5]\d(?:[.,]\d{1,9})?Z?${END}`;
const MAC = String.raw`[0-9a-f]{2}(?:(?::[0-9a-f]{2}){5}|(?:-[0-9a-f]{2}){5})(?![-:\w])`;
const UUID = String.raw`[0-9a-f]{8}(?:-[0-9a-f]{4}){3}-[0-9a-f]{12}\b`;

const oneOf = (...forms: readonly string[]): RegExp => new RegExp(forms.join('|'), 'iy');

// All forms are bounded, so that trying them at every place of a text takes time linear in its length.

const TIME = oneOf(
  `(?:${DATE}|\\d\\d[-/.]\\d\\d(?:[-/.]\\d\\d)?(?=[T ]))[T ,_]{0,3}${CLOCK}`,
  `(?:${DATE}[T _]|(?:19|20)\\d{6}[-T _])(?:${JOINED_CLOCK}|${CLOCK})`,
  // With the days since the start in front.
  `\\d{3}:${CLOCK}`,
  CLOCK,
  `${DATE}(?![-/.:\\w])`,
  String.raw`\d{1,2}[ /-]${MONTH}(?:[ /-]\d{4})?[ :]${CLOCK}`,
  // Milliseconds, microseconds or nanoseconds since 1970, before something else.
  String.raw`(?<=^[^\w]{0,4}|time\w{0,6}["']?[:=] ?["']?)1[5-9]\d{11}(?:\d{3}){0,2}(?=["'\])}|,;: \t]{1,4}\S)`,
  // Since the start, as ESP-IDF and Arduino say it before or behind the level: `I (4712) modbus`, `[  4712][D]`, `4712 ms`.
  String.raw`(?<=^[^\w]{0,8}[EWIDV] \( {0,9})\d{1,10}(?=\) \S)`,
  String.raw`(?<=^\[ {0,9})\d{1,10}(?=\]\[[EWIDV]\])`,
  String.raw`(?<=^[\s[(]{0,4})\d{1,10}(?:\.\d{1,6})? ?(?:ms|s)\b(?=[\])|,;: \t]{1,4}\S)`,
  // Minutes and seconds.
  String.raw`[0-5]?\d:[0-5]\d\.\d{3,6}(?![.:\w])`,
  // Seconds, as of a capture: `(1436509052.249713)`, `0.012345`.
  String.raw`\d{1,12}\.\d{3,18}(?![.\w])`,
);

/** The address of a network card: in parentheses as Wireshark prints it, or behind its name. */
const CARD = {
  digit: oneOf(String.raw`(?<=\()${MAC}(?=\))`),
  letter: oneOf(
    String.raw`(?<=\()${MAC}(?=\))`,
    `(?:mac|hwaddr|ether|lladdr|bssid|src|dst|physical address)(?: address)?[ .:=]{1,30}${MAC}`,
  ),
} as const;

/** What is not a byte, by what it begins with. */
const NOISE = {
  digit: oneOf(
    UUID,
    // The samples of a logic analyser: `1042-1982 UART: `.
    String.raw`(?<=^)\d{1,15}-\d{1,15}(?= [a-z][^:]{0,40}: )`,
    // What is called at an address: `0x20001a40 <buf>:`.
    '0x[0-9a-f]{8,16} <[^<>]{1,60}>:',
    // A count: `8 bytes`, `9600 baud`.
    String.raw`\d{1,7} ?(?:more )?(?:bytes?|octets?|chars?|ms|µs|us|bauds?|bps|reg(?:ister)?s?)\b`,
    // A measured value: `45.2 ms`.
    String.raw`\d{1,9}\.\d{1,9} ?(?:[mµu]?s|seconds?|%|[km]?[vaw]|hz|°c)\b`,
    // The counter of Modbus Poll: `Rx:000010-01 03`, `000010-Tx:01 03`.
    String.raw`\d{5,8}-(?=[0-9a-f]{2}\b|:|[tr]x:)`,
    // An internet address with its port, which unlike dotted bytes is not all pairs.
    String.raw`(?!\d\d(?:\.\d\d){3})\d{1,3}(?:\.\d{1,3}){3}(?:[:.]\d{1,5})?(?![.\w])`,
  ),
  letter: oneOf(
    UUID,
    // What a web server answered: `HTTP/1.1" 200 1103`.
    String.raw`http/\d(?:\.\d)?"? \d{3}(?: \d{1,9})?\b`,
    // A date whose time stands before its year, or that has none, before the time.
    `${MONTH} {1,2}\\d{1,2}(?:,? (?:19|20)\\d\\d)?(?=,? {1,2}${CLOCK})`,
    // Where a line of a log comes from: `main.c:42`, `transaction   :140 `, `logging:103 send`.
    String.raw`[a-z_]\w{0,40}\.[a-z]{1,4}:\d{1,6}(?=[:\s)\]])`,
    String.raw`[a-z_]{4,40} {1,20}:(?:\d|[1-9]\d{2,4})(?=\s{2})`,
    String.raw`[a-z_]{4,40}:[1-9]\d{2,4}(?=\s{1,4}[g-z])`,
    // The maker's name in such an address: `Beckhoff_32:37:1f`.
    String.raw`[a-z][a-z0-9]{1,20}_[0-9a-f]{2}:[0-9a-f]{2}:[0-9a-f]{2}(?![:\w])`,
  ),
  '[': oneOf(
    // The same as ESPHome has it, after the level: `[D][uart_debug:114]`.
    String.raw`\[[A-Z]{1,2}\](?=\[[^\][]{0,60}[g-z_])`,
    String.raw`\[[^\][\s]{0,40}[g-z_][^\][\s]{0,40}:\d{1,5}\]:?`,
    // The level alone, before words: `[D] Sent:`.
    String.raw`\[[a-f]\](?=\s{1,3}[^\][]{0,40}[g-z_])`,
    // A place in a source: `[ 311] handleConnection`.
    String.raw`\[(?:\s{1,4}\d{1,5}|\d{3,5})\](?= [a-z_]{4})`,
    // How many bytes follow, as candump says: `[8]  01 03`.
    String.raw`\[\d{1,3}\](?=\s{1,4}[0-9a-f]{2}(?:\s|$))`,
  ),
  '(': oneOf(String.raw`\([a-f]\)(?=\s{1,3}[a-z]{0,40}[g-z_])`),
  // Where a packet lies, and its length: `@3FFB890C/7:`.
  '@': oneOf(String.raw`@(?:0x)?[0-9a-f]{4,16}(?:\/\d{1,6})?:?`),
} as const;

/** What stands at a place of a line, if it is not a byte; `first` is what it begins with. */
export function furnitureAt(line: string, at: number, first: keyof typeof NOISE): Furniture | undefined {
  if (first === 'digit') {
    TIME.lastIndex = at;
    if (TIME.test(line)) return { kind: 'time', end: TIME.lastIndex };
  }
  if (first === 'digit' || first === 'letter') {
    const card = CARD[first];
    card.lastIndex = at;
    if (card.test(line)) return { kind: 'address', end: card.lastIndex };
  }
  const noise = NOISE[first];
  noise.lastIndex = at;
  return noise.test(line) ? { kind: 'noise', end: noise.lastIndex } : undefined;
}
