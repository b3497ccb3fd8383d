import { type Direction, type FrameAt, framesAt, judgeRtu, nextPlace, RtuScan } from '../modbus/index.ts';

/** Bytes that may be a frame: its checksum holds where its fields end. */
export interface Candidate {
  readonly transport: FrameAt['transport'];
  readonly from: number;
  readonly to: number;
  /** The directions in which it may be one. */
  readonly directions: readonly Direction[];
}

const REQUEST: readonly Direction[] = ['request'];
const RESPONSE: readonly Direction[] = ['response'];
const EITHER: readonly Direction[] = ['request', 'response'];

/** The candidates of this transport, sorted by where they begin. */
export const candidates = (bytes: Uint8Array, transport: FrameAt['transport']): Candidate[] =>
  transport === 'rtu' ? rtuCandidates(bytes) : otherCandidates(bytes, transport);

/** Nothing is searched for inside frames that adjoin another. */
function rtuCandidates(bytes: Uint8Array): Candidate[] {
  const transport = 'rtu';
  const scan = new RtuScan(bytes);
  const found: Candidate[] = [];
  let chained = 0;
  let from = scan.next(0);
  let asked = scan.endAt(from, 'request');
  let answered = scan.endAt(from, 'response');
  while (from < bytes.length) {
    if (asked > 0) found.push({ transport, from, to: asked, directions: asked === answered ? EITHER : REQUEST });
    if (answered > 0 && answered !== asked) found.push({ transport, from, to: answered, directions: RESPONSE });
    const to = asked === 0 || asked === answered ? answered : answered === 0 ? asked : 0;
    if (to > 0) {
      asked = scan.endAt(to, 'request');
      answered = scan.endAt(to, 'response');
      if (asked > 0 || answered > 0) {
        from = to;
        chained = to;
        continue;
      }
    }
    from = scan.next(to > 0 && from === chained ? to : from + 1);
    asked = scan.endAt(from, 'request');
    answered = scan.endAt(from, 'response');
  }
  return found;
}

function otherCandidates(bytes: Uint8Array, transport: 'ascii' | 'tcp'): Candidate[] {
  const found: Candidate[] = [];
  for (let from = nextPlace(bytes, 0, transport); from < bytes.length; from = nextPlace(bytes, from + 1, transport)) {
    // Both directions end at the same place: by the MBAP's length, or at CR LF.
    const frames = framesAt(bytes, from, bytes.length, transport);
    const [first, second] = [frames[0], frames[1]];
    if (first === undefined) continue;
    const directions = second === undefined ? (first.direction === 'request' ? REQUEST : RESPONSE) : EITHER;
    found.push({ transport, from, to: first.to, directions });
  }
  return found;
}

/** How the fields of a candidate are judged, as a frame of this direction. */
export function judgement(bytes: Uint8Array, frame: Candidate, direction: Direction): ReturnType<typeof judgeRtu> {
  const { transport, from, to } = frame;
  if (transport === 'rtu') return judgeRtu(bytes, from, to, direction);
  const found = framesAt(bytes, from, to, transport).find((one) => one.to === to && one.direction === direction);
  return found?.legal ? (found.warned ? 'warned' : 'legal') : 'illegal';
}
