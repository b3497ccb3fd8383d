import { Exchanges } from './exchanges.ts';
import { indexColumn } from './numbers.ts';
import { Records } from './records.ts';
import { Distribution } from './spread.ts';
import { type Line, Waiting } from './waiting.ts';

const UNITS = 256;

/** What a trace holds: its records, the exchanges that they belong to, and what may still be answered. */
export class Held {
  readonly records: Records;
  readonly exchanges = new Exchanges();
  /** By record. */
  readonly exchangeOf = indexColumn();
  readonly waiting = new Waiting();
  /** The lines of the exchanges that may still get a reply, as far as is known. */
  readonly waitingLines = new Map<number, Line>();
  readonly replyTimes = new Distribution();
  /** By number, whether a unit has been heard of. */
  readonly units = new Uint8Array(UNITS);
  /** How many of the records are bytes in no frame; each has an exchange of its own. */
  pieces = 0;
  /** The latest and the earliest time of the records; NaN if none of them has a time. */
  newest = Number.NaN;
  oldest = Number.NaN;

  constructor(records = new Records()) {
    this.records = records;
  }

  noteTime(time: number | undefined): void {
    if (time !== undefined && !(time <= this.newest)) this.newest = time;
    if (time !== undefined && !(time >= this.oldest)) this.oldest = time;
  }

  /** Whether a record is a frame; others are bytes, or words, in no frame. */
  isFrame(record: number): boolean {
    return this.pieces === 0 || this.records.known(record)?.beside !== 'noise';
  }
}
