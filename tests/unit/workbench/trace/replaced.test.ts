import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readCapture } from '../../../../src/captures/index.ts';
import { encodeFrame } from '../../../../src/modbus/index.ts';
import { type TraceInput, traceOf } from '../../../../src/trace/index.ts';
import { demoLog, replacedTrace, timeCell, traceCsvLines } from '../../../../src/workbench/index.ts';
import { hex } from '../../captures/wire.ts';

const place = { kind: 'text', from: 0, to: 0 } as const;
const ascii = (text: string) => new TextEncoder().encode(text);
const all = { units: true, addresses: true, times: true };

describe('replaced', () => {
  it('units are numbered, a broadcast stays one, and addresses count from the lowest of their table', () => {
    const frames = [
      '11 03 006B 0003 7687',
      '11 03 06 AE41 5652 4340 49AD',
      '00 06 0001 0003 99DA',
      '06 03 006B 0001 F461',
    ];
    const made = replacedTrace(traceOf(frames.map((text) => ({ bytes: hex(text), place }))), all);
    const bytes = [0, 1, 2, 3].map((index) => Array.from(made.bytes(index)));
    // 0x6B - 1 = 0x6A; the checksums are those of the changed bytes (SL App. B).
    expect(bytes.map((list) => list.slice(0, -2))).toEqual([
      [1, 3, 0, 0x6a, 0, 3],
      [1, 3, 6, 0xae, 0x41, 0x56, 0x52, 0x43, 0x40],
      [0, 6, 0, 0, 0, 3],
      [2, 3, 0, 0x6a, 0, 1],
    ]);
    expect(made.summary().faults).toMatchObject({ checksum: 0, 'no-reply': 1 });
  });

  it('in ASCII the digits change, and the LRC', () => {
    const trace = traceOf([{ bytes: ascii(':1103006B00037E\r\n'), place }]);
    expect(new TextDecoder().decode(replacedTrace(trace, all).bytes(0))).toBe(':010300000003F9\r\n');
  });

  it('on TCP the ends of the connection are others, and times begin at 0', () => {
    const [from, to] = ['10.1.2.3:50000', '10.1.2.9:502'];
    const bytes = hex('0001 0000 0006 11 03 006B 0003');
    const trace = traceOf([
      { bytes, from, to, time: 7e12, side: 'request', transport: 'tcp', place },
      { bytes, from, to, time: 7e12 + 5, side: 'request', transport: 'tcp', place },
    ]);
    expect(replacedTrace(trace, all).plain(1)).toEqual({
      bytes: hex('0001 0000 0006 01 03 0000 0003'),
      from: '192.0.2.1:49152',
      to: '192.0.2.2:502',
      time: 5,
      side: 'request',
      transport: 'tcp',
      place,
    });
    expect(replacedTrace(trace, {}).plain(1)).toEqual(trace.plain(1));
  });

  it.each([
    // A reply with the unit as its identifier of the server (AP 6.13), whose first two bytes are lost: unit 72 looks like function 72.
    ['the end of a frame', ['20 48 B0 A0 20 CA 58', '02 48 FF 16 B2'], '00 41 00'],
    // The end of a mask write (AP 6.16) to 0x0003, which looks like a request of function 03 whose CRC is wrong.
    [
      'the end of a frame that looks like another',
      ['06 03 0003 0001 75BD', '00 03 00F2 0025 661F'],
      '00 41 00 00 00 00',
    ],
    ['two frames in one', ['11 03 006B 0003 7687', '11 03 006B 0003 7687 11 03 006B 0003 7687'], '00 00 00 00'],
    ['no colon', [':1103006B00037E\r\n', '>1103006B00037E\r\n'], '303030303030303030303030303031 0D0A'],
  ])('nothing is left of what is damaged and not confirmed: %s', (_, frames, expected) => {
    const trace = traceOf(
      frames.map((text) => {
        const transport = /[:>]/.test(text) ? 'ascii' : 'rtu';
        return { bytes: transport === 'ascii' ? ascii(text) : hex(text), transport, side: 'request', place } as const;
      }),
    );
    const made = Buffer.from(replacedTrace(trace, all).bytes(1)).toString('hex');
    expect(made).toMatch(new RegExp(`^${expected.replace(/ /g, '').toLowerCase()}`));
  });

  it('a damaged reply that its request confirms stays as it is', () => {
    const trace = traceOf([
      { bytes: hex('11 03 006B 0003 7687'), transport: 'rtu', side: 'request', place },
      // A bit of 0x5652 is another.
      { bytes: hex('11 03 06 AE41 5653 4340 49AD'), transport: 'rtu', side: 'response', place },
    ]);
    const made = replacedTrace(trace, all);
    expect(Array.from(made.bytes(1)).slice(0, -2)).toEqual([1, 3, 6, 0xae, 0x41, 0x56, 0x53, 0x43, 0x40]);
    expect(made.summary().faults).toEqual(trace.summary().faults);
  });

  it('everything that is wrong is still wrong, in the same way', () => {
    const kinds = (trace: ReturnType<typeof traceOf>) =>
      trace.exchanges(0, trace.exchangeCount).map(({ faults }) => faults.map(({ kind, code }) => [kind, code]));
    const demo = traceOf(readCapture(ascii(demoLog())).records);
    expect(kinds(replacedTrace(demo, all))).toEqual(kinds(demo));
    const anyInput = fc
      .record({
        unit: fc.nat(247),
        address: fc.nat(60_000),
        flip: fc.option(fc.nat(63)),
        transport: fc.constantFrom('rtu', 'ascii'),
      })
      .map(({ unit, address, flip, transport }): TraceInput => {
        const fields = { startAddress: address, quantity: 3 };
        const frame = encodeFrame({ transport, direction: 'request', unitId: unit, functionCode: 3, fields });
        // Only the checksum is damaged: other damage may make another address.
        if (flip !== null && transport === 'rtu') frame[6] = (frame[6] ?? 0) ^ (1 << (flip % 8));
        return { bytes: frame, transport, side: 'request', place };
      });
    fc.assert(
      fc.property(fc.array(anyInput, { maxLength: 20 }), (inputs) => {
        const trace = traceOf(inputs);
        const made = replacedTrace(trace, all);
        expect(made.summary().faults).toEqual(trace.summary().faults);
        inputs.forEach((_, index) => {
          expect(made.bytes(index)).toHaveLength(trace.bytes(index).length);
        });
      }),
    );
  });

  it('any bytes stay as many, and nothing throws', () => {
    const anyRecord = fc.record({
      bytes: fc.uint8Array({ maxLength: 40 }),
      transport: fc.constantFrom('rtu', 'ascii', 'tcp'),
      side: fc.constantFrom('request', 'response'),
    });
    fc.assert(
      fc.property(fc.array(anyRecord, { maxLength: 10 }), (inputs) => {
        const made = replacedTrace(traceOf(inputs), all);
        expect(inputs.map((_, index) => made.bytes(index).length)).toEqual(inputs.map(({ bytes }) => bytes.length));
      }),
    );
  });
});

describe('as a table', () => {
  it('has a row for each frame, its sentence in quotes where it needs them', () => {
    const trace = traceOf([
      { bytes: hex('11 03 006B 0003 7687'), time: Date.UTC(2026, 10, 30, 10, 31) * 1000 + 250, place },
    ]);
    expect([...traceCsvLines(trace, [0], ({ unit }) => `=SUM(A1),\nunit ${unit}`)]).toEqual([
      'number,time,side,transport,from,to,unit,function,exception,address,quantity,reply_ms,faults,known,says,bytes\r\n',
      `1,2026-11-30T10:31:00.000250Z,request,rtu,,,17,3,,107,3,,no-reply,,"'=SUM(A1), unit 17",11 03 00 6B 00 03 76 87\r\n`,
    ]);
  });

  it('has seconds where no date is known', () => {
    expect([timeCell(undefined), timeCell(0), timeCell(12_345_678)]).toEqual(['', '0.000000', '12.345678']);
  });
});
