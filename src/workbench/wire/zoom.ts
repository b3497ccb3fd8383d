import type { Line } from '../../modbus/index.ts';
import { characterNear, type StripView } from './geometry.ts';
import type { Scene } from './scene.ts';

/** Widest that browsers scroll without losing pixels, and the most pixels of a bit. */
const WIDEST = 16_000_000;
const MOST_BIT = 400;
/** Bits of silence that are shown on either side of a frame. */
const MARGIN = 50;
/** At first a frame fills the width, but bits are no narrower than this. */
const FIRST_BIT = 4;
/** At most this part of the width is the silence before the frame. */
const FIRST_SILENCE = 0.3;
/** Shares of the width that a byte and a bit take. */
const BYTE_SHARE = 0.6;
const BIT_SHARE = 0.3;
/** Pixels of a bit that has room for its name. */
const READABLE_BIT = 16;

/** What fills the view: the line, the current frame, or the byte or bit in the middle. */
export const zoomTargets = ['all', 'frame', 'byte', 'bit'] as const;
export type ZoomTarget = (typeof zoomTargets)[number];

/** The nearest view there is: within the line, and no smaller than what shows all of it. The same object if nothing changes. */
export function viewWithin(line: Line, view: StripView): StripView {
  const { width } = view;
  const px = Math.max(width / line.end, Math.min(MOST_BIT, WIDEST / line.end, view.px));
  const from = Math.max(0, Math.min(line.end - width / px, view.from));
  return px === view.px && from === view.from ? view : { width, px, from };
}

/** Zooms so that the time `at` pixels from the left stays where it is. */
export function zoomed(line: Line, view: StripView, factor: number, at = view.width / 2): StripView {
  const { px } = viewWithin(line, { ...view, px: view.px * factor });
  return viewWithin(line, { ...view, px, from: view.from + at / view.px - at / px });
}

/** The view of a target; `first` is the one to begin with. */
export function viewOf(scene: Scene, view: StripView, target: ZoomTarget | 'first'): StripView {
  const { line, own } = scene;
  const { width } = view;
  const middle = view.from + width / 2 / view.px;
  switch (target) {
    case 'all':
      return viewWithin(line, { width, px: 0, from: 0 });
    case 'bit': {
      const px = Math.min(width * BIT_SHARE, MOST_BIT);
      return centred(line, { width, px, from: 0 }, middleOfBit(line, middle));
    }
    case 'byte': {
      const near = characterNear(line, middle);
      return near ? aroundByte(line, view, near) : view;
    }
    default: {
      const frame = line.frames[own] ?? { from: 0, to: line.end };
      const before = line.quiets.find(({ to }) => to === frame.from)?.from ?? 0;
      const after = line.quiets.find(({ from }) => from === frame.to)?.to ?? line.end;
      const begin = Math.max(before, frame.from - MARGIN);
      const fit = width / (Math.min(after, frame.to + MARGIN) - begin);
      const px = target === 'first' ? Math.max(fit, FIRST_BIT) : fit;
      // Where the silence before it would take most of the width, the frame begins further left.
      return viewWithin(line, { width, px, from: Math.max(begin, frame.from - (FIRST_SILENCE * width) / px) });
    }
  }
}

/** A byte of the current frame in the middle, large enough for its bits to be read. */
export function viewOfByte({ line, own }: Scene, view: StripView, index: number): StripView {
  const character = line.characters.find((each) => each.frame === own && each.index === index);
  return character ? aroundByte(line, view, character) : view;
}

/** The bit `at` pixels from the left in the middle, large enough for its byte to be read; the same view beside all bytes. */
export function viewOfBit({ line }: Scene, view: StripView, at: number): StripView {
  const time = view.from + at / view.px;
  const near = characterNear(line, time);
  if (near === undefined || time < near.start || time >= near.end) return view;
  return centred(line, { ...view, px: Math.max(view.px, READABLE_BIT) }, middleOfBit(line, time));
}

/** The middle of the bit that a time is in. */
function middleOfBit(line: Line, time: number): number {
  const start = characterNear(line, time)?.start ?? 0;
  return start + Math.floor(time - start) + 0.5;
}

const centred = (line: Line, { width, px }: StripView, time: number): StripView =>
  viewWithin(line, { width, px, from: time - width / 2 / px });

function aroundByte(
  line: Line,
  { width }: StripView,
  { start, end }: { readonly start: number; readonly end: number },
) {
  const px = Math.min(Math.max((width * BYTE_SHARE) / (end - start), READABLE_BIT), MOST_BIT);
  return viewWithin(line, { width, px, from: (start + end) / 2 - width / 2 / px });
}

/** The view after the scene has changed: another frame is shown from its beginning, the same on another line stays in place. */
export function viewAfter(before: Scene, scene: Scene, view: StripView): StripView {
  const sizeOf = ({ sent, own }: Scene) => sent[own]?.bytes.length;
  const same = before.own === scene.own && sizeOf(before) === sizeOf(scene);
  return same ? viewWithin(scene.line, view) : viewOf(scene, view, 'first');
}

/** The view in another width; the first one shows what `first` does. */
export const viewAtWidth = (scene: Scene, view: StripView, width: number): StripView =>
  view.width === 0 ? viewOf(scene, { ...view, width }, 'first') : viewWithin(scene.line, { ...view, width });
