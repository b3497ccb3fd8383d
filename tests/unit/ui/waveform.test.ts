import fc from 'fast-check';
import type { ComponentChildren, VNode } from 'preact';
import { beforeAll, describe, expect, test } from 'vitest';
import { decodeFrame, fromHex, readSerialFormat, type SerialFormat, serialFormats } from '../../../src/modbus/index.ts';
import type { PictureTexts } from '../../../src/ui/parts/frame-tabs/wire/picture/drawing.ts';
import { Picture } from '../../../src/ui/parts/frame-tabs/wire/picture/picture.tsx';
import { languages } from '../../../src/words/index.ts';
import type { LevelKind, StripView } from '../../../src/workbench/wire/geometry.ts';
import { type Scene, sceneOf, sceneOrigin } from '../../../src/workbench/wire/scene.ts';

let words: PictureTexts;

beforeAll(async () => {
  words = { ...(await languages.en.wire()), ...(await languages.en.page()) };
});

type Element = VNode<Record<string, unknown>>;

/** All elements of a picture: its components are functions of what they are given. */
function elementsOf(children: ComponentChildren): Element[] {
  if (Array.isArray(children)) return children.flatMap(elementsOf);
  if (typeof children !== 'object' || children === null) return [];
  const element = children as Element;
  if (typeof element.type === 'function') {
    return elementsOf((element.type as (props: unknown) => ComponentChildren)(element.props));
  }
  return [element, ...elementsOf(element.props['children'] as ComponentChildren)];
}

interface Segment {
  readonly from: number;
  readonly to: number;
  readonly y: number;
}

/** The level lines of a path made of M, H and V. */
function segmentsOf(d: string): Segment[] {
  const segments: Segment[] = [];
  let [x, y] = [0, 0];
  for (const [, command, first, second] of d.matchAll(/([MHV])(-?[\d.]+)(?: (-?[\d.]+))?/g)) {
    if (command === 'V') y = Number(first);
    else {
      if (command === 'H') segments.push({ from: x, to: Number(first), y });
      x = Number(first);
      if (second !== undefined) y = Number(second);
    }
  }
  return segments;
}

/** The height of a track's curve at places, from its paths alone. */
function heightsAt(elements: readonly Element[], track: string, places: readonly number[]): (number | undefined)[] {
  const segments = elements
    .filter(({ type, props }) => type === 'path' && props['class'] === 'wave' && props['data-track'] === track)
    .flatMap(({ props }) => segmentsOf(String(props['d'])));
  return places.map((place) => segments.find(({ from, to }) => from <= place && place < to)?.y);
}

/** A scene of one frame; the view has the whole of it at 10 pixels a bit. */
function sceneWith(bytes: Uint8Array, format: SerialFormat, gap?: Scene['gap']): { scene: Scene; view: StripView } {
  const reading = decodeFrame(bytes, { transport: 'rtu', direction: 'request' });
  const serial = { baud: 9600, ...format };
  const scene = sceneOf([{ bytes, reading, current: true }], { serial, delay: 0, gap });
  return { scene, view: { from: 0, px: 10, width: 10 * scene.line.end } };
}

const draw = (scene: Scene, view: StripView, kind: LevelKind) => elementsOf(Picture({ scene, view, kind, words }));

/**
 * The bytes that a track shows: the first start bit is where the curve first leaves its height at the left, and the next is
 * looked for behind the last stop bit.
 */
function bytesIn(elements: readonly Element[], track: string, { width }: StripView, format: SerialFormat): number[] {
  const places = Array.from({ length: Math.floor(width * 2) }, (_, index) => index / 2 + 0.01);
  const heights = heightsAt(elements, track, places);
  const idle = heights[0];
  const bytes: number[] = [];
  const checked = format.parity === 'none' ? 0 : 1;
  for (let at = 0; at < heights.length; at++) {
    if (heights[at] === idle || heights[at] === undefined) continue;
    // Half a bit is 5 pixels, which are 10 places.
    const bit = (index: number) => (heights[at + 10 + 20 * index] === idle ? 1 : 0);
    const data = Array.from({ length: format.dataBits }, (_, index) => bit(1 + index));
    if (checked) {
      const ones = data.reduce<number>((sum, each) => sum + each, 0) + bit(1 + format.dataBits);
      expect(ones % 2).toBe(format.parity === 'odd' ? 1 : 0);
    }
    for (let stop = 0; stop < format.stopBits; stop++) expect(bit(1 + format.dataBits + checked + stop)).toBe(1);
    bytes.push(data.reduce<number>((value, each, index) => value + each * 2 ** index, 0));
    at += 20 * (1 + format.dataBits + checked + format.stopBits) - 2;
  }
  return bytes;
}

const request = fromHex('0103006B00037417')!;

