import { describe, expect, it } from 'vitest';
import { checkedBytes } from '../../../../src/workbench/checksum/checked-bytes.ts';
import { type Draft, firstDraft } from '../../../../src/workbench/frame/draft.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { hex } from '../../modbus/frames.ts';

const of = (draft: Partial<Draft>) => checkedBytes(evaluate({ ...firstDraft, ...draft }));
/** The example of AP 6.3, by unit 17. */
const texts = { unitId: '17', functionCode: '3', startAddress: '0x6B', quantity: '3' };
const body = hex('11 03 00 6B 00 03');

describe('the bytes that a checksum is taken over', () => {
  it('are those of an RTU frame before its CRC, right or forced', () => {
    expect(of({ texts })).toEqual({ body, whole: hex('11 03 00 6B 00 03 76 87') });
    expect(of({ texts, force: { checksum: '0x1234' } })).toEqual({ body, whole: hex('11 03 00 6B 00 03 34 12') });
  });

  it('are the bytes that the characters of ASCII carry, and the unit and PDU of TCP', () => {
    expect(of({ texts, transport: 'ascii' })?.body).toEqual(body);
    expect(of({ texts, transport: 'tcp' })?.body).toEqual(body);
    expect(of({ texts, transport: 'tcp' })?.whole).toEqual(hex('00 01 00 00 00 06 11 03 00 6B 00 03'));
  });

  it('are all bytes of a bare PDU', () => {
    const pdu = hex('03 00 6B 00 03');
    expect(of({ texts, transport: 'pdu' })).toEqual({ body: pdu, whole: pdu });
  });

  it('do not depend on the length of the frame', () => {
    const silent = { ...texts, functionCode: '17' };
    expect(of({ texts: silent })).toEqual({ body: hex('11 11'), whole: hex('11 11 CD EC') });
    expect(of({ texts: silent, transport: 'ascii' })?.body).toEqual(hex('11 11'));
  });

  it('are unknown if there is no frame', () => {
    expect(of({ texts: { ...texts, quantity: 'many' } })).toBeUndefined();
  });
});
