import { readFileSync } from 'node:fs';
// @ts-expect-error: the script has no types of its own.
import { writeLog } from '../../../bench/field/write-log.mjs';
import { hex } from '../modbus/frames.ts';

export interface Dialect {
  readonly name: string;
  /** Whether each of its frames has a time that is read. */
  readonly timed?: boolean;
}

/** Bytes of one side; what is written has `-` if the dialect leaves the side open. */
export interface Entry {
  readonly side: string;
  readonly bytes: Uint8Array;
}

/** A log in a dialect, and what it says: times in milliseconds. */
export const write: (
  dialect: Dialect,
  entries: readonly Entry[],
) => { readonly text: string; readonly chunks: readonly (Entry & { readonly time: number })[] } = writeLog;

const file = readFileSync(new URL('../../vectors/dialects.json', import.meta.url), 'utf8');
const all = JSON.parse(file) as readonly Dialect[];

/** The ways in which programs print a log, by their names. */
export const dialects = all.map((dialect) => [dialect.name, dialect] as const);

/** Three exchanges: AP 6.3, a write that is echoed, AP 6.1. */
export const said: readonly Entry[] = [
  { side: 'tx', bytes: hex('11 03 00 6B 00 03 76 87') },
  { side: 'rx', bytes: hex('11 03 06 02 2B 00 00 00 64 C8 BA') },
  { side: 'tx', bytes: hex('06 06 02 AB 10 00 F5 E5') },
  { side: 'rx', bytes: hex('06 06 02 AB 10 00 F5 E5') },
  { side: 'tx', bytes: hex('01 01 10 20 00 0F 79 04') },
  { side: 'rx', bytes: hex('01 01 02 00 12 39 F1') },
];
