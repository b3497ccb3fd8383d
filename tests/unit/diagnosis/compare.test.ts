import { describe, expect, test } from 'vitest';
import { languages } from '../../../src/words/index.ts';
import { bytes, type Case, compared, said } from './compare.ts';

/** Read 3 holding registers from 0x006B of unit 17. */
const READ = '11 03 00 6B 00 03 76 87';
/** Write 000A and 0102 to 0x0001 and after, unit 17. */
const WRITE = '11 10 00 01 00 02 04 00 0A 01 02 C6 F0';
const follows = ['checksum', { code: 'checksum-follows' }] as const;

const checksums: Case[] = [
  { what: 'the same bytes', mine: READ, theirs: READ, causes: [{ code: 'identical' }] },
  {
    what: 'CRC bytes swapped',
    mine: READ,
    theirs: '11 03 00 6B 00 03 87 76',
    differences: [['checksum', { code: 'checksum-swapped', algorithm: 'crc', got: 0x7687, expected: 0x8776 }]],
  },
  {
    what: 'the CRC alone is wrong',
    mine: READ,
    theirs: '11 03 00 6B 00 03 12 34',
    differences: [['checksum', { code: 'checksum-alone-wrong', algorithm: 'crc', got: 0x3412, expected: 0x8776 }]],
  },
  {
    what: 'mine has the wrong CRC',
    mine: '11 03 00 6B 00 03 12 34',
    theirs: READ,
    differences: [['checksum', { code: 'my-checksum-wrong', algorithm: 'crc', got: 0x3412, expected: 0x8776 }]],
  },
  {
    what: 'another unit, and a CRC that fits neither',
    mine: READ,
    theirs: '12 03 00 6B 00 03 12 34',
    differences: [
      ['unitId', { code: 'unit-differs', mine: 17, theirs: 18 }],
      ['checksum', { code: 'checksum-wrong', algorithm: 'crc', got: 0x3412, expected: 0xb476 }],
    ],
  },
  {
    what: 'another unit with the CRC of mine',
    mine: READ,
    theirs: '12 03 00 6B 00 03 76 87',
    causes: [{ code: 'changed-after-checksum' }],
    differences: [['unitId', { code: 'unit-differs', mine: 17, theirs: 18 }]],
  },
  {
    what: 'no CRC',
    mine: READ,
    theirs: '11 03 00 6B 00 03',
    differences: [['checksum', { code: 'checksum-missing' }]],
  },
];

