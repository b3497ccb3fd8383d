import { describe, expect, test } from 'vitest';
import { decodeFrame, fromHex, readSerialFormat } from '../../../../src/modbus/index.ts';
import type { StripView } from '../../../../src/workbench/wire/geometry.ts';
import { sceneOf } from '../../../../src/workbench/wire/scene.ts';
import {
  viewAfter,
  viewAtWidth,
  viewOf,
  viewOfBit,
  viewOfByte,
  viewWithin,
  zoomed,
  zoomTargets,
} from '../../../../src/workbench/wire/zoom.ts';

/** A request of some bytes at 8N1, ten bits a byte, after ten bits of idle line. */
function sceneWith(hex: string) {
  const bytes = fromHex(hex)!;
  const reading = decodeFrame(bytes, { transport: 'rtu', direction: 'request' });
  const serial = { baud: 9600, ...readSerialFormat('8N1')! };
  return sceneOf([{ bytes, reading, current: true }], { serial, delay: 0, gap: undefined });
}

const scene = sceneWith('0103006B00037417');
const { line } = scene;
const start = line.frames[0]!.from;
const nowhere: StripView = { width: 0, px: 0, from: 0 };
const whole = viewOf(scene, { ...nowhere, width: 900 }, 'all');
const end = (view: StripView) => view.from + view.width / view.px;

describe('what is in sight of a line', () => {
  test('is no more than the line', () => {
    expect(whole).toEqual({ width: 900, px: 900 / line.end, from: 0 });
    expect(viewWithin(line, { width: 900, px: 0.001, from: 5 })).toEqual(whole);
    const last = viewWithin(line, { width: 900, px: 20, from: 1e9 });
    expect(end(last)).toBeCloseTo(line.end);
  });

  test('has at most 400 pixels a bit', () => {
    expect(viewWithin(line, { width: 900, px: 4000, from: 0 }).px).toBe(400);
  });

  test('is the same object where nothing changes', () => {
    expect(viewWithin(line, whole)).toBe(whole);
    expect(viewAfter(scene, sceneWith('0103006B00037417'), whole)).toBe(whole);
  });

  test('is the frame at first, with bits of at least four pixels', () => {
    const wide = viewAtWidth(scene, nowhere, 3000);
    expect(wide.from).toBeLessThanOrEqual(start);
    expect(end(wide)).toBeGreaterThanOrEqual(line.frames[0]!.to);
    const narrow = viewAtWidth(scene, nowhere, 200);
    expect(narrow.px).toBe(4);
    // The silence before the frame takes three tenths of the width at most.
    expect((start - narrow.from) * narrow.px).toBeLessThanOrEqual(60 + 1e-9);
  });

  test('stays where it is in another width', () => {
    const view = viewOfByte(scene, whole, 3);
    expect(viewAtWidth(scene, view, 600)).toEqual({ ...view, width: 600 });
  });
});

describe('the zoom', () => {
  test('keeps the time under the pointer in place', () => {
    const at = 300;
    const time = whole.from + at / whole.px;
    const closer = zoomed(line, whole, 1.4, at);
    expect(closer.px).toBeCloseTo(1.4 * whole.px);
    expect(closer.from + at / closer.px).toBeCloseTo(time);
    expect(zoomed(line, whole, 1 / 1.4, at)).toEqual(whole);
  });

  test('shows a byte in the middle, with room for the names of its bits', () => {
    const view = viewOfByte(scene, whole, 3);
    const character = line.characters[3]!;
    expect(view.from + view.width / 2 / view.px).toBeCloseTo((character.start + character.end) / 2);
    expect(view.px).toBe(54); // six tenths of 900 pixels, ten bits
    expect(viewOfByte(scene, { ...whole, width: 100 }, 3).px).toBe(16);
    expect(viewOfByte(scene, whole, 8)).toBe(whole); // there are eight bytes
  });

  test('has the bit that was pointed at in its middle, and its byte large enough to be read', () => {
    const byte = line.characters[3]!;
    const middleOf = (view: StripView) => view.from + view.width / 2 / view.px;
    // In the sixth bit of byte 3, from the whole line and from a view of single bits.
    const at = (view: StripView) => (byte.start + 5.2 - view.from) * view.px;
    const view = viewOfBit(scene, whole, at(whole));
    expect(middleOf(view)).toBeCloseTo(byte.start + 5.5);
    expect(view.px).toBe(16);
    const close = { ...view, px: 100, from: byte.start };
    expect(viewOfBit(scene, close, at(close))).toMatchObject({ px: 100 });
    expect(middleOf(viewOfBit(scene, close, at(close)))).toBeCloseTo(byte.start + 5.5);
    // Beside all bytes nothing moves.
    expect(viewOfBit(scene, whole, 0)).toBe(whole);
  });

  test('goes from the byte in the middle to a bit of it', () => {
    const byte = viewOf(scene, viewOfByte(scene, whole, 3), 'byte');
    expect(byte).toEqual(viewOfByte(scene, whole, 3));
    const bit = viewOf(scene, byte, 'bit');
    const middle = bit.from + bit.width / 2 / bit.px;
    expect(middle % 1).toBeCloseTo(0.5);
    expect(middle).toBeGreaterThan(line.characters[3]!.start);
    expect(middle).toBeLessThan(line.characters[3]!.end);
  });

  test('stays within the line for every target', () => {
    for (const target of zoomTargets) {
      const view = viewOf(scene, zoomed(line, whole, 7), target);
      expect(view.from).toBeGreaterThanOrEqual(0);
      expect(end(view)).toBeLessThanOrEqual(line.end + 1e-9);
    }
  });
});

test('another frame is shown from its beginning, the same one where it was', () => {
  const view = viewOfByte(scene, whole, 7);
  const other = sceneWith('010300');
  expect(viewAfter(scene, other, view)).toEqual(viewOf(other, view, 'first'));
  expect(viewAfter(scene, sceneWith('0103006B00047417'), view)).toBe(view);
});
