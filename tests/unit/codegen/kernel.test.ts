import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { crcWays } from '../../../src/codegen/options.ts';
import { decodeFrame, encodeFrame, type FrameInput, functionCodes } from '../../../src/modbus/index.ts';
import { programCases, repliesTo } from '../../programs/cases.ts';
import { legalFrame } from '../modbus/arbitraries.ts';
import { hex } from '../modbus/frames.ts';
import { Planned } from './planned.ts';

const transports = ['rtu', 'ascii', 'tcp'] as const;
const anyTransport = fc.constantFrom(...transports);
const text = (characters: string) => Uint8Array.from(characters, (one) => one.charCodeAt(0));

/** Frames of the specification (AP 6.1, 6.3, 6.16, 6.17 with unit 11h), their checksums by hand. */
const printed: readonly (readonly [string, FrameInput, Uint8Array])[] = [
  [
    'RTU',
    { transport: 'rtu', direction: 'request', unitId: 1, functionCode: 3, fields: { startAddress: 0, quantity: 10 } },
    hex('01 03 00 00 00 0A C5 CD'),
  ],
  [
    'ASCII',
    {
      transport: 'ascii',
      direction: 'request',
      unitId: 0x11,
      functionCode: 3,
      fields: { startAddress: 0x6b, quantity: 3 },
    },
    text(':1103006B00037E\r\n'),
  ],
  [
    'TCP',
    {
      transport: 'tcp',
      direction: 'request',
      unitId: 0xff,
      transactionId: 0x1501,
      functionCode: 4,
      fields: { startAddress: 8, quantity: 1 },
    },
    hex('15 01 00 00 00 06 FF 04 00 08 00 01'),
  ],
  [
    'a WEG drive',
    { transport: 'rtu', direction: 'request', unitId: 6, functionCode: 6, fields: { address: 683, value: 4096 } },
    hex('06 06 02 AB 10 00 F5 E5'),
  ],
  [
    'coils',
    {
      transport: 'rtu',
      direction: 'request',
      unitId: 0x11,
      functionCode: 15,
      fields: { startAddress: 0x13, bits: [1, 0, 1, 1, 0, 0, 1, 1, 1, 0] },
    },
    hex('11 0F 00 13 00 0A 02 CD 01 BF 0B'),
  ],
];

describe('what is sent', () => {
  test.each(printed)('%s: the bytes that are printed', (_, input, bytes) => {
    for (const crc of crcWays) expect(new Planned(input, { crc }).built()).toEqual([...bytes]);
  });

  test('a program sends what the encoder writes, of every function, with every way of the CRC', () => {
    const anyCode = fc.constantFrom(...functionCodes.map(({ code }) => code));
    const anyRequest = fc
      .tuple(anyTransport, anyCode)
      .chain(([transport, code]) => legalFrame(code, transport, 'request'));
    fc.assert(
      fc.property(anyRequest, fc.constantFrom(...crcWays), (input, crc) => {
        expect(new Planned(input, { crc }).built()).toEqual([...encodeFrame(input)]);
      }),
      { numRuns: 50 },
    );
  });
});

describe.each(transports)('replies of %s', (transport) => {
  const cases = programCases(transport, 20);

  test.each(cases)('$name', ({ request: input }) => {
    const planned = new Planned(input);
    const replies = repliesTo(input);
    expect(planned.request.check === undefined).toBe(replies.length === 0);
    expect(planned.built()).toEqual([...encodeFrame(input)]);
    for (const { what, bytes, result, list } of replies) {
      const got = planned.checked(bytes);
      if (result === 'fault') expect({ what, fault: got.result < 0 }).toEqual({ what, fault: true });
      else expect({ what, result: got.result }).toEqual({ what, result });
      if (list !== undefined && result === 0) expect(got.list?.slice(0, list.length)).toEqual([...list]);
    }
  });

  test('a check says good of what the decoder finds no error in, and of nothing else', () => {
    const anyCode = fc.constantFrom(...functionCodes.map(({ code }) => code));
    const exchange = anyCode
      .filter((code) => code !== 0x2b)
      .chain((code) =>
        fc.tuple(legalFrame(code, transport, 'request'), legalFrame(code, transport, 'response'), fc.boolean()),
      );
    fc.assert(
      fc.property(exchange, ([input, other, same]) => {
        const planned = new Planned(input);
        if (planned.request.check === undefined) return;
        const answer = { ...other, unitId: input.unitId, transactionId: input.transactionId };
        const reply = encodeFrame(same ? answer : other);
        const { problems, fields } = decodeFrame(reply, {
          transport,
          direction: 'response',
          request: planned.request.bytes,
        });
        const errors = problems.filter(({ severity }) => severity === 'error').map(({ code }) => code);
        const { result } = planned.checked(reply);
        if (errors.length > 0) expect({ errors, result, fault: result < 0 }).toEqual({ errors, result, fault: true });
        else expect(result).toBe(fields['exceptionCode'] ?? 0);
      }),
      { numRuns: 50 },
    );
  });

  test('the bytes that are wanted never go beyond the reply, and reach its end', () => {
    for (const { request: input } of cases) {
      const planned = new Planned(input);
      for (const { what, bytes } of repliesTo(input)) {
        if (what !== 'good' && what !== 'exception') continue;
        let length = 0;
        for (let turn = 0; turn < 600; turn++) {
          const wanted = planned.wanted(bytes, length);
          if (wanted === 0 || wanted === length) break;
          expect(wanted).toBeGreaterThan(length);
          expect(wanted).toBeLessThanOrEqual(bytes.length);
          length = wanted;
        }
        if (planned.wanted(bytes, length) !== 0) expect(length).toBe(bytes.length);
      }
    }
  });
});
