import { expect, test } from 'vitest';
import { formatBytes, readBytes } from '../../../src/notation/index.ts';

/** The text that each byte was read from. */
const places = (text: string) => readBytes(text).origin.map(({ start, end }) => text.slice(start, end));

test.each([
  ['Rx:000010-01 03', ['01', '03']],
  ['0x01, 0X3', ['0x01', '0X3']],
  ['16#06 21H $05', ['16#06', '21H', '$05']],
  ['0103 000A', ['01', '03', '00', '0A']],
  ['[0x01] [0x90]', ['0x01', '0x90']],
  ['[1, 3, -59]', ['1', '3', '-59']],
  ['Byte 255 (0Xff)', ['255 (0Xff)']],
  ["'1' (0x01)", ["1' (0x01)"]],
  ["'A' (0x41)", ["'A' (0x41)"]],
  ['\\x04 \\x02n\\n', ['\\x04', ' ', '\\x02', 'n', '\\n']],
  ['\uff10\uff11\u00a003', ['\uff10\uff11', '03']],
  ['😀 TX: 01 03', ['01', '03']],
  [':0103FB<CR><LF>', [':', '0', '1', '0', '3', 'F', 'B', '<CR>', '<LF>']],
  [':0103FB\r\n', [':', '0', '1', '0', '3', 'F', 'B', '\r', '\n']],
  // A line feed alone stands for both.
  [':0103FB\n', [':', '0', '1', '0', '3', 'F', 'B', '\n', '\n']],
])('%j: where each byte stands', (text, expected) => {
  expect(places(text)).toEqual(expected);
});

test.each([
  // The CRC holds in one reading.
  ['TX: 1, 3, 0, 22, 0, 2, 37, 207', 'decimal', '01 03 00 16 00 02 25 CF'],
  ['10 03 00 00 00 01 87 4B', 'hex', '10 03 00 00 00 01 87 4B'],
  ['17 06 64 03 00 23 46 36', 'hex', '17 06 64 03 00 23 46 36'],
  ['20 04 00 16 00 02 19 18', 'hex', '20 04 00 16 00 02 19 18'],
  ['10 03 00 22 00 02 67 64', 'hex', '10 03 00 22 00 02 67 64'],
  ['17 22 72 13 59 65 87 10 54 68', 'decimal', '11 16 48 0D 3B 41 57 0A 36 44'],
  ['11, 16, 84, 16, 91, 34, 25, 96, 57, 41', 'hex', '11 16 84 16 91 34 25 96 57 41'],
  ['0000000 0301 0000 0a00 cdc5\n0000010', 'hexdump-words', '01 03 00 00 00 0A C5 CD'],
  // No evidence: the shape decides.
  ['10 20 30', 'hex', '10 20 30'],
  ['10, 20, 30', 'decimal', '0A 14 1E'],
  ['01, 02, 10', 'hex', '01 02 10'],
  ['1 2 10', 'decimal', '01 02 0A'],
  ['1 2 A', 'hex', '01 02 0A'],
  ['00000001 00000011', 'binary', '01 03'],
  ['01 2 10', 'hex', '01 02 10'],
  ['001 002 010', 'decimal', '01 02 0A'],
  ['7', 'decimal', '07'],
  // A time of day, or three bytes.
  ['10:31:12', 'hex', '10 31 12'],
  ['<<< 10:31:12', 'hex', '10 31 12'],
  ['10:31:12 01', 'hex', '01'],
  ['17', 'hex', '17'],
  [':010300000001FB', 'ascii-frame', '3A 30 31 30 33 30 30 30 30 30 30 30 31 46 42'],
  // A colon before hexadecimal whose CRC holds.
  [':01030000000AC5CD', 'hex', '01 03 00 00 00 0A C5 CD'],
  ['00000000  01 03 00 00', 'hexdump', '01 03 00 00'],
  ["b'\\x01A'", 'escapes', '01 41'],
  ['C:\\logs\\01\\02.txt\nTX: 01 03 00 00 00 0A', 'hex', '01 03 00 00 00 0A'],
] as const)('%j is read as %s', (text, reading, bytes) => {
  const read = readBytes(text);
  expect(read.reading).toBe(reading);
  expect(formatBytes(read.bytes)).toBe(bytes);
});

test('another reading can be chosen', () => {
  const text = '10 20 30';
  expect(readBytes(text).alternatives.map(({ reading }) => reading)).toEqual(['decimal']);
  const decimal = readBytes(text, 'decimal');
  expect(formatBytes(decimal.bytes)).toBe('0A 14 1E');
  expect(decimal.alternatives.map(({ reading, bytes }) => [reading, formatBytes(bytes)])).toEqual([
    ['hex', '10 20 30'],
  ]);
});

test('a long heading of numbers does not decide how the log under it is read', () => {
  const heading = 'channel 1 2 3 4 of 16\n'.repeat(600);
  const log = 'TX: 01 03 00 00 00 0A C5 CD\n'.repeat(600);
  const { reading, chunks } = readBytes(heading + log);
  expect(reading).toBe('hex');
  expect(chunks).toHaveLength(600);
});

test('what was read can be sent to another thread', () => {
  const read = readBytes('10 20');
  expect(structuredClone(read)).toEqual(read);
  expect(structuredClone(read).alternatives[0]?.bytes).toEqual(Uint8Array.of(10, 20));
});

