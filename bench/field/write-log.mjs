// Writes a conversation as a log of one of the dialects in `tests/vectors/dialects.json`.

/** What Windows shows for the bytes 80 to 9F; a dot where it has no character. */
const WINDOWS = '€.‚ƒ„…†‡ˆ‰Š‹Œ.Ž..‘’“”•–—˜™š›œ.žŸ';

const shown = {
  dots: (byte) => (byte >= 0x20 && byte < 0x7f ? String.fromCharCode(byte) : '.'),
  'windows-1252': (byte) => {
    if (byte < 0x20 || byte === 0x7f) return '.';
    return byte >= 0x80 && byte < 0xa0 ? WINDOWS[byte - 0x80] : String.fromCharCode(byte);
  },
};

const hex2 = (byte) => byte.toString(16).padStart(2, '0');

/** One byte as a string literal has it; `next` is the character behind it. */
const escaped = {
  python: (byte, quote) => {
    const named = { 9: '\\t', 10: '\\n', 13: '\\r', 92: '\\\\' }[byte];
    if (named !== undefined) return named;
    if (String.fromCharCode(byte) === quote) return `\\${quote}`;
    return byte >= 0x20 && byte < 0x7f ? String.fromCharCode(byte) : `\\x${hex2(byte)}`;
  },
  rust: (byte) => (byte === 0 ? '\\0' : byte === 34 ? '\\"' : escaped.python(byte)),
  'c-octal': (byte, next) => {
    const named = { 9: '\\t', 10: '\\n', 11: '\\v', 12: '\\f', 13: '\\r', 34: '\\"', 92: '\\\\' }[byte];
    if (named !== undefined) return named;
    if (byte >= 0x20 && byte < 0x7f) return String.fromCharCode(byte);
    const isDigitNext = next !== undefined && next >= 0x30 && next <= 0x39;
    return `\\${byte.toString(8).padStart(isDigitNext ? 3 : 1, '0')}`;
  },
};

function literal(bytes, form) {
  const list = [...bytes];
  if (form === 'rust') return `b"${list.map((byte) => escaped.rust(byte)).join('')}"`;
  if (form === 'c-octal') return list.map((byte, i) => escaped['c-octal'](byte, list[i + 1])).join('');
  const quote = list.includes(39) && !list.includes(34) ? '"' : "'";
  const inner = list.map((byte) => escaped.python(byte, quote)).join('');
  return `${form === 'python' ? 'b' : ''}${quote}${inner}${quote}`;
}

function number(byte, { base, digits, upper, before = '', after = '' }) {
  const value = base === -10 ? (byte << 24) >> 24 : byte;
  const written = value.toString(Math.abs(base)).padStart(digits, '0');
  return before + (upper ? written.toUpperCase() : written) + after;
}

function list(bytes, form) {
  const bits = (byte) => (form.binary ? `0b${byte.toString(2).padStart(8, '0')} (0x${number(byte, form)})` : undefined);
  const numbers = Array.from(bytes, (byte) => bits(byte) ?? number(byte, form));
  if (form.head !== undefined) {
    const [head, rest] = [numbers.slice(0, form.head), numbers.slice(form.head)];
    return `[${head.join(' ')}] ${rest.join(' ')}`;
  }
  return (form.open ?? '') + numbers.join(form.between) + (form.close ?? '');
}

/** The rows of a dump, and how far its offsets count. */
function rows(bytes, form, start) {
  const { width, row, gap, textGap, group = 1, offset, text, padText } = form;
  const lines = [];
  for (let at = 0; at < bytes.length; at += width) {
    const part = [...bytes.subarray(at, at + width)];
    const cells = (length) => {
      let line = '';
      for (let i = 0; i < length; i++) {
        if (i > 0 && i % group === 0) line += form.between;
        if (i > 0 && i === gap) line += ' ';
        line += i < part.length ? number(part[i], form) : '  ';
      }
      return line;
    };
    const column = part.map((byte, i) => (i === textGap ? ' ' : '') + (shown[text] ?? shown.dots)(byte)).join('');
    const line = row
      .replace('{offset}', () => (start + at).toString(offset?.base ?? 16).padStart(offset?.digits ?? 0, '0'))
      .replace('{bytes}', () => cells(row.includes('{text}') ? width : part.length))
      .replace('{text}', () => (padText ? column.padEnd(width) : column));
    lines.push(line);
  }
  return lines.join('\n');
}

