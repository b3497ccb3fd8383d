import fc from 'fast-check';
import { expect, test } from 'vitest';
import {
  type ByteFormat,
  type ByteNotation,
  byteFormats,
  formatBytes,
  readBytes,
  writeBytes,
} from '../../../src/notation/index.ts';
import { anyCharacter } from '../any-character.ts';

const notations: readonly ByteNotation[] = [
  'hex',
  'decimal',
  'binary',
  'escapes',
  'ascii-frame',
  'hexdump',
  'hexdump-words',
];

/** Pieces of logs, programs and dumps, in any order. */
const pieces = fc
  .array(
    fc.constantFrom(
      ...[
        '01',
        '0A',
        '1',
        '255',
        '256',
        '0x',
        '0x01',
        '(0x1)',
        '16#',
        '06h',
        '\\x01',
        '\\',
        '\\n',
        "b'",
        "'",
        '"',
        '`',
      ],
      ...[
        ' ',
        '  ',
        '\t',
        '\n',
        '\r\n',
        '\r',
        ',',
        ', ',
        ':',
        ': ',
        '=',
        '-',
        '.',
        '...',
        '|',
        '/',
        '//',
        '/*',
        '(',
        ')',
      ],
      ...[
        '[',
        ']',
        '[8]',
        '<',
        '>',
        '{',
        '}',
        '->',
        '>>>',
        '#',
        '$',
        '@3FFB',
        'TX',
        'Rx: ',
        'word',
        'be',
        'add',
        'RTU',
      ],
      ...[
        '10:31:12',
        '2024-01-02 ',
        '00000000  ',
        '|..|',
        '0.123456',
        ':010300',
        '<CR>',
        '\u2026',
        '\uff10',
        '\u2019',
        'é',
        '😀',
      ],
    ),
    { maxLength: 20 },
  )
  .map((parts) => parts.join(''));

const anyText = fc.oneof(fc.string({ unit: anyCharacter, maxLength: 60 }), fc.string({ maxLength: 60 }), pieces);

test('any text is read, in any way, and each byte has its place', () => {
  fc.assert(
    fc.property(anyText, fc.option(fc.constantFrom(...notations), { nil: undefined }), (text, as) => {
      const { bytes, origin, chunks, problems, alternatives } = readBytes(text, as);
      expect(origin).toHaveLength(bytes.length);
      let before = 0;
      for (const { start, end } of origin) {
        expect(start).toBeGreaterThanOrEqual(before);
        expect(end).toBeGreaterThan(start);
        expect(end).toBeLessThanOrEqual(text.length);
        before = start;
      }
      expect(chunks.map(({ from }) => from)).toEqual([0, ...chunks.map(({ to }) => to)].slice(0, chunks.length));
      expect(chunks.at(-1)?.to ?? 0).toBe(bytes.length);
      for (const { start, end } of problems) {
        expect(start).toBeLessThan(end);
        expect(end).toBeLessThanOrEqual(text.length);
      }
      for (const { reading, bytes: other } of alternatives) expect(other).toEqual(readBytes(text, reading).bytes);
    }),
    { numRuns: 700 },
  );
});

const formats = Object.keys(byteFormats) as ByteFormat[];

test.each(formats)('what is copied as %s is read back', (format) => {
  fc.assert(
    fc.property(fc.uint8Array({ maxLength: 300 }), (bytes) => {
      // One decimal number of two digits is as well one byte of hexadecimal; nothing in it tells.
      fc.pre(!(format === 'decimal' && bytes.length === 1 && /^\d\d$/.test(String(bytes[0]))));
      const { bytes: read, problems } = readBytes(writeBytes(bytes, format));
      expect(formatBytes(read)).toBe(formatBytes(bytes));
      expect(problems.filter(({ code }) => code !== 'no-bytes')).toEqual([]);
    }),
    { numRuns: 150 },
  );
});

test('an ASCII line is read back', () => {
  fc.assert(
    fc.property(fc.uint8Array({ minLength: 3, maxLength: 255 }), (bytes) => {
      const line = `:${writeBytes(bytes, 'plain')}`;
      const read = readBytes(line);
      fc.pre(read.reading === 'ascii-frame');
      expect(String.fromCharCode(...read.bytes)).toBe(line);
    }),
  );
});

test('long texts of one kind are read to their end', () => {
  const kinds = [
    '0',
    ' ',
    '/*',
    '(*',
    '[',
    'a[',
    '\\',
    "'",
    '@a',
    '(0x1) ',
    '...',
    '  .',
    '1.1.',
    '{1\n',
    '::010203',
    '\r',
  ];
  for (const kind of kinds) expect(() => readBytes(kind.repeat(50_000))).not.toThrow();
});