const fields: Case[] = [
  {
    what: 'unit 17 read as hexadecimal digits',
    mine: READ,
    theirs: '17 03 00 6B 00 03 76 E1',
    differences: [['unitId', { code: 'decimal-as-hex', mine: 0x11, theirs: 0x17, hex: 'theirs' }], follows],
  },
  {
    what: 'unit 10 read as decimal digits',
    mine: '10 03 00 00 00 01 87 4B',
    theirs: '0A 03 00 00 00 01 85 71',
    differences: [['unitId', { code: 'decimal-as-hex', mine: 16, theirs: 10, hex: 'mine' }], follows],
  },
  {
    what: 'address one below',
    mine: READ,
    theirs: '11 03 00 6A 00 03 27 47',
    differences: [['startAddress', { code: 'address-off-by-one', mine: 107, theirs: 106 }], follows],
  },
  {
    what: 'address one above',
    mine: READ,
    theirs: '11 03 00 6C 00 03 C7 46',
    differences: [['startAddress', { code: 'address-off-by-one', mine: 107, theirs: 108 }], follows],
  },
  {
    what: '40109 − 1 sent as the address: 40001 above 107 is 40108',
    mine: READ,
    theirs: '11 03 9C AC 00 03 E9 2A',
    differences: [['startAddress', { code: 'entity-number', whose: 'theirs', number: 40108, address: 107 }], follows],
  },
  {
    what: 'mine has the number of the manual',
    mine: '11 03 9C AC 00 03 E9 2A',
    theirs: READ,
    differences: [['startAddress', { code: 'entity-number', whose: 'mine', number: 40108, address: 107 }], follows],
  },
  {
    what: 'another address altogether',
    mine: READ,
    theirs: '11 03 02 00 00 03 06 E3',
    differences: [['startAddress', { code: 'address-differs', mine: 107, theirs: 512 }], follows],
  },
  {
    what: 'address with its low byte first',
    mine: READ,
    theirs: '11 03 6B 00 00 03 1B 7F',
    differences: [['startAddress', { code: 'bytes-swapped' }], follows],
  },
  {
    what: 'twice the quantity',
    mine: READ,
    theirs: '11 03 00 6B 00 06 B6 84',
    differences: [['quantity', { code: 'quantity-doubled', mine: 3, theirs: 6, whose: 'theirs' }], follows],
  },
  {
    what: 'half the quantity',
    mine: '11 03 00 6B 00 06 B6 84',
    theirs: READ,
    differences: [['quantity', { code: 'quantity-doubled', mine: 6, theirs: 3, whose: 'mine' }], follows],
  },
  {
    what: 'another quantity',
    mine: READ,
    theirs: '11 03 00 6B 00 05 F6 85',
    differences: [['quantity', { code: 'quantity-differs', mine: 3, theirs: 5 }], follows],
  },
  {
    what: '37 coils counted as the 5 bytes that hold them',
    mine: '11 01 00 13 00 25 0E 84',
    theirs: '11 01 00 13 00 05 0F 5C',
    differences: [['quantity', { code: 'quantity-of-bytes', mine: 37, theirs: 5, whose: 'theirs' }], follows],
  },
  {
    what: 'input registers in place of holding registers',
    mine: READ,
    theirs: '11 04 00 6B 00 03 C3 47',
    differences: [['functionCode', { code: 'other-table', mine: 3, theirs: 4 }], follows],
  },
  {
    what: 'function 06 in place of 03: its address and value are other fields of the same bytes',
    mine: READ,
    theirs: '11 06 00 6B 00 03 BA 87',
    differences: [['functionCode', { code: 'function-differs', mine: 3, theirs: 6 }], follows],
  },
  {
    what: 'function 10 for a single register',
    mine: '11 06 00 6B 00 03 BA 87',
    theirs: '11 10 00 6B 00 01 02 00 03 23 4A',
    differences: [
      ['functionCode', { code: 'single-or-multiple', mine: 6, theirs: 16 }],
      ['quantity', { code: 'field-of-function', functionCode: 16 }],
      ['byteCount', { code: 'field-of-function', functionCode: 16 }],
      follows,
    ],
  },
  {
    what: 'function 06 for a single register, where mine has 10',
    mine: '11 10 00 6B 00 01 02 00 03 23 4A',
    theirs: '11 06 00 6B 00 03 BA 87',
    differences: [
      ['functionCode', { code: 'single-or-multiple', mine: 16, theirs: 6 }],
      ['quantity', { code: 'field-of-function', functionCode: 16 }],
      ['byteCount', { code: 'field-of-function', functionCode: 16 }],
      follows,
    ],
  },
  {
    what: 'coil value 0001',
    mine: '11 05 00 AC FF 00 4E 8B',
    theirs: '11 05 00 AC 00 01 CE BB',
    differences: [['value', { code: 'coil-value-illegal', got: 1 }], follows],
  },
  {
    what: 'coil value 00FF',
    mine: '11 05 00 AC FF 00 4E 8B',
    theirs: '11 05 00 AC 00 FF 4F 3B',
    differences: [['value', { code: 'bytes-swapped' }], follows],
  },
  {
    what: 'the coil off',
    mine: '11 05 00 AC FF 00 4E 8B',
    theirs: '11 05 00 AC 00 00 0F 7B',
    differences: [['value', { code: 'coil-opposite', theirs: 0 }], follows],
  },
  {
    what: 'a mask differs',
    mine: '11 16 00 04 00 F2 00 25 66 E2',
    theirs: '11 16 00 04 00 F2 00 27 E7 23',
    differences: [['orMask', { code: 'value-differs', mine: 0x25, theirs: 0x27 }], follows],
  },
];

