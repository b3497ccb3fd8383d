import { describe, expect, it } from 'vitest';
import { framesAtHand } from '../../../src/ui/timing/frame-at-hand.ts';
import { lineOf, textsOf, timeOf } from '../../../src/ui/timing/settings.ts';
import { firstDraft } from '../../../src/workbench/frame/draft.ts';

const request = (texts: Readonly<Record<string, string>>) => ({ ...firstDraft, texts });
const line = lineOf(textsOf(new URLSearchParams('baud=9600&format=8N1')))!;

describe('the exchange of the frame at hand', () => {
  it('is counted in bytes of RTU and in characters of ASCII', () => {
    // 11 03 00 6B 00 03 76 87, answered by 11 03 06 and six bytes of registers, CRC
    const read = request({ unitId: '17', functionCode: '3', startAddress: '0x6B', quantity: '3' });
    expect(framesAtHand(read, 'rtu')).toEqual({ request: 8, reply: 11, source: 'known' });
    // :1103006B00037E CR LF, answered by : 11 03 06, 12 digits, LRC, CR LF
    expect(framesAtHand(read, 'ascii')).toEqual({ request: 17, reply: 23, source: 'known' });
    expect(framesAtHand({ ...read, transport: 'tcp' }, 'rtu')).toEqual({ request: 8, reply: 11, source: 'known' });
  });

  it('has no reply to a broadcast', () => {
    const broadcast = request({ unitId: '0', functionCode: '6', address: '1', value: '3' });
    expect(framesAtHand(broadcast, 'rtu')).toEqual({ request: 8, reply: 0, source: 'broadcast' });
  });

  it('does not know a reply that only the device knows', () => {
    expect(framesAtHand(request({ unitId: '1', functionCode: '17' }), 'rtu')).toMatchObject({
      request: 4, // 01 11 C0 2C
      source: 'open',
    });
  });

  it('takes a reply at hand, and the request it answers where that is known', () => {
    const reply = {
      ...firstDraft,
      kind: 'reply',
      texts: { unitId: '17', functionCode: '3', registers: '0xAE41 0x5652 0x4340' },
    } as const;
    expect(framesAtHand(reply, 'rtu')).toEqual({ request: undefined, reply: 11, source: 'at-hand' });
    const answering = { ...reply, answering: '11 03 00 6B 00 03 76 87' };
    expect(framesAtHand(answering, 'rtu')).toEqual({ request: 8, reply: 11, source: 'at-hand' });
    expect(framesAtHand({ ...answering, kind: 'exception' }, 'rtu')).toMatchObject({ request: 8, reply: 5 });
  });

  it('says so where there is no frame', () => {
    const wrong = request({ unitId: '17', functionCode: '6', address: 'abc', value: '1' });
    expect(framesAtHand(wrong, 'rtu')).toEqual({ request: undefined, reply: undefined, source: 'none' });
  });
});

describe('what is typed', () => {
  it('is a time in microseconds, bits and characters those of the line', () => {
    expect(timeOf('1.5 ms', line)).toEqual({ value: 1500 });
    expect(timeOf('0x10', line)).toEqual({ value: 16_000 });
    expect(timeOf('96 bits', line)).toEqual({ value: 10_000 });
    expect(timeOf('12 chars', line)).toEqual({ value: 12_500 });
    expect(timeOf('3600 s', line)).toEqual({ value: 3.6e9 });
    expect(timeOf('3601 s', line)).toEqual({ error: { code: 'not-a-time', text: '3601 s' } });
    expect(timeOf('soon', line)).toEqual({ error: { code: 'not-a-time', text: 'soon' } });
    expect(timeOf(' ', line)).toEqual({ error: { code: 'field-missing' } });
  });

  it('is a line from 300 to 4,000,000 bits a second', () => {
    const silences = (query: string) => lineOf(textsOf(new URLSearchParams(query)))?.silences;
    expect(silences('baud=300&format=8N1')).toEqual({ t15: 50_000, t35: 116_666.66666666667 });
    expect(silences('baud=300&format=8N1&counted=11')).toEqual({ t15: 55_000, t35: 128_333.33333333333 });
    expect(silences('baud=0x3D0900')).toEqual({ t15: 750, t35: 1750 });
    for (const baud of ['299', '4000001', '9600.5', 'fast', '']) expect(silences(`baud=${baud}`)).toBeUndefined();
  });
});