const two = (value) => String(value).padStart(2, '0');

/** The headers of IP and TCP before so many bytes: with the length of the packet, and the ports the other way for a reply. */
function headers(front = '', size, side) {
  const bytes = Uint8Array.from(front.match(/../g) ?? [], (pair) => Number.parseInt(pair, 16));
  if (bytes.length === 0) return bytes;
  const length = bytes.length + size;
  bytes.set([length >> 8, length & 0xff], 2);
  if (side === 'rx') bytes.set([...bytes.subarray(22, 24), ...bytes.subarray(20, 22)], 20);
  return bytes;
}

/** Seconds of the day at which the log begins: 10:31. */
const START = 10 * 3600 + 31 * 60;

/**
 * The text of a conversation, and what should be read in it.
 * @param {object} dialect one of `tests/vectors/dialects.json`
 * @param {readonly { side: 'tx' | 'rx', bytes: Uint8Array }[]} entries
 * @returns {{ text: string, chunks: { side: string, bytes: Uint8Array, time: number }[] }} with times in microseconds
 */
export function writeLog(dialect, entries) {
  let seconds = START;
  let ms = 0;
  const counted = { tx: 0, rx: 0 };
  const now = () => ({
    time: [seconds / 3600, (seconds / 60) % 60, seconds % 60].map((part) => two(Math.floor(part))).join(':'),
    ms: String(ms).padStart(3, '0'),
    cs: two(Math.floor(ms / 10)),
    minutes: [(seconds / 60) % 60, seconds % 60].map((part) => two(Math.floor(part))).join(':'),
    boot: (seconds - START) * 1000 + ms,
    boot6: String((seconds - START) * 1000 + ms).padStart(6),
    epoch: Date.UTC(2024, 0, 2) + seconds * 1000 + ms,
    date: '2024-01-02',
    day: '02',
    month: '01',
    year: '2024',
  });
  const fill = (line, values) =>
    line.replace(/\{(\w+)\}/g, (whole, name) => (name in values ? String(values[name]) : whole));
  const lines = (dialect.head ?? []).map((line) => fill(line, now()));
  const chunks = [];
  for (const [index, { side, bytes }] of entries.entries()) {
    ms = (ms + 137 + 61 * (index % 7)) % 1000;
    if (side === 'tx') seconds++;
    const form = (side === 'rx' && dialect.rxBytes) || dialect.bytes;
    const front = headers(form.front, bytes.length, side);
    const all = Uint8Array.from([...front, ...bytes]);
    const start = form.offsets === 'count on' ? counted[side] : 0;
    counted[side] += all.length;
    const write = (some) => {
      if (form.escape !== undefined) return literal(some, form.escape);
      return form.row === undefined ? list(some, form) : rows(some, form, start);
    };
    const clock = now().time;
    const values = {
      ...now(),
      compact: clock.replaceAll(':', ''),
      dotted: clock.replaceAll(':', '.'),
      n: index,
      n5: 10000 + 37 * index,
      n6: String(index).padStart(6, '0'),
      length: bytes.length,
      unit: bytes[0],
      fc: bytes[1],
      bytes: write(all),
      pdu: write(all.subarray(1, Math.max(2, all.length - 2))),
      end: all.length.toString(16).padStart(8, '0'),
    };
    for (const line of dialect[side]) {
      const some = /\{each/.test(line) ? [...all] : [0];
      for (const each of some) {
        const eachText = shown.dots(each);
        const written = { ...values, each, eachx: hex2(each), eachX: each.toString(16).toUpperCase(), eachText };
        const filled = fill(line, written);
        const indent = ' '.repeat((side === 'rx' && dialect.rxIndent) || 0);
        lines.push(...filled.split('\n').map((one) => (one === '' ? one : indent + one)));
      }
    }
    if (dialect.gap !== undefined) lines.push('');
    chunks.push({ side: dialect.sides[side === 'tx' ? 0 : 1], bytes, time: (seconds * 1000 + ms) * 1000 });
  }
  lines.push(...(dialect.foot ?? []).map((line) => fill(line, now())));
  return { text: `${lines.join('\n')}\n`, chunks };
}