const lists: Case[] = [
  {
    what: 'registers with their low byte first',
    mine: WRITE,
    theirs: '11 10 00 01 00 02 04 0A 00 02 01 A5 DB',
    differences: [['registers', { code: 'bytes-swapped' }], follows],
  },
  {
    what: 'the low word first',
    mine: WRITE,
    theirs: '11 10 00 01 00 02 04 01 02 00 0A 46 98',
    differences: [['registers', { code: 'words-swapped' }], follows],
  },
  {
    what: 'all four bytes reversed',
    mine: WRITE,
    theirs: '11 10 00 01 00 02 04 02 01 0A 00 30 7B',
    differences: [['registers', { code: 'order-reversed' }], follows],
  },
  {
    what: 'one register of two',
    mine: WRITE,
    theirs: '11 10 00 01 00 02 04 00 0A 01 03 07 30',
    differences: [['registers', { code: 'content-differs', different: 1, of: 2 }], follows],
  },
  {
    what: 'a register more',
    mine: WRITE,
    theirs: '11 10 00 01 00 03 06 00 0A 01 02 00 00 B1 E8',
    differences: [
      ['quantity', { code: 'quantity-differs', mine: 2, theirs: 3 }],
      ['byteCount', { code: 'count-follows', mine: 4, theirs: 6 }],
      ['registers', { code: 'length-differs', mine: 4, theirs: 6 }],
      follows,
    ],
  },
  {
    what: 'no byte count',
    mine: WRITE,
    theirs: '11 10 00 01 00 02 00 0A 01 02 24 C4',
    differences: [['byteCount', { code: 'count-missing' }], follows],
  },
  {
    what: 'the byte count counts registers',
    mine: WRITE,
    theirs: '11 10 00 01 00 02 02 00 0A 01 02 4E F0',
    differences: [['byteCount', { code: 'count-of-registers', got: 2, expected: 4 }], follows],
  },
  {
    what: 'the first coil in the highest bit',
    mine: '11 0F 00 13 00 0A 02 CD 01 BF 0B',
    theirs: '11 0F 00 13 00 0A 02 B3 80 5E CB',
    differences: [['bits', { code: 'bits-reversed' }], follows],
  },
];

const whole: Case[] = [
  {
    what: 'the reply in place of the request',
    mine: READ,
    theirs: '11 03 06 02 2B 00 00 00 64 C8 BA',
    causes: [{ code: 'other-direction', theirs: 'response' }],
  },
  {
    what: 'the request in place of the reply: an echo',
    mine: '11 03 06 02 2B 00 00 00 64 C8 BA',
    theirs: READ,
    context: { direction: 'response', request: READ },
    causes: [{ code: 'echo-of-request' }],
  },
  {
    what: 'an exception in place of the reply',
    mine: '11 03 06 02 2B 00 00 00 64 C8 BA',
    theirs: '11 83 02 C1 34',
    context: { direction: 'response' },
    causes: [{ code: 'exception-instead', whose: 'theirs', functionCode: 3, exceptionCode: 2 }],
  },
  {
    what: 'an exception to the request',
    mine: READ,
    theirs: '11 83 02 C1 34',
    causes: [{ code: 'exception-instead', whose: 'theirs', functionCode: 3, exceptionCode: 2 }],
  },
  {
    what: 'a reply in place of the exception',
    mine: '11 83 02 C1 34',
    theirs: '11 03 06 02 2B 00 00 00 64 C8 BA',
    context: { direction: 'response' },
    causes: [{ code: 'exception-instead', whose: 'mine', functionCode: 3, exceptionCode: 2 }],
  },
  {
    what: 'bytes before',
    mine: READ,
    theirs: '00 FF 11 03 00 6B 00 03 76 87',
    differences: [['before', { code: 'extra-before', bytes: 2 }]],
  },
  {
    what: 'bytes before, and another address',
    mine: READ,
    theirs: 'FF 11 03 00 6A 00 03 27 47',
    differences: [
      ['before', { code: 'extra-before', bytes: 1 }],
      ['startAddress', { code: 'address-off-by-one', mine: 107, theirs: 106 }],
      follows,
    ],
  },
  {
    what: 'bytes behind',
    mine: READ,
    theirs: '11 03 00 6B 00 03 76 87 00',
    differences: [['after', { code: 'extra-after', bytes: 1 }]],
  },
  {
    what: 'bytes on both sides',
    mine: READ,
    theirs: '00 11 03 00 6B 00 03 76 87 00',
    differences: [
      ['before', { code: 'extra-before', bytes: 1 }],
      ['after', { code: 'extra-after', bytes: 1 }],
    ],
  },
  {
    what: 'the last byte missing',
    mine: READ,
    theirs: '11 03 00 6B 00 03 76',
    differences: [['checksum', { code: 'truncated', missing: 1 }]],
  },
  {
    what: 'cut off within the quantity',
    mine: READ,
    theirs: '11 03 00 6B 00',
    differences: [['quantity', { code: 'truncated', missing: 3 }]],
  },
  {
    what: 'a byte of the address missing',
    mine: '11 03 01 07 00 03 B7 66',
    theirs: '11 03 01 00 03 B7 66',
    causes: [{ code: 'changed-after-checksum' }],
    differences: [['startAddress', { code: 'bytes-missing', bytes: 1 }]],
  },
  {
    what: 'nothing at all',
    mine: READ,
    theirs: '',
    differences: [['unitId', { code: 'truncated', missing: 8 }]],
  },
];

