import { expect, test } from 'vitest';
import { formatBytes, readBytes } from '../../../src/notation/index.ts';

/** The pieces of a text: `side: bytes`, with `-` where no side is said. */
function piecesOf(text: string): string[] {
  const { bytes, chunks } = readBytes(text);
  return chunks.map(({ from, to, direction = '-' }) => `${direction}: ${formatBytes(bytes.subarray(from, to))}`);
}

const REQUEST = '01 03 00 00 00 0A C5 CD';
const REFUSAL = '01 83 02 C0 F1';

const kinds: Readonly<Record<string, readonly (readonly [text: string, pieces: readonly string[]])[]>> = {
  'columns of characters': [
    [
      '    01 03 02 a0 d7 91 97 00\t....\u00a0\u00d7\u2018\u2014.'.replace('....', '...'),
      ['-: 01 03 02 A0 D7 91 97 00'],
    ],
    ['20 20 20 00 63 00      .c.', ['-: 20 20 20 00 63 00']],
    ['00000000  30 31 32 33 34 35 36 37  38 39                    01234567 89', ['-: 30 31 32 33 34 35 36 37 38 39']],
    ['00000000  01 03 00 00 00 0a c5 cd\n00000008  31  1', ['-: 01 03 00 00 00 0A C5 CD 31']],
    [
      '10:31:12 COM3\n53 02 38 36 41 A9 74 61 5E F7 58 94 7C 11 1A 00  S.86A.ta^.X.|...\n64 94  d.',
      ['-: 53 02 38 36 41 A9 74 61 5E F7 58 94 7C 11 1A 00 64 94'],
    ],
  ],
  'marks of colours, bold letters and comments': [
    [`\u001b[1;33mTX\u001b[0m: \u001b[32m${REQUEST}\u001b[0m`, [`tx: ${REQUEST}`]],
    ['> **01 03** __00 00__ `00 0A` C5 CD', [`-: ${REQUEST}`]],
    [`<b>${REQUEST}</b>`, [`-: ${REQUEST}`]],
    [`// ${REQUEST}`, [`-: ${REQUEST}`]],
    [`-- ${REQUEST}`, [`-: ${REQUEST}`]],
    [`(* ${REQUEST} *)`, [`-: ${REQUEST}`]],
    ['0x6d (m)\n0x56 (V)\n0x03 (^C)\n0x0d (CR)', ['-: 6D 56 03 0D']],
  ],
  'things apart': [
    [`"\\x01\\x03" then "\\x01\\x83"`, ['-: 01 03', '-: 01 83']],
    [`${REQUEST}, ${REFUSAL}`, [`-: ${REQUEST}`, `-: ${REFUSAL}`]],
    [
      '10:31:12 IP 10.0.0.2.51234 > 10.0.0.9.502: length 12\n\t0x0000:  4500 0034\n10:31:13 IP 10.0.0.9.502 > 10.0.0.2.51234: length 12\n\t0x0000:  4500 0035',
      ['-: 45 00 00 34', '-: 45 00 00 35'],
    ],
  ],
  'each line in its own base': [
    [`TX: ${REQUEST}\nRX: [1, 131, 2, 192, 241]`, [`tx: ${REQUEST}`, `rx: ${REFUSAL}`]],
    [`TX: 1, 3, 0, 0, 0, 10, 197, 205\nRX: ${REFUSAL}`, [`tx: ${REQUEST}`, `rx: ${REFUSAL}`]],
    [`TX: ${REQUEST}\nRX: b'\\x01\\x83\\x02\\xc0\\xf1'`, [`tx: ${REQUEST}`, `rx: ${REFUSAL}`]],
    ['0, 7, 0, 0, 0, 6, 203, 138, 4, 1, 17, 11, 18, 52, 0, 1', ['-: 00 07 00 00 00 06 CB 8A 04 01 11 0B 12 34 00 01']],
  ],
  'what a log says again, or of itself': [
    ['buffer: <Buffer 01 83>\nbuffer: <Buffer 01 83 02>\nbuffer: <Buffer 01 83 02 c0 f1>', [`-: ${REFUSAL}`]],
    [`Handling data: ${REQUEST}\nProcessing: ${REQUEST}`, [`-: ${REQUEST}`]],
    [`RX: ${REFUSAL}\nHWaddr 00:01:05:32:37:1f`, [`rx: ${REFUSAL}`]],
    [`RX: ${REFUSAL}\nCRC calculated C0F1, CRC received 0x1234`, [`rx: ${REFUSAL}`]],
  ],
  'tables and code': [
    ['0 01\n1 03\n2 00\n3 00\n4 00\n5 0A', ['-: 01 03 00 00 00 0A']],
    [
      'Slave Address\t11\nFunction\t03\nStarting Address Hi\t00\nStarting Address Lo\t6B\nNo. of Points Hi\t00\nNo. of Points Lo\t03',
      ['-: 11 03 00 6B 00 03'],
    ],
    [
      'byte unit = 1;\nushort start = 0x1234;\nm[0] = unit;\nm[1] = 3;\nm[2] = (byte)(start >> 8);\nm[3] = (byte)start;',
      ['-: 01 03 12 34'],
    ],
    ["b'\\x00' * 2 + b'\\x01'", ['-: 00 00 01']],
  ],
  sides: [
    [`PLC sends: ${REFUSAL}\nWEG responds: ${REFUSAL}`, [`tx: ${REFUSAL}`, `response: ${REFUSAL}`]],
    [`RECD ${REFUSAL}`, [`rx: ${REFUSAL}`]],
    [`OUT ${REQUEST}\nIN ${REFUSAL}`, [`tx: ${REQUEST}`, `rx: ${REFUSAL}`]],
    [`Written data\n  ${REQUEST}\nRead data\n  ${REFUSAL}`, [`tx: ${REQUEST}`, `rx: ${REFUSAL}`]],
    [`master -> slave: ${REQUEST}\nslave -> master: ${REFUSAL}`, [`request: ${REQUEST}`, `response: ${REFUSAL}`]],
    [`10:31:12 -> ${REQUEST}\n10:31:13 <- ${REFUSAL}`, [`tx: ${REQUEST}`, `rx: ${REFUSAL}`]],
    [`10:31:12 -> ${REQUEST}\n10:31:13 -> ${REFUSAL}`, [`-: ${REQUEST}`, `-: ${REFUSAL}`]],
    [`> ${REQUEST}\n< ${REFUSAL}`, [`tx: ${REQUEST}`, `rx: ${REFUSAL}`]],
    [`Gesendet: ${REQUEST}\nAntwort: ${REFUSAL}`, [`tx: ${REQUEST}`, `response: ${REFUSAL}`]],
    [`Enviado: ${REQUEST}\nRecibido: ${REFUSAL}`, [`tx: ${REQUEST}`, `rx: ${REFUSAL}`]],
    [`Envoyé : ${REQUEST}\nRéponse : ${REFUSAL}`, [`tx: ${REQUEST}`, `response: ${REFUSAL}`]],
    [`主站发送：${REQUEST}\n从站返回：${REFUSAL}`, [`tx: ${REQUEST}`, `response: ${REFUSAL}`]],
  ],
};