test('an alternative has all bytes of a long text', () => {
  const text = '10 20\n'.repeat(10_000);
  const [decimal] = readBytes(text).alternatives;
  expect(decimal?.bytes).toHaveLength(20_000);
});

test.each([
  ['01 03 0 00', [{ code: 'nibble-missing', start: 6, end: 7 }], '01 03 00 00'],
  ['01030', [{ code: 'odd-digits', start: 4, end: 5, digits: 5 }], '01 03'],
  ['1, 256, 3', [{ code: 'value-over-255', start: 3, end: 6, got: 256 }], '01 03'],
  ['0x01 0x100', [{ code: 'value-over-255', start: 5, end: 10, got: 256 }], '01'],
  ['01 0G 03', [{ code: 'not-a-byte', start: 3, end: 5 }], '01 03'],
  ['01 ?? 03', [{ code: 'not-a-byte', start: 3, end: 5 }], '01 03'],
  ['01 03 O1', [{ code: 'not-a-byte', start: 6, end: 8 }], '01 03'],
  ['01 03 ... C5 CD', [{ code: 'left-out', start: 6, end: 9 }], '01 03 C5 CD'],
  ['01 03 \u2026', [{ code: 'left-out', start: 6, end: 7 }], '01 03'],
  ["b'\\x01\\q\\x03'", [{ code: 'escape-unknown', start: 6, end: 8 }], '01 03'],
  ["b'\\x01\u20ac\\x03'", [{ code: 'character-unknown', start: 6, end: 7 }], '01 03'],
  ['\\u0001\\u20ac', [{ code: 'value-over-255', start: 6, end: 12, got: 0x20ac }], '01'],
  [' hello ', [{ code: 'no-bytes', start: 1, end: 6 }], ''],
  ['', [], ''],
])('%j: what cannot be read is said where it stands', (text, problems, bytes) => {
  const read = readBytes(text);
  expect(read.problems).toEqual(problems);
  expect(formatBytes(read.bytes)).toBe(bytes);
});

test('a number of another base than the one asked for is a problem', () => {
  const { problems, bytes } = readBytes('01 0A', 'decimal');
  expect(problems).toEqual([{ code: 'not-of-base', start: 3, end: 5, base: 10 }]);
  expect(formatBytes(bytes)).toBe('01');
});

test.each([
  [
    'Tx:000104-01 03\nRx:000105-01 83 02 C0 F1',
    [
      { from: 0, to: 2, direction: 'tx' },
      { from: 2, to: 7, direction: 'rx' },
    ],
  ],
  [
    '[RTU]>Rx > 10:31:12:316 - 01  83  02',
    [{ from: 0, to: 3, direction: 'rx', time: '10:31:12:316', transport: 'rtu' }],
  ],
  [
    '2024-01-02 10:31:12.316 Request: 01 03 00',
    [{ from: 0, to: 3, direction: 'request', time: '2024-01-02 10:31:12.316' }],
  ],
  [
    'TX: 01 03 RX: 01 83',
    [
      { from: 0, to: 2, direction: 'tx' },
      { from: 2, to: 4, direction: 'rx' },
    ],
  ],
  ['Response from instrument: 01 03 02', [{ from: 0, to: 3, direction: 'response' }]],
  [
    '01 03 00\n01 83 02',
    [
      { from: 0, to: 3 },
      { from: 3, to: 6 },
    ],
  ],
  // libmodbus: sent in square, received in angle brackets.
  [
    '[01][03]\n<01><83>',
    [
      { from: 0, to: 2, direction: 'tx' },
      { from: 2, to: 4, direction: 'rx' },
    ],
  ],
  // A heading, a line that goes on, and one byte a line.
  ['Reply:\n01 83 02', [{ from: 0, to: 3, direction: 'response' }]],
  [
    'TX: 01 03\n    00 00\nRX: 01 83',
    [
      { from: 0, to: 4, direction: 'tx' },
      { from: 4, to: 6, direction: 'rx' },
    ],
  ],
  ['Received Byte 1 (0X1)\nReceived Byte 131 (0X83)', [{ from: 0, to: 2, direction: 'rx' }]],
  ['uint8_t f[] = {\n  0x01, 0x03,\n  0x00, 0x00\n};', [{ from: 0, to: 4 }]],
  ['00000000  01 03\n00000002  00 00\n00000004', [{ from: 0, to: 4 }]],
  [
    'TX: :0103FB\nRX: :0183FB',
    [
      { from: 0, to: 9, direction: 'tx' },
      { from: 9, to: 16, direction: 'rx' },
    ],
  ],
  ["Sent b'\\x01\\x03'", [{ from: 0, to: 2, direction: 'tx' }]],
])('%j: the parts of a paste', (text, chunks) => {
  expect(readBytes(text).chunks).toEqual(chunks);
});

test('what a log says again of the frame it has just received is not read again', () => {
  const log = 'RECV: 0x1 0x83 0x2 0xc0 0xf1\nProcessing: 0x1 0x83 0x2 0xc0 0xf1';
  expect(formatBytes(readBytes(log).bytes)).toBe('01 83 02 C0 F1');
});
