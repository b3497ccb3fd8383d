import { describe, expect, test } from 'vitest';
import { characterBits, decodeFrame, fromHex, readSerialFormat } from '../../../../src/modbus/index.ts';
import { languages } from '../../../../src/words/index.ts';
import { bitsText, describeScene, fieldShortName, frameText } from '../../../../src/workbench/wire/picture-text.ts';
import { sceneOf } from '../../../../src/workbench/wire/scene.ts';

const en = await languages.en.page();

const words = await languages.en.wire();
const frame = (hex: string, direction: 'request' | 'response', current: boolean) => {
  const bytes = fromHex(hex)!;
  return { bytes, reading: decodeFrame(bytes, { transport: 'rtu', direction }), current };
};
const scene = sceneOf(
  [
    frame('0103006B00037417', 'request', true),
    frame('01030602 2B0000 0064 05 7A'.replaceAll(' ', ''), 'response', false),
  ],
  { serial: { baud: 19_200, ...readSerialFormat('8E1')! }, delay: 5000, gap: undefined },
);

describe('what a picture of a line says', () => {
  test('names its frames with their times', () => {
    // 8 and 11 characters of 11 bits at 19200 baud.
    expect(frameText(scene, 0, words)).toBe('Request, 8 bytes, 4.583 ms');
    expect(frameText(scene, 2, words)).toBe('');
    expect(describeScene(scene, words)).toBe(
      'Waveform of a serial line, 19200 8E1: Request, 8 bytes, 4.583 ms; Reply, 11 bytes, 6.302 ms.',
    );
  });

  test('has short names for fields, and their labels in lower case otherwise', () => {
    const names = scene.sent[0]!.reading.spans.map((span) => fieldShortName(span, en));
    expect(names).toEqual(['unit', 'function', 'address', 'quantity', 'checksum']);
    const span = { ...scene.sent[0]!.reading.spans[0]!, name: 'x' };
    expect(fieldShortName(span, { labels: { x: 'Some Field' }, short: {} })).toBe('some field');
    expect(fieldShortName(span, { labels: {}, short: {} })).toBe('x');
  });

  test('groups bits by what they are', () => {
    // 6B = 0110 1011, sent lowest bit first, has five ones: the even parity bit is 1.
    expect(bitsText(characterBits(0x6b, readSerialFormat('8E1')!))).toBe('0 11010110 1 1');
    expect(bitsText(characterBits(0x3a, readSerialFormat('7E1')!))).toBe('0 0101110 0 1');
    expect(bitsText(characterBits(0x01, readSerialFormat('8N2')!))).toBe('0 10000000 11');
  });
});
