import type { Profile } from '../devices/index.ts';
import type { SerialLine } from '../modbus/index.ts';

/** What is written for a request: its bytes, or what makes them, what checks the reply, or all that speaks to the device. */
export type ProgramPart = (typeof programParts)[number];
export const programParts = ['bytes', 'build', 'check', 'exchange'] as const;

/** How a CRC is calculated: bit by bit, with one table of 256 words, or with two of 256 bytes, for the high and the low one. */
export type CrcWay = (typeof crcWays)[number];
export const crcWays = ['bitwise', 'table', 'two-tables'] as const;

/** How a program is written. */
export interface ProgramOptions {
  /** `exchange` by default; what a part needs is written too. A sequence is always written whole. */
  readonly part?: ProgramPart | undefined;
  /** `bitwise` by default. */
  readonly crc?: CrcWay | undefined;
  /** Whether comments explain each byte; `true` by default. */
  readonly comments?: boolean | undefined;
  /** What the request is called; by default a name made of its function, address and value. Of several frames each has its own. */
  readonly name?: string | undefined;
  /** Names of one's own, by the name that is written otherwise (as it stands in the program, such as `startAddress`). */
  readonly names?: Readonly<Record<string, string>> | undefined;
  /** The device: names, types, orders and scales of its registers, and register numbers as its manual prints them. */
  readonly profile?: Profile | undefined;
  /** Whether values of the device are given in units (`Hz`) instead of as they are sent; `false` by default. */
  readonly units?: boolean | undefined;
  /** Whether the adapter gives back what is sent, so that it is skipped in front of the reply; `false` by default. */
  readonly echo?: boolean | undefined;
  /** How long a reply may stay away, in milliseconds; 1000 by default. */
  readonly timeout?: number | undefined;
  /** The serial line; `/dev/ttyUSB0`, 19200 8E1 by default, or what the device has. */
  readonly line?:
    | ({ readonly [Name in keyof SerialLine]?: SerialLine[Name] | undefined } & { readonly port?: string | undefined })
    | undefined;
  /** The server of a TCP request; `192.168.0.10` and 502 by default. */
  readonly server?: { readonly host?: string | undefined; readonly port?: number | undefined } | undefined;
}