const TCP = '00 01 00 00 00 06 11 03 00 6B 00 03';
const tcp = { transport: 'tcp' } as const;
const envelopes: Case[] = [
  {
    what: 'the same frame in ASCII',
    mine: READ,
    theirs: ':1103006B00037E\r\n',
    causes: [{ code: 'other-transport', mine: 'rtu', theirs: 'ascii', same: true }],
  },
  {
    what: 'a frame in ASCII without its end, with another quantity',
    mine: READ,
    theirs: ':1103006B00057C',
    causes: [{ code: 'other-transport', mine: 'rtu', theirs: 'ascii', same: false }],
    differences: [['quantity', { code: 'quantity-differs', mine: 3, theirs: 5 }]],
  },
  {
    what: 'the same frame over TCP',
    mine: READ,
    theirs: TCP,
    causes: [{ code: 'other-transport', mine: 'rtu', theirs: 'tcp', same: true }],
  },
  {
    what: 'RTU in place of TCP, though its bytes are an MBAP frame of function 0B too',
    mine: '00 01 00 00 00 06 01 03 00 00 00 02',
    theirs: '01 03 00 00 00 02 C4 0B',
    context: tcp,
    causes: [{ code: 'other-transport', mine: 'tcp', theirs: 'rtu', same: true }],
  },
  {
    what: 'the PDU alone',
    mine: READ,
    theirs: '03 00 6B 00 03',
    causes: [{ code: 'other-transport', mine: 'rtu', theirs: 'pdu', same: true }],
  },
  {
    what: 'another transaction',
    mine: TCP,
    theirs: '00 02 00 00 00 06 11 03 00 6B 00 03',
    context: tcp,
    differences: [['transactionId', { code: 'transaction-differs', mine: 1, theirs: 2 }]],
  },
  {
    what: 'the transaction with its low byte first',
    mine: TCP,
    theirs: '01 00 00 00 00 06 11 03 00 6B 00 03',
    context: tcp,
    differences: [['transactionId', { code: 'bytes-swapped' }]],
  },
  {
    what: 'the protocol identifier is not 0',
    mine: TCP,
    theirs: '00 01 00 05 00 06 11 03 00 6B 00 03',
    context: tcp,
    differences: [['protocolId', { code: 'protocol-differs', mine: 0, theirs: 5 }]],
  },
  {
    what: 'the MBAP length leaves out the unit',
    mine: TCP,
    theirs: '00 01 00 00 00 05 11 03 00 6B 00 03',
    context: tcp,
    differences: [['length', { code: 'count-wrong', got: 5, expected: 6 }]],
  },
  {
    what: 'the LRC is wrong',
    mine: ':1103006B00037E\r\n',
    theirs: ':1103006B00037F\r\n',
    context: { transport: 'ascii' },
    differences: [['checksum', { code: 'checksum-alone-wrong', algorithm: 'lrc', got: 0x7f, expected: 0x7e }]],
  },
  {
    what: 'lower-case digits',
    mine: ':1103006B00037E\r\n',
    theirs: ':1103006b00037E\r\n',
    context: { transport: 'ascii' },
    differences: [['startAddress', { code: 'lower-case-digits' }]],
  },
  {
    what: 'lower-case digits, and a wrong LRC: the bytes before it are the same',
    mine: ':1103006B00037E\r\n',
    theirs: ':1103006b00037F\r\n',
    context: { transport: 'ascii' },
    differences: [
      ['startAddress', { code: 'lower-case-digits' }],
      ['checksum', { code: 'checksum-alone-wrong', algorithm: 'lrc', got: 0x7f, expected: 0x7e }],
    ],
  },
  {
    what: 'no line end',
    mine: ':1103006B00037E\r\n',
    theirs: ':1103006B00037E',
    context: { transport: 'ascii' },
    differences: [['end', { code: 'line-end-missing' }]],
  },
];

