import { describe, expect, it } from 'vitest';
import { readCapture } from '../../../src/captures/index.ts';
import { traceOf } from '../../../src/trace/index.ts';

const read = (text: string) => readCapture(new TextEncoder().encode(text));
const shown = (text: string) =>
  Array.from(read(text).records, ({ bytes, time, side, transport, known }) => [
    Buffer.from(bytes).toString('hex'),
    time,
    side,
    transport,
    known,
  ]);
const HEAD = 'number,time,direction,transport,kind,bytes,answers,duration_ms,verdict';

describe('a table that this page has saved', () => {
  it('is read as records, with what the session knew', () => {
    const text = [
      HEAD,
      '1,2025-11-30T04:31:55.123Z,sent,rtu,request,01 03 00 6B 00 03 74 17,,12.3,doubtful',
      '2,2025-11-30T04:31:55.135Z,received,rtu,reply,01 03 06 02 2B 00 00 00 64 05 7A,1,,',
      '3,2025-11-30T04:31:56.135Z,received,rtu,noise,FF 00,,,',
      '4,2025-11-30T04:31:57.135Z,received,rtu,heard,01 03 00 6B 00 03 74 17,,,',
      '',
    ].join('\r\n');
    expect(read(text).format).toBe('csv');
    const time = 1000 * Date.UTC(2025, 10, 30, 4, 31, 55, 123);
    expect(shown(text)).toEqual([
      ['0103006b00037417', time, 'request', 'rtu', { outcome: 'doubtful' }],
      ['010306022b00000064057a', time + 12_000, 'response', 'rtu', undefined],
      ['ff00', time + 1_012_000, 'response', 'rtu', { beside: 'noise' }],
      ['0103006b00037417', time + 2_012_000, undefined, 'rtu', undefined],
    ]);
    const { faults } = traceOf(read(text).records).summary();
    expect([faults.doubtful, faults.broken, faults.stray]).toEqual([1, 1, 0]);
  });

  it('has been through a spreadsheet, or has the columns of a trace', () => {
    const text = 'time;side;bytes;says\n"0,5";response;"01 83 02 C0 F1";"a; b"\n;;;\n1;other;zz;\n';
    expect(shown(text)).toEqual([['018302c0f1', 500_000, 'response', 'rtu', undefined]]);
    const micro = 'time,side,transport,from,to,bytes\n1970-01-02T00:00:00.000001Z,request,tcp,a,b,01 02\n';
    expect(shown(micro)[0]?.slice(1, 4)).toEqual([86_400_000_001, 'request', 'tcp']);
  });

  it('has every line of a log of the bus', () => {
    const line = '1,1970-01-01T00:00:00.005Z,sent,ascii,echo,3A 0D 0A,,,\r\n';
    expect(shown(`${HEAD}\r\n${line}${line}`)).toEqual(
      Array.from({ length: 2 }, () => ['3a0d0a', 5000, 'request', 'ascii', { beside: 'echo' }]),
    );
  });

  it.each(['time and bytes, in a direction', 'time,bytes\n1,01 02', '01 03 00 6B 00 03 74 17'])(
    'is not any text: %s',
    (text) => expect(read(text).format).toBe('text'),
  );
});
