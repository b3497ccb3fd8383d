import { describe, expect, test } from 'vitest';
import { decodeFrame, fromHex, readSerialFormat, toHex } from '../../../../src/modbus/index.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { readLink } from '../../../../src/workbench/frame/link.ts';
import {
  bytesDuring,
  exchangeOf,
  gapEffectOf,
  type Scene,
  sceneOf,
  sceneTime,
} from '../../../../src/workbench/wire/scene.ts';

describe('the exchange on a line', () => {
  const shown = (hash: string) => {
    const draft = readLink(hash)!.draft;
    const sent = exchangeOf({ draft, frame: evaluate(draft).frame! });
    return sent.map(({ bytes, reading, current }) => [reading.direction, toHex(bytes), current]);
  };

  test('is a request and its expected reply, or a reply and the request it answers', () => {
    expect(shown('#rtu/request?unitId=17&functionCode=6&address=1&value=3')).toEqual([
      ['request', '1106000100039A9B', true],
      ['response', '1106000100039A9B', false],
    ]);
    expect(shown('#rtu/reply?unitId=17&functionCode=6&address=1&value=3&answering=1106000100039A9B')).toEqual([
      ['request', '1106000100039A9B', false],
      ['response', '1106000100039A9B', true],
    ]);
  });

  test('is one frame where nothing answers, or nothing is known of the request', () => {
    expect(shown('#rtu/request?unitId=0&functionCode=6&address=1&value=3').length).toBe(1);
    expect(shown('#rtu/reply?unitId=17&functionCode=6&address=1&value=3').length).toBe(1);
  });
});

/** 01 03 00 6B 00 03 and its CRC, alone on its line. */
function sceneAt(baud: number, format: string, gap?: Scene['gap'], transport: 'rtu' | 'ascii' = 'rtu'): Scene {
  const bytes = fromHex(
    transport === 'rtu' ? '0103006B00037417' : '3A3031303330303642303030333845 0D0A'.replace(' ', ''),
  )!;
  const reading = decodeFrame(bytes, { transport, direction: 'request' });
  const serial = { baud, ...readSerialFormat(format)! };
  return sceneOf([{ bytes, reading, current: true }], { serial, delay: 0, gap });
}

describe('times on a line', () => {
  test('count from the first start bit', () => {
    const scene = sceneAt(9600, '8E1');
    expect(sceneTime(scene, scene.line.characters[0]!.start)).toBe(0);
    // Seven characters of 11 bits at 9600 baud.
    expect(sceneTime(scene, scene.line.characters[7]!.start)).toBeCloseTo(8020.833, 2);
  });

  test('have silences in RTU alone, at 9600 baud 8E1 1719 and 4010 µs', () => {
    const { silences } = sceneAt(9600, '8E1');
    expect([silences!.t15, silences!.t35].map(Math.round)).toEqual([1719, 4010]);
    expect(sceneAt(9600, '7E1', undefined, 'ascii').silences).toBeUndefined();
  });
});

describe('a gap in the current frame', () => {
  test('leaves it whole up to t1.5, makes it doubtful up to t3.5, and then ends it', () => {
    const effect = (time: number) => gapEffectOf(sceneAt(9600, '8E1', { after: 3, time }));
    expect([effect(1700), effect(2000), effect(4100)]).toEqual(['whole', 'discarded', 'two-frames']);
    expect(gapEffectOf(sceneAt(9600, '8E1'))).toBeUndefined();
  });

  test('may last a second in ASCII', () => {
    const effect = (time: number) => gapEffectOf(sceneAt(9600, '7E1', { after: 3, time }, 'ascii'));
    expect([effect(1_000_000), effect(1_000_001)]).toEqual(['whole', 'discarded']);
  });

  test('stands before its byte, and moves those behind it', () => {
    const [plain, gapped] = [sceneAt(9600, '8E1'), sceneAt(9600, '8E1', { after: 3, time: 2000 })];
    const moved = (index: number) =>
      Math.round(
        sceneTime(gapped, gapped.line.characters[index]!.start) - sceneTime(plain, plain.line.characters[index]!.start),
      );
    expect([moved(2), moved(3), moved(7)]).toEqual([0, 2000, 2000]);
  });
});

describe('bytes between two times', () => {
  const scene = sceneAt(9600, '8E1');
  const starts = scene.line.characters.map(({ start }) => start);

  test('are those that were on the line then', () => {
    expect(bytesDuring(scene, starts[2]!, starts[3]!)).toEqual([2, 3]);
    expect(bytesDuring(scene, starts[2]! + 5, starts[4]! + 1)).toEqual([2, 5]);
    expect(bytesDuring(scene, starts[7]!, starts[7]! + 1000)).toEqual([7, 8]);
    expect(bytesDuring(scene, starts[7]! + 1000, starts[7]! + 2000)).toBeUndefined();
  });

  test('are of the field that the reading has there', () => {
    expect(scene.fields[0]!.map((span) => span?.name)).toEqual([
      'unitId',
      'functionCode',
      'startAddress',
      'startAddress',
      'quantity',
      'quantity',
      'checksum',
      'checksum',
    ]);
  });
});
