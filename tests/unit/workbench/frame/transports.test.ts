import { describe, expect, it } from 'vitest';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { readLink } from '../../../../src/workbench/frame/link.ts';
import { inEveryTransport } from '../../../../src/workbench/frame/transports.ts';

function of(link: string) {
  const { draft } = readLink(link)!;
  return inEveryTransport(draft, evaluate(draft).frame!);
}
const texts = (link: string) => Object.fromEntries(of(link).frames.map(({ transport, text }) => [transport, text]));

describe('one frame in every transport', () => {
  it('is the same PDU in other wrappings', () => {
    // Read 3 holding registers from 107 of unit 17 (AP 6.3); 11 + 03 + 6B + 03 = 82, whose two's complement is 7E.
    expect(texts('#rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3')).toEqual({
      rtu: '11 03 00 6B 00 03 76 87',
      ascii: ':1103006B00037E',
      tcp: '00 01 00 00 00 06 11 03 00 6B 00 03',
      pdu: '03 00 6B 00 03',
    });
  });

  it('is aligned by field, with what changes and what stays', () => {
    const { fields } = of('#tcp/request?transactionId=0x0102&unitId=17&functionCode=3&startAddress=107&quantity=3');
    expect(fields.map(({ name, stays, texts: all }) => [name, stays, ...all])).toEqual([
      ['transactionId', false, undefined, undefined, '01 02', undefined],
      ['protocolId', false, undefined, undefined, '00 00', undefined],
      ['length', false, undefined, undefined, '00 06', undefined],
      ['start', false, undefined, ':', undefined, undefined],
      ['unitId', true, '11', '11', '11', undefined],
      ['functionCode', true, '03', '03', '03', '03'],
      ['startAddress', true, '00 6B', '006B', '00 6B', '00 6B'],
      ['quantity', true, '00 03', '0003', '00 03', '00 03'],
      ['checksum', false, '76 87', '7E', undefined, undefined],
      ['end', false, undefined, 'CRLF', undefined, undefined],
    ]);
    // Bytes of the current frame, which is the one of TCP.
    expect(fields.map(({ from, to }) => [from, to]).slice(2, 6)).toEqual([
      [4, 6],
      [undefined, undefined],
      [6, 7],
      [7, 8],
    ]);
  });

  it('does not carry a wrong checksum into another transport', () => {
    expect(texts('#rtu/request?unitId=6&functionCode=6&address=0x02AB&value=4096&force.checksum=0xA1E6')).toEqual({
      rtu: '06 06 02 AB 10 00 E6 A1',
      // 06 + 06 + 02 + AB + 10 + 00 = C9, whose two's complement is 37.
      ascii: ':060602AB100037',
      tcp: '00 01 00 00 00 06 06 06 02 AB 10 00',
      pdu: '06 02 AB 10 00',
    });
  });

  it('keeps the request that a reply answers, in its own transport', () => {
    const { frames } = of('#rtu/reply?unitId=17&functionCode=3&registers=555+0+100&answering=1103006B00037687');
    expect(frames.map(({ draft }) => draft.answering.replaceAll(' ', ''))).toEqual([
      '1103006B00037687',
      '3A31313033303036423030303337450D0A',
      '0001000000061103006B0003',
      '03006B0003',
    ]);
    expect(frames.map(({ frame }) => frame?.reading.problems)).toEqual([[], [], [], []]);
  });

  it('writes of a long field the beginning', () => {
    const { fields } = of('#rtu/request?unitId=1&functionCode=16&startAddress=0&registers=1+2+3+4+5');
    expect(fields.find(({ name }) => name === 'registers')?.texts).toEqual([
      '00 01 00 02 …',
      '00010002 …',
      '00 01 00 02 …',
      '00 01 00 02 …',
    ]);
  });
});
