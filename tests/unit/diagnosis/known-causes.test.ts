import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { diagnose } from '../../../src/diagnosis/index.ts';
import { codeRange } from '../../../src/modbus/index.ts';
import { characters, hex } from '../modbus/frames.ts';
import { findingsOf, firstOf, type Known, repairsOf } from './findings.ts';

const rtu = { transport: 'rtu' } as const;

describe('a function that nobody described', () => {
  // Its reply has 241 bytes by its own count; the first 32 of them end in zeros by chance.
  const PIECE = `01 43 EC 00 00 00 00 00 00 00 00 00 00 00 2C 0F FF FF 00 00 00 00 00 00 00 00 04 76 00 00 00 00`;

  it.each([
    ['zeros at the end', PIECE, { request: '01 43 31 00 00 76 CB 1F' }],
    ['zeros at the end, on a line that is known', PIECE, { ...rtu, request: '01 43 31 00 00 76 CB 1F' }],
    ['ones at the end', '01 43 00 00 11 22 33 44 FF FF', { request: '01 43 31 00 00 76 CB 1F' }],
    ['two bytes twice at the end', '01 43 00 00 11 22 33 44 33 44', { request: '01 43 31 00 00 76 CB 1F' }],
  ])('%s are not called a CRC with confidence', (_, bytes, known) => {
    for (const { confidence } of findingsOf(bytes, known)) expect(confidence).toBe('possible');
  });

  it('still shows a CRC whose bytes are swapped', () => {
    expect(firstOf('01 41 AA BB CC DD 61 F9', rtu)).toMatchObject({ code: 'crc-byte-order', got: 0xf961 });
  });

  it('has its CRC missing with certainty for no bytes, whatever was asked', () => {
    const unknown = Array.from({ length: 127 }, (_, code) => code + 1).filter((code) => codeRange(code) !== 'public');
    fc.assert(
      fc.property(
        fc.constantFrom(...unknown),
        fc.uint8Array({ maxLength: 60 }),
        fc.integer({ min: 1, max: 247 }),
        (functionCode, data, unit) => {
          const bytes = Uint8Array.of(unit, functionCode, ...data, 0, 0);
          const request = Uint8Array.of(unit, functionCode, 0, 0);
          for (const context of [{}, { transport: 'rtu' as const }, { request }]) {
            const missing = diagnose(bytes, context).find(({ code }) => code === 'crc-missing');
            expect(missing?.confidence ?? 'possible').toBe('possible');
          }
        },
      ),
      { numRuns: 100 },
    );
  });
});

describe('the request tells a reply that is cut off from one with a wrong count', () => {
  // 26 input registers are asked for, 52 bytes. The last two bytes that came are the CRC of those before by chance.
  const BYTES = '01 04 34 BF 12 00 01 00 02 00 03 00 04 00 05 29 CF';

  it('the count is the one that was asked for', () => {
    const found = firstOf(BYTES, { request: '01 04 00 00 00 1A 71 C1' });
    expect(found).toMatchObject({ code: 'truncated', has: 17, missing: 40 });
  });

  it('six registers were asked for', () => {
    const found = firstOf(BYTES, { ...rtu, request: '01 04 00 00 00 06 70 08' });
    expect(found).toMatchObject({ code: 'byte-count', got: 52, expected: 12 });
  });

  it('nothing is known of the request', () => {
    expect(firstOf(BYTES, rtu)).toMatchObject({ code: 'byte-count', got: 52, expected: 12 });
  });
});

describe('the CRC of a part of the frame', () => {
  // Two registers, 000A and 0102, are written from address 1 on in unit 17.
  const WRITE = '11 10 00 01 00 02 04 00 0A 01 02';

  it.each([
    ['the first six bytes, as the reply has them', '12 98', { code: 'crc-of-other-frame', of: 'reply' }],
    ['up to the byte count', '19 CE', { code: 'crc-span', over: 'part', first: 0, last: 7 }],
    ['without the last register', '0A 03', { code: 'crc-span', over: 'part', first: 0, last: 9 }],
    ['without the last byte of a register', '0F CA', { code: 'crc-span', over: 'part', first: 0, last: 8 }],
    ['from the address to the first register', 'DA AF', { code: 'crc-span', over: 'part', first: 2, last: 9 }],
    ['from the middle of the address on', 'B4 50', { code: 'crc-span', over: 'part', first: 3, last: 10 }],
  ])('%s', (_, crc, found) => {
    expect(firstOf(`${WRITE} ${crc}`, rtu)).toMatchObject(found);
    expect(repairsOf(firstOf(`${WRITE} ${crc}`, rtu))).toEqual([`${WRITE} C6 F0`]);
  });

  it('is never more than possible if it ends inside a field', () => {
    for (const crc of ['0F CA', 'B4 50']) {
      expect(firstOf(`${WRITE} ${crc}`, rtu).confidence).toBe('possible');
    }
    expect(firstOf(`${WRITE} 19 CE`, rtu).confidence).not.toBe('possible');
  });
});