for (const [group, cases] of Object.entries({ checksums, fields, lists, whole, envelopes })) {
  describe(group, () => {
    test.each(cases)('$what', (row) => {
      expect(said(compared(row))).toEqual({ causes: row.causes ?? [], differences: row.differences ?? [] });
    });
  });
}

describe('words', () => {
  test('every cause has sentences, with the numbers of its case', async () => {
    const { causeWords } = await languages.en.compare();
    for (const row of [checksums, fields, lists, whole, envelopes].flat()) {
      const { causes, differences } = compared(row);
      for (const cause of [...causes, ...differences.map((difference) => difference.cause)]) {
        const { why, todo = 'Nothing.' } = causeWords(cause);
        for (const sentence of [why, todo]) {
          expect(sentence).toMatch(/^[A-Z0-9].*\.$/);
          expect(sentence).not.toMatch(/undefined|NaN|object/);
        }
      }
    }
  });

  test('the CRC is said in the order of the wire, and what refused by its name', async () => {
    const { causeWords } = await languages.en.compare();
    expect(causeWords({ code: 'checksum-swapped', algorithm: 'crc', got: 0x7687, expected: 0x8776 }).why).toContain(
      'It should be 76 87',
    );
    const refused = { code: 'exception-instead', whose: 'theirs', functionCode: 3, exceptionCode: 2 } as const;
    expect(causeWords(refused).why).toContain('function 03, 02 ILLEGAL DATA ADDRESS');
  });
});

describe('places', () => {
  test('both bytes of a field are shown where only one differs, with the number they make', () => {
    const { differences } = compared({ what: '', mine: READ, theirs: '11 03 00 6A 00 03 27 47' });
    expect(differences[0]).toMatchObject({
      mine: { name: 'startAddress', kind: 'address', from: 2, to: 4, value: 107 },
      theirs: { name: 'startAddress', kind: 'address', from: 2, to: 4, value: 106 },
    });
  });

  test('behind a missing byte the fields stand under those of mine', () => {
    const { differences } = compared({ what: '', mine: WRITE, theirs: '11 10 00 01 00 02 00 0A 01 02 24 C4' });
    expect(differences).toMatchObject([
      { mine: { from: 6, to: 7, value: 4 }, theirs: undefined },
      { mine: { from: 11, to: 13 }, theirs: { from: 10, to: 12 } },
    ]);
  });

  test('runs are of one kind and of one field', () => {
    const { runs } = compared({ what: '', mine: READ, theirs: 'FF 11 03 00 6B 00 03 76 88' });
    expect(
      runs.map(({ kind, name, mineFrom, mineTo, theirsFrom, theirsTo }) =>
        [kind, name, mineFrom, mineTo, theirsFrom, theirsTo].join(' '),
      ),
    ).toEqual([
      'only-theirs before 0 0 0 1',
      'equal unitId 0 1 1 2',
      'equal functionCode 1 2 2 3',
      'equal startAddress 2 4 3 5',
      'equal quantity 4 6 5 7',
      'equal checksum 6 7 7 8',
      'different checksum 7 8 8 9',
    ]);
  });
});

describe('long input', () => {
  test('the bytes beyond 520 are left out, and said to be', () => {
    const long = `${READ} ${'00 '.repeat(600)}`;
    const { runs, causes } = compared({ what: '', mine: READ, theirs: long });
    expect(causes).toContainEqual({ code: 'left-out', mine: 0, theirs: 88 });
    expect(runs.at(-1)).toMatchObject({ kind: 'only-theirs', theirsTo: 520 });
    expect(bytes(long)).toHaveLength(608);
  });
});
