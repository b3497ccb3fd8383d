import { expect, test } from 'vitest';
import { isBinary, otherFile } from '../../../src/captures/index.ts';

const text = (content: string) => new TextEncoder().encode(content);

test.each<[string, Uint8Array, boolean]>([
  ['zeros', new Uint8Array(4096), true],
  ['all values of a byte', Uint8Array.from({ length: 4096 }, (_, at) => (at * 151) & 0xff), true],
  ['a frame of RTU', Uint8Array.of(0x01, 0x03, 0x00, 0x6b, 0x00, 0x02, 0xb5, 0xd7), true],
  ['nothing', new Uint8Array(0), false],
  ['a log', text('Tx 01 03 00 6B 00 02 B5 D7\r\n'.repeat(100)), false],
  ['a text that is cut in a letter', text('Größe '.repeat(700)).subarray(0, 4095), false],
  ['UTF-16 by its mark', Uint8Array.of(0xff, 0xfe, 0x30, 0x00, 0x31, 0x00), false],
  ['gzip', Uint8Array.of(0x1f, 0x8b, 8, 0, 0, 0, 0, 0), false],
  // draft-ietf-opsawg-pcap, section 4: magic number, version 2.4, no zone, 65535 octets, Ethernet.
  [
    'pcap',
    Uint8Array.of(0xd4, 0xc3, 0xb2, 0xa1, 2, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 0, 0, 1, 0, 0, 0),
    false,
  ],
  // draft-ietf-opsawg-pcapng, section 4.1: Section Header Block of 28 octets.
  [
    'pcapng',
    Uint8Array.of(
      10,
      13,
      13,
      10,
      28,
      0,
      0,
      0,
      0x4d,
      0x3c,
      0x2b,
      0x1a,
      1,
      0,
      0,
      0,
      255,
      255,
      255,
      255,
      255,
      255,
      255,
      255,
      28,
      0,
      0,
      0,
    ),
    false,
  ],
])('%s', (_, beginning, binary) => {
  expect(isBinary(beginning)).toBe(binary);
});

test.each<[string, Uint8Array, string | undefined]>([
  // APPNOTE.TXT 4.3.7; PNG 5.2; ITU T.81 B.1.1.3 and JFIF; ISO 32000-1 7.5.2.
  ['a workbook', Uint8Array.of(0x50, 0x4b, 3, 4, 20, 0, 6, 0), 'zip'],
  ['a PNG', Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 0, 0, 0, 13), 'picture'],
  ['a JPEG', Uint8Array.of(0xff, 0xd8, 0xff, 0xe0), 'picture'],
  ['a PDF', text('%PDF-1.7\n'), 'pdf'],
  ['a frame of RTU', Uint8Array.of(0x01, 0x03, 0x00, 0x6b, 0x00, 0x02, 0xb5, 0xd7), undefined],
  ['a signature that is cut', Uint8Array.of(0x50, 0x4b, 3), undefined],
])('of %s its first bytes say what it is', (_, bytes, kind) => {
  expect(otherFile(bytes)).toBe(kind);
});
