import { describe, expect, it } from 'vitest';
import { firstDraft } from '../../../../src/workbench/frame/draft.ts';
import { exchangeSizes } from '../../../../src/workbench/timing/exchange-sizes.ts';

const request = (texts: Readonly<Record<string, string>>) => ({ ...firstDraft, texts });

describe('the sizes of the current exchange', () => {
  it('is counted in bytes of RTU and in characters of ASCII', () => {
    // 11 03 00 6B 00 03 76 87, answered by 11 03 06 and six bytes of registers, CRC
    const read = request({ unitId: '17', functionCode: '3', startAddress: '0x6B', quantity: '3' });
    expect(exchangeSizes(read, 'rtu')).toEqual({ request: 8, reply: 11, source: 'known' });
    // :1103006B00037E CR LF, answered by : 11 03 06, 12 digits, LRC, CR LF
    expect(exchangeSizes(read, 'ascii')).toEqual({ request: 17, reply: 23, source: 'known' });
    expect(exchangeSizes({ ...read, transport: 'tcp' }, 'rtu')).toEqual({ request: 8, reply: 11, source: 'known' });
  });

  it('has no reply to a broadcast', () => {
    const broadcast = request({ unitId: '0', functionCode: '6', address: '1', value: '3' });
    expect(exchangeSizes(broadcast, 'rtu')).toEqual({ request: 8, reply: 0, source: 'broadcast' });
  });

  it('does not know a reply that only the device knows', () => {
    expect(exchangeSizes(request({ unitId: '1', functionCode: '17' }), 'rtu')).toMatchObject({
      request: 4, // 01 11 C0 2C
      source: 'open',
    });
  });

  it('takes the current reply, and the request it answers where that is known', () => {
    const reply = {
      ...firstDraft,
      kind: 'reply',
      texts: { unitId: '17', functionCode: '3', registers: '0xAE41 0x5652 0x4340' },
    } as const;
    expect(exchangeSizes(reply, 'rtu')).toEqual({ request: undefined, reply: 11, source: 'current' });
    const answering = { ...reply, answering: '11 03 00 6B 00 03 76 87' };
    expect(exchangeSizes(answering, 'rtu')).toEqual({ request: 8, reply: 11, source: 'current' });
    expect(exchangeSizes({ ...answering, kind: 'exception' }, 'rtu')).toMatchObject({ request: 8, reply: 5 });
  });

  it('says so where there is no frame', () => {
    const wrong = request({ unitId: '17', functionCode: '6', address: 'abc', value: '1' });
    expect(exchangeSizes(wrong, 'rtu')).toEqual({ request: undefined, reply: undefined, source: 'none' });
  });
});
