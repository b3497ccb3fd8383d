import type { EntityTable, Trait } from '../../devices/index.ts';
import type { SerialLine } from '../../modbus/index.ts';
import type { Cells } from './cells.ts';
import type { Counters } from './counters.ts';

/** All that the functions of a device read and write. */
export interface Device {
  readonly tables: Readonly<Record<EntityTable, Cells>>;
  /** By file number, the registers from record 0 on. */
  readonly files: Map<number, Uint16Array>;
  /** By pointer address, what stands in the queue, the oldest first. */
  readonly fifos: Map<number, number[]>;
  /** By object id (AP 6.21). */
  readonly objects: Map<number, string>;
  /** 01 basic, 02 regular, 03 extended; with 80 also one object alone (AP 6.21). */
  readonly conformityLevel: number;
  /** Server id, run indicator and what else 11 answers, as hexadecimal pairs (AP 6.13). */
  serverId: string;
  /** What 07 answers. */
  exceptionStatus: number;
  /** Whether it is still working on a program command, which 0B and 0C call busy (AP 6.9). */
  busy: boolean;
  readonly counters: Counters;
  readonly traits: readonly Trait[];
}

/** How a device hears its line. */
export interface DeviceLine {
  /** 1 to 247. */
  unit: number;
  /** The settings of its line; if absent, those of the client. */
  line?: SerialLine | undefined;
  /** How long it works before it answers, in milliseconds. */
  delay: number;
}
