import { joinBytes } from '../../modbus/index.ts';

/** What goes wrong with a reply, on request. Times are milliseconds. */
export type Fault =
  | { readonly kind: 'silence' }
  | { readonly kind: 'late'; readonly by: number }
  /** The request is refused instead of carried out. */
  | { readonly kind: 'exception'; readonly exceptionCode: number }
  | { readonly kind: 'bad-crc' }
  /** Only this number of bytes comes. */
  | { readonly kind: 'cut-off'; readonly keep: number }
  /** The request comes back before the reply. */
  | { readonly kind: 'echo' }
  /** Random bytes before the reply. */
  | { readonly kind: 'noise'; readonly bytes: number }
  /** The reply before this one comes once more, right in front of it. */
  | { readonly kind: 'merged' }
  /** One byte in the middle is missing. */
  | { readonly kind: 'byte-loss' };

/** When a fault happens. */
export interface FaultRule {
  readonly fault: Fault;
  /** The device that it happens to; every device if absent. */
  readonly unit?: number | undefined;
  /** How often it will still happen; always if absent. */
  readonly times?: number | undefined;
}

export interface Sent {
  readonly request: Uint8Array;
  readonly reply: Uint8Array;
  /** The reply before this one on the line. */
  readonly previous: Uint8Array | undefined;
}

/** Random bytes, each 0 to 255. */
export type Chance = () => number;

/** From the end, the low byte of the CRC in RTU, and the last digit of the LRC in ASCII. */
const CHECKSUM_FROM_END = { rtu: 2, ascii: 3 } as const;
const ZERO = 0x30;
const ONE = 0x31;

/** The bytes that come instead of the reply; the reply itself if the fault leaves it whole. */
export function spoil(
  fault: Fault,
  { request, reply, previous }: Sent,
  mode: 'rtu' | 'ascii',
  chance: Chance,
): Uint8Array {
  switch (fault.kind) {
    case 'silence':
      return new Uint8Array();
    case 'bad-crc': {
      const at = reply.length - CHECKSUM_FROM_END[mode];
      const got = reply[at] as number;
      return reply.with(at, mode === 'rtu' ? got ^ 1 : got === ZERO ? ONE : ZERO);
    }
    case 'cut-off':
      return reply.subarray(0, fault.keep);
    case 'echo':
      return joinBytes([request, reply]);
    case 'noise':
      return joinBytes([Uint8Array.from({ length: fault.bytes }, chance), reply]);
    case 'merged':
      return joinBytes([previous ?? reply, reply]);
    case 'byte-loss': {
      const at = reply.length >> 1;
      return joinBytes([reply.subarray(0, at), reply.subarray(at + 1)]);
    }
    case 'late':
    case 'exception':
      return reply;
  }
}
