import { BROADCAST, type Direction, decodeFrame, type Reading } from '../../modbus/index.ts';
import type { LogLine } from '../log/line.ts';
import { fits } from '../transaction/find-frame.ts';
import type { HeardCount, HeardNews } from './heard.ts';
import type { HeardPiece } from './stream-splitter.ts';

const EXCEPTION = 0x80;

/** A request that waits for its reply. */
interface Open {
  readonly bytes: Uint8Array;
  readonly unit: number;
  readonly functionCode: number;
}

/** What a frame is, for the log. */
export type HeardLine = Pick<LogLine, 'direction' | 'transport' | 'kind' | 'verdict'>;

/** Pairs requests and replies that are heard, and counts them. */
export class Conversation {
  readonly #counts = new Map<number, HeardCount>();
  #open: Open | undefined;
  #frames = 0;
  #noise = 0;

  get news(): HeardNews {
    const counts = [...this.#counts].sort(([one], [other]) => one - other).map(([, count]) => count);
    return { kind: 'heard', counts, frames: this.#frames, noise: this.#noise };
  }

  /** Takes the next piece; `log` writes its line. */
  add({ bytes, frame }: HeardPiece, log: (line: HeardLine) => void): void {
    if (frame === undefined) {
      this.#noise += bytes.length;
      log({ direction: 'received', transport: 'rtu', kind: 'noise' });
      return;
    }
    this.#frames += 1;
    const { transport } = frame;
    const open = this.#open;
    const guess: Direction = open && fits(bytes, { transport, request: open.bytes }) ? 'response' : 'request';
    const direction = frame.direction ?? guess;
    if (direction === 'request') {
      const reading = decodeFrame(bytes, { transport, direction });
      if (open) this.#add(open, { unanswered: 1 });
      this.#open = undefined;
      const place = placeOf(reading);
      this.#add(place, { requests: 1, wrong: isWrong(reading) });
      log({ direction: 'sent', transport, kind: 'heard', verdict: verdictOf(reading) });
      if (place.unit !== BROADCAST) this.#open = { ...place, bytes };
      return;
    }
    const alone = decodeFrame(bytes, { transport, direction });
    const place = placeOf(alone);
    const isAnswer = open?.unit === place.unit && open.functionCode === place.functionCode;
    const reading = isAnswer ? decodeFrame(bytes, { transport, direction, request: open.bytes }) : alone;
    if (isAnswer) this.#open = undefined;
    const refused = isException(reading);
    this.#add(place, { [refused ? 'exceptions' : 'replies']: 1, wrong: isWrong(reading) });
    log({ direction: 'received', transport, kind: 'heard', verdict: verdictOf(reading) });
  }

  #add(
    { unit, functionCode }: Pick<HeardCount, 'unit' | 'functionCode'>,
    more: Partial<Omit<HeardCount, 'unit' | 'functionCode'>>,
  ): void {
    const key = unit * 256 + functionCode;
    const { requests, replies, exceptions, unanswered, wrong } = this.#counts.get(key) ?? NONE;
    this.#counts.set(key, {
      unit,
      functionCode,
      requests: requests + (more.requests ?? 0),
      replies: replies + (more.replies ?? 0),
      exceptions: exceptions + (more.exceptions ?? 0),
      unanswered: unanswered + (more.unanswered ?? 0),
      wrong: wrong + (more.wrong ?? 0),
    });
  }
}

const NONE = { requests: 0, replies: 0, exceptions: 0, unanswered: 0, wrong: 0 };

const placeOf = ({ unitId = 0, functionCode = 0 }: Reading) => ({
  unit: unitId,
  functionCode: functionCode & ~EXCEPTION,
});

const isException = ({ functionCode = 0, direction }: Reading) =>
  direction === 'response' && (functionCode & EXCEPTION) !== 0;

const isWrong = ({ problems }: Reading) => (problems.some(({ severity }) => severity === 'error') ? 1 : 0);

const verdictOf = (reading: Reading) => (isWrong(reading) ? 'bad' : isException(reading) ? 'refused' : 'good');