describe('the CRC of another frame', () => {
  const REPLY = '01 03 06 00 01 00 02 00 03';
  it.each([
    ['this reply with two registers instead of three', `${REPLY} 2A 32`, 'shorter', `${REPLY} FD 74`],
    ['this reply with a zero behind', `${REPLY} 0C D7`, 'longer', `${REPLY} FD 74`],
    [
      'this write with a zero behind',
      '11 10 00 01 00 02 04 00 0A 01 02 B1 E8',
      'longer',
      '11 10 00 01 00 02 04 00 0A 01 02 C6 F0',
    ],
    ['the reply that the value 1 would get', '01 03 30 0D 00 01 79 84', 'reply', '01 03 30 0D 00 01 1A C9'],
    ['the reply with zeros', '01 03 00 6B 00 02 FA 33', 'reply', '01 03 00 6B 00 02 B5 D7'],
  ])('%s', (_, bytes, of, repaired) => {
    expect(firstOf(bytes, rtu)).toMatchObject({ code: 'crc-of-other-frame', of });
    expect(repairsOf(firstOf(bytes, rtu))).toEqual([repaired]);
  });
});

describe('hexadecimal text of an RTU frame', () => {
  const bytesOf = (text: string) => diagnose(characters(text));

  it('whose byte count is odd, and whose CRC holds', () => {
    const [found] = bytesOf('0103090103047FFFFFFFd2674c5a');
    expect(found).toMatchObject({ code: 'hex-of-ascii-frame', text: '0103090103047FFFFFFFd2674c5a', repaired: [] });
  });

  it('whose CRC does not hold is not claimed', () => {
    expect(bytesOf('0103090103047FFFFFFFd2674c5b')[0]?.code).not.toBe('hex-of-ascii-frame');
  });
});

describe('the envelope of a data logger', () => {
  const REQUEST =
    'A5 17 00 10 45 05 00 E8 99 B5 6A 02 00 00 00 00 00 00 00 00 00 00 00 00 00 00 01 03 00 00 00 0A C5 CD B3 15';
  const REPLY = 'A5 15 00 10 15 05 45 E8 99 B5 6A 02 01 11 22 33 44 55 00 00 00 10 00 00 00 01 03 02 00 01 79 84 3A 15';

  it.each([
    ['a request', REQUEST, 26, '01 03 00 00 00 0A C5 CD'],
    ['a reply', REPLY, 25, '01 03 02 00 01 79 84'],
  ])('%s is opened', (_, bytes, from, inside) => {
    const found = firstOf(bytes);
    expect(found).toMatchObject({ code: 'envelope', protocol: 'solarman-v5', serial: 1790286312, holds: true, from });
    expect(repairsOf(found)).toEqual([inside]);
  });

  it('with a wrong sum says so', () => {
    expect(firstOf(REPLY.replace('3A 15', '3B 15'))).toMatchObject({ code: 'envelope', holds: false });
  });

  it('around a frame with a wrong CRC repairs nothing', () => {
    const found = firstOf(REPLY.replace('79 84 3A', '79 85 3B'));
    expect(found).toMatchObject({ code: 'envelope', holds: true });
    expect(repairsOf(found)).toEqual([]);
  });
});

describe('a receiver at three quarters of the speed', () => {
  it.each([
    ['11 03 06 AE 41 56 52 43 40 49 AD', '80 48 AF D0 A2 8A 80 94 FD', { pattern: 'too-slow', times: 0.75 }],
    [
      '01 03 14 00 95 00 97 00 E1 00 E1 00 00 00 C8 03 26 00 00 03 25 03 26 A1 B5',
      '80 48 02 22 23 38 38 00 B4 48 01 80 68 05 8B 9C FD',
      { confidence: 'possible' },
    ],
  ])('sees of %s', (_, seen, found) => {
    expect(firstOf(seen)).toMatchObject({ code: 'noise', ...found });
  });

  it('is not what a frame that is cut off shows', () => {
    expect(firstOf('01 03 14 00 95 00 97 00 E1 00 E1 00 00', rtu).code).toBe('truncated');
  });
});