describe('the waveform', () => {
  test('holds the bytes of the frame, in every format and at all levels', () => {
    for (const format of serialFormats) {
      const { scene, view } = sceneWith(request, format);
      const expected = Array.from(request, (value) => value % 2 ** format.dataBits);
      for (const [kind, tracks] of [
        ['rs485', ['d1', 'd0']],
        ['rs232', ['rs232']],
        ['ttl', ['ttl']],
      ] as const) {
        const elements = draw(scene, view, kind);
        for (const track of tracks) expect(bytesIn(elements, track, view, format)).toEqual(expected);
      }
    }
  });

  test('holds any bytes, with and without a gap', () => {
    fc.assert(
      fc.property(
        fc.uint8Array({ minLength: 1, maxLength: 12 }),
        fc.constantFrom(...serialFormats),
        fc.record({ after: fc.integer({ min: 1, max: 11 }), time: fc.integer({ min: 0, max: 5000 }) }),
        (bytes, format, gap) => {
          const { scene, view } = sceneWith(bytes, format, gap);
          expect(bytesIn(draw(scene, view, 'ttl'), 'ttl', view, format)).toEqual(
            Array.from(bytes, (value) => value % 2 ** format.dataBits),
          );
        },
      ),
      { numRuns: 40 },
    );
  });

  test('is idle high on D1 and TTL, low on D0 and RS-232', () => {
    const { scene, view } = sceneWith(fromHex('00')!, readSerialFormat('8N1')!);
    const start = (sceneOrigin(scene) + 0.5) * view.px;
    const below = (kind: LevelKind, track: string) => {
      const [idle, low] = heightsAt(draw(scene, view, kind), track, [1, start]);
      return idle! < low!;
    };
    // The y of an SVG grows downwards.
    expect(below('rs485', 'd1')).toBe(true);
    expect(below('rs485', 'd0')).toBe(false);
    expect(below('rs232', 'rs232')).toBe(false);
    expect(below('ttl', 'ttl')).toBe(true);
  });

  test('has no line through the name of a measure, however it is zoomed', () => {
    const { scene } = sceneWith(request, readSerialFormat('8E1')!);
    for (const px of [4, 8, 16, 60]) {
      for (const from of [0, sceneOrigin(scene) + 3, sceneOrigin(scene) + 40]) {
        const measures = draw(scene, { from, px, width: 800 }, 'ttl').filter(
          ({ props }) => props['class'] === 'measure',
        );
        for (const { props } of measures) {
          const parts = elementsOf(props['children'] as ComponentChildren);
          const name = parts.find(({ type }) => type === 'text');
          const path = String(parts.find(({ type }) => type === 'path')?.props['d']);
          if (name === undefined) continue;
          const x = Number(name.props['x']);
          // A letter is five pixels wide at least.
          const half = (String(name.props['children']).length * 5) / 2;
          const level = segmentsOf(path).filter(({ y }) => Math.abs(y - Number(name.props['y'])) < 8);
          expect(level.filter((line) => line.from < x + half && line.to > x - half)).toEqual([]);
        }
      }
    }
  });

  test('shows the pair of a byte of which one bit fills the picture', () => {
    const { scene } = sceneWith(request, readSerialFormat('8E1')!);
    // The last bits of byte 3, 6B.
    const view = { from: sceneOrigin(scene) + 3 * 11 + 8, px: 300, width: 800 };
    const pairs = draw(scene, view, 'ttl').filter(({ props }) => props['class'] === 'pair');
    expect(pairs.map(({ props }) => props['children'])).toEqual(['6B']);
    expect(Number(pairs[0]!.props['x'])).toBeGreaterThan(0);
    expect(Number(pairs[0]!.props['x'])).toBeLessThan(800);
  });

  test('draws what is in sight and no more, in time linear in that', () => {
    const long = Uint8Array.from({ length: 255 }, (_, index) => index);
    const { scene } = sceneWith(long, readSerialFormat('8E1')!);
    const groups = (view: StripView) =>
      draw(scene, view, 'ttl')
        .filter(({ props }) => props['class'] === 'character')
        .map(({ props }) => props['data-from']);
    const tenth = sceneOrigin(scene) + 10 * 11;
    expect(groups({ from: tenth + 5, px: 20, width: 400 })).toEqual([10, 11, 12]);
    // Where a bit has less than a pixel, fields stand for their bytes.
    const all = draw(scene, { from: 0, px: 0.4, width: 0.4 * scene.line.end }, 'ttl');
    expect(all.filter(({ props }) => props['class'] === 'character')).toEqual([]);
    expect(all.filter(({ props }) => props['class'] === 'block').length).toBe(scene.sent[0]!.reading.spans.length);
  });

  test('measures the silences of RTU: at 9600 baud 8E1, and the fixed ones above 19200', () => {
    const bytes = request;
    const reading = decodeFrame(bytes, { transport: 'rtu', direction: 'request' });
    const textOf = (baud: number) => {
      const scene = sceneOf([{ bytes, reading, current: true }], {
        serial: { baud, ...readSerialFormat('8E1')! },
        delay: 0,
        gap: undefined,
      });
      const view = { from: 0, px: 10, width: 10 * scene.line.end };
      const measures = draw(scene, view, 'ttl').filter(({ props }) => props['class'] === 'measure');
      return measures.flatMap(({ props }) =>
        elementsOf(props['children'] as ComponentChildren)
          .filter(({ type }) => type === 'text')
          .map(({ props: { children } }) => String(children)),
      );
    };
    expect(textOf(9600)).toEqual(['Request, 8 bytes, 9.167 ms', 't3.5 4.01 ms', 't1.5 1.719 ms', 't3.5 4.01 ms']);
    expect(textOf(115_200)).toEqual(['Request, 8 bytes, 763.9 µs', 't3.5 1.75 ms', 't1.5 750 µs', 't3.5 1.75 ms']);
  });
});