test.each(Object.entries(kinds).flatMap(([kind, rows]) => rows.map(([text, pieces]) => ({ kind, text, pieces }))))(
  '$kind: $text',
  ({ text, pieces }) => {
    expect(piecesOf(text)).toEqual(pieces);
  },
);

test('numbers that are not taken for bytes are named with the reason', () => {
  const text = `RX: ${REFUSAL}\nProcessing: ${REFUSAL}\n7 registers of unit 17\nSrc: maker (00:01:05:32:37:1f)`;
  const said = readBytes(text).problems.map((problem) => [
    problem.code === 'set-aside' ? problem.why : problem.code,
    text.slice(problem.start, problem.end),
  ]);
  expect(said).toEqual([
    ['repeated', REFUSAL],
    ['words', '17'],
    ['address', '00:01:05:32:37:1f'],
  ]);
});

test('the checksum that a comment says is held against the bytes before', () => {
  const text = 'uint8_t test[] = {0x06, 0x06, 0x02, 0xAB, 0x10, 0x00};\n// Should be: 0xA1E6';
  const { bytes, problems } = readBytes(text);
  expect(formatBytes(bytes)).toBe('06 06 02 AB 10 00');
  expect(problems).toEqual([{ code: 'checksum-said', start: 69, end: 75, got: 0xa1e6, expected: 0xe5f5 }]);
});