describe('no Modbus frame', () => {
  const text = (said: string) => Array.from(said, (one) => one.charCodeAt(0).toString(16).padStart(2, '0')).join(' ');

  it.each([
    ['a request of Daly', 'A5 40 90 08 00 00 00 00 00 00 00 00 7D', 'daly', 'checksum'],
    ['the beginning of a message of Daly', 'A5 01 90 08 02 10 00', 'daly', 'shape'],
    ['JK: read all', '4E 57 00 13 00 00 00 00 06 03 00 00 00 00 00 00 68 00 00 01 29', 'jk-bms', 'checksum'],
    ['JBD: read the basic values', 'DD A5 03 00 FF FD 77', 'jbd-bms', 'checksum'],
    ['JBD: two bytes of data', 'DD 04 00 02 12 34 FF B8 77', 'jbd-bms', 'checksum'],
    [
      'Pylontech: read the protocol version',
      '7E 32 30 30 32 34 36 34 32 45 30 30 32 30 32 46 44 33 33 0D',
      'pylontech',
      'checksum',
    ],
    ['SML: the beginning of a message', '1B 1B 1B 1B 01 01 01 01 76 05 00 11 22 33', 'sml', 'shape'],
    ['JK: the beginning of a record', '55 AA EB 90 02 00 D0 0C D1 0C', 'jk-bms', 'shape'],
    ['DL/T 645: read the address', '68 AA AA AA AA AA AA 68 13 00 DF 16', 'dl-t-645', 'checksum'],
    ['DL/T 645 behind bytes that wake', 'FE FE FE FE 68 AA AA AA AA AA AA 68 13 00 DF 16', 'dl-t-645', 'checksum'],
    ['M-Bus: a short frame', '10 5B 01 5C 16', 'm-bus', 'checksum'],
    ['M-Bus: a control frame', '68 03 03 68 53 FE A6 F7 16', 'm-bus', 'checksum'],
    ['NMEA', text('$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n'), 'nmea', 'checksum'],
    ['a greeting', text('RS485 gateway v1.2 ready\r\n'), 'text', 'characters'],
  ])('%s', (_, bytes, protocol, proof) => {
    expect(firstOf(bytes)).toMatchObject({ code: 'other-protocol', protocol, proof, repaired: [] });
  });

  it.each([
    ['a whole frame that begins like Daly', 'A5 03 00 08 00 01 1C EC', 'valid'],
    ['an ASCII frame', ':1103006B00037E\r\n', 'valid'],
    ['hexadecimal text', text('01 03 00 00 00 0A C5 CD'), 'hex-of-ascii-frame'],
  ])('%s is one of Modbus', (_, bytes, code) => {
    expect(firstOf(bytes).code).toBe(code);
  });
});

describe('known misprints', () => {
  const known: Known = rtu;
  it.each([
    ['set 30 Hz', '06 06 02 AB 10 00 E6 A1', 'weg-set-30-hz', false, '06 06 02 AB 10 00 F5 E5'],
    ['set 30 Hz, swapped', '06 06 02 AB 10 00 A1 E6', 'weg-set-30-hz', true, '06 06 02 AB 10 00 F5 E5'],
    ['run', '06 06 02 AA 00 01 F5 27', 'weg-run', false, '06 06 02 AA 00 01 68 25'],
    ['run, swapped', '06 06 02 AA 00 01 27 F5', 'weg-run', true, '06 06 02 AA 00 01 68 25'],
    ['stop', '06 06 02 AA 00 00 26 35', 'weg-stop', false, '06 06 02 AA 00 00 A9 E5'],
    ['stop, swapped', '06 06 02 AA 00 00 35 26', 'weg-stop', true, '06 06 02 AA 00 00 A9 E5'],
    ['read the speed', '06 03 02 A9 00 01 D5 E7', 'weg-read-speed', false, '06 03 02 A9 00 01 54 25'],
    ['read the speed, swapped', '06 03 02 A9 00 01 E7 D5', 'weg-read-speed', true, '06 03 02 A9 00 01 54 25'],
  ])('%s', (_, bytes, misprint, swapped, repaired) => {
    for (const context of [known, {}]) {
      const found = firstOf(bytes, context);
      expect(found).toMatchObject({ code: 'known-misprint', confidence: 'certain', misprint, swapped, wrong: 'crc' });
      expect(repairsOf(found)).toEqual([repaired]);
    }
  });

  it('an address is only possibly the misprinted one', () => {
    const [first, second] = findingsOf('11 03 00 0B 00 03', rtu);
    expect(first?.code).toBe('crc-missing');
    expect(second).toMatchObject({
      code: 'known-misprint',
      misprint: 'introduction-read-40108',
      confidence: 'possible',
    });
    expect(second && repairsOf(second)).toEqual(['11 03 00 6B 00 03 76 87']);
  });

  it('the right frames are valid, and other values are another cause', () => {
    expect(firstOf('06 06 02 AB 10 00 F5 E5', rtu).code).toBe('valid');
    expect(firstOf('06 06 02 AB 10 01 E6 A1', rtu).code).not.toBe('known-misprint');
    expect(hex('06 06 02 AB 10 00 F5 E5')).toHaveLength(8);
  });
});
