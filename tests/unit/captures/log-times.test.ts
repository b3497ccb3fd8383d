import { describe, expect, it, test } from 'vitest';
import { type Capture, readCapture } from '../../../src/captures/index.ts';
import { toHex } from '../../../src/modbus/index.ts';
import { dialects, said, write } from '../notation/dialects.ts';

const read = (text: string): Capture => readCapture(new TextEncoder().encode(text));
/** Each frame with its side, and how many milliseconds after the first it came. */
function told({ records }: Capture): (readonly [string | undefined, string, number])[] {
  const all = Array.from(records);
  const first = all[0]?.time ?? 0;
  return all.map(({ side, bytes, time = Number.NaN }) => [side, toHex(bytes), Math.round((time - first) / 1000)]);
}

describe('the times of a log, in milliseconds', () => {
  test.each(dialects.filter(([, { timed }]) => timed === true))('%s', (_, dialect) => {
    const { text, chunks } = write(dialect, said);
    const first = chunks[0]?.time ?? 0;
    const expected = chunks.map(({ bytes, time }, index) => [
      index % 2 === 0 ? 'request' : 'response',
      toHex(bytes),
      (time - first) / 1000,
    ]);
    expect(told(read(text)), text).toEqual(expected);
  });
});

describe('bytes one by one, as a logic analyser exports them, are parted into frames by their times', () => {
  const starts = [0.5, 0.543, 1.5, 1.562, 2.6, 2.639];
  const each = (line: (seconds: number, byte: string, side: string) => string) =>
    said.flatMap(({ bytes, side }, frame) =>
      Array.from(bytes, (byte, index) =>
        line((starts[frame] ?? 0) + index * 0.00104, toHex(Uint8Array.of(byte)), side),
      ),
    );
  const expected = said.map(({ bytes }, index) => [
    index % 2 === 0 ? 'request' : 'response',
    toHex(bytes),
    Math.round(((starts[index] ?? 0) - 0.5) * 1000),
  ]);

  it.each([
    [
      'with a column of values',
      ['Time [s],Value,Parity Error,Framing Error', ...each((at, byte) => `${at.toFixed(15)},0x${byte},,`)],
    ],
    [
      'with a duration behind the time, of one wire',
      [
        'name,type,start_time,duration,data,error',
        ...each((at, byte) => `"Async Serial","data",${at.toFixed(9)},0.000885,0x${byte},`),
      ],
    ],
    [
      'of a wire for each direction',
      [
        'name,type,start_time,duration,data,error',
        ...each((at, byte, side) => `"${side.toUpperCase()}","data",${at.toFixed(9)},0.000885,0x${byte},`),
      ],
    ],
  ])('%s', (_, lines) => {
    expect(told(read(lines.join('\n')))).toEqual(expected);
  });
});

describe('no frame is seen in a log of something else', () => {
  it.each([
    ['a web server', '192.0.2.2 - - [02/Jan/2024:10:31:01 +0100] "GET /api/1/03 HTTP/1.1" 200 1103 "-" "curl/7.88"'],
    ['an ESP32', '[ 1854][D][WiFiGeneric.cpp:1040] _eventCallback(): Arduino Event: 7 - STA_GOT_IP'],
    ['modpoll', '[100]: 235\n[101]: 1200\n[102]: 17'],
    ['packets without their bytes', '1 0.0 192.0.2.1 -> 192.0.2.2 Modbus/TCP 66 Query: Trans: 1; Unit: 1, Func: 3'],
  ])('%s', (_, line) => {
    expect(told(read(`${line}\n${line}\n`))).toEqual([]);
  });
});
