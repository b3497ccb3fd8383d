import fc from 'fast-check';
import { crc16, encodeFrame, hexDigits } from '../../../../src/modbus/index.ts';
import type { Trace, TraceInput } from '../../../../src/trace/index.ts';
import { hex } from '../../captures/wire.ts';

const place = { kind: 'text', from: 0, to: 0 } as const;

/** Where something happens: on which units, addresses, times and ends. */
export interface World {
  readonly units: readonly number[];
  readonly base: number;
  readonly begin: number;
  readonly ends: readonly [client: string, server: string];
  readonly line: string;
}
/** One unit may be for all, which it is in every world; any byte of an address may be one of another kind. */
export const anyWorld = (host: number, withBroadcast: boolean): fc.Arbitrary<World> =>
  fc.record({
    units: fc
      .uniqueArray(fc.oneof(fc.integer({ min: 1, max: 255 }), fc.integer({ min: 1, max: 6 })), {
        minLength: 3,
        maxLength: 3,
      })
      .map((units) => (withBroadcast ? [0, ...units.slice(1)] : units)),
    base: fc.oneof(
      fc.nat(MOST_BASE),
      fc.tuple(fc.nat(23), fc.nat(23)).map(([high, low]) => (high << 8) | low),
    ),
    begin: fc.integer({ min: 1, max: 2_000_000_000 }).map((seconds) => seconds * 1e6),
    ends: fc.tuple(
      fc.integer({ min: 1, max: 9 }).map((n) => `10.${host}.${n}.1:${40_000 + host}`),
      fc.constantFrom(`10.${host}.7.2:502`, `10.${host}.7.2:1502`, `[fe80::${host}]:502`),
    ),
    line: fc.constantFrom(`COM${host}`, `plc ${host}`, `fe80::${host}`),
  });
/** Two worlds in which the same may happen. */
export const anyTwoWorlds = fc
  .boolean()
  .chain((withBroadcast) => fc.tuple(anyWorld(1, withBroadcast), anyWorld(2, withBroadcast)));
const MOST_BASE = 0xffff - 0x400 - 40;
const damages = [
  'none',
  'none',
  'crc',
  'bit',
  'cut',
  'begun',
  'shifted',
  'glued',
  'unknown',
  'noise',
  'lost',
  'count',
] as const;
/** Functions whose replies have a count in front, and the length of their requests. */
const COUNTED: ReadonlySet<number> = new Set([1, 2, 3, 4]);
const REQUEST = 8;
/** An exchange, on a unit and a table of the world. */
export const anyAct = fc.record({
  unit: fc.nat(2),
  table: fc.nat(1),
  offset: fc.nat(30),
  functionCode: fc.constantFrom(1, 2, 3, 4, 5, 6, 7, 8, 15, 16, 17, 20, 21, 22, 23, 24, 43, 72),
  transport: fc.constantFrom('rtu', 'ascii', 'tcp'),
  damage: fc.constantFrom(...damages),
  answered: fc.constantFrom('data', 'exception', 'not'),
  gap: fc.nat(2_000_000),
  /** A value that is read or written, and where a frame is torn. */
  value: fc.oneof(fc.nat(0xffff), fc.nat(8)),
  torn: fc.integer({ min: 1, max: 6 }),
});
export type Act = typeof anyAct extends fc.Arbitrary<infer A> ? A : never;

/** The records of what happens in a world. */
export function happened(world: World, acts: readonly Act[]): TraceInput[] {
  let time = world.begin;
  const damaged = (frame: Uint8Array, next: Uint8Array, { damage, transport, torn, offset }: Act) => {
    if (transport === 'tcp' && damage !== 'begun') return frame;
    const other = frame.slice();
    const last = frame.length - 1;
    if (damage === 'crc') other[last] = (frame[last] ?? 0) ^ 0x10;
    if (damage === 'bit') other[offset % frame.length] = (other[offset % frame.length] ?? 0) ^ (1 << torn);
    if (damage === 'unknown') other[1] = 0x6e;
    if (damage === 'lost' && transport === 'ascii') return frame.subarray(0, frame.length - 2);
    if (damage === 'cut') return frame.subarray(0, Math.max(1, last - torn));
    if (damage === 'begun') return frame.subarray(torn);
    if (damage === 'shifted') return Buffer.concat([frame.subarray(torn), next.subarray(0, torn)]);
    if (damage === 'glued') return Buffer.concat([frame, next]);
    if (damage === 'noise') return hex('FF FE 00');
    if (damage === 'count' && transport === 'rtu' && COUNTED.has(frame[1] ?? 0) && frame.length !== REQUEST) {
      other[2] = (other[2] ?? 0) ^ torn;
      const crc = crc16(other, 0, last - 1);
      [other[last - 1], other[last]] = [crc & 0xff, crc >> 8];
    }
    return other;
  };
  return acts.flatMap((act): TraceInput[] => {
    const { unit, table, offset, functionCode, transport, damage, answered, gap } = act;
    const { [unit]: unitId = 0 } = world.units;
    // How far addresses are apart is kept.
    const base = world.base + 0x400 * table;
    const common = { transport, unitId, functionCode } as const;
    const asked = anyFields(functionCode, base + offset, unitId, act.value);
    const ask = encodeFrame({ ...common, direction: 'request', fields: asked.request });
    const answer =
      answered === 'exception'
        ? encodeFrame({
            ...common,
            functionCode: functionCode | 0x80,
            direction: 'response',
            fields: { exceptionCode: 2 },
          })
        : encodeFrame({ ...common, direction: 'response', fields: asked.response });
    time += gap;
    const [client, server] = transport === 'tcp' ? world.ends : [world.line, undefined];
    const request = {
      bytes: damaged(ask, answer, act),
      transport,
      time,
      side: 'request',
      from: client,
      to: server,
    } as const;
    const reply = {
      bytes: damage === 'lost' && transport !== 'ascii' ? answer : damaged(answer, ask, act),
      transport,
      time: time + 4000,
      side: 'response',
      from: server,
      to: client,
    } as const;
    return (answered === 'not' ? [request] : [request, reply]).map((one) => ({ ...one, place }));
  });
}

/** What a function is asked about an address, and answers. */
function anyFields(functionCode: number, address: number, unit: number, value: number) {
  const one = { startAddress: address, quantity: 2 };
  const bits = [true, false, true, true, false, false, true, false];
  switch (functionCode) {
    case 1:
    case 2:
      return { request: one, response: { bits } };
    case 3:
    case 4:
      return { request: one, response: { registers: [value, 2] } };
    case 5:
      return { request: { address, value: true }, response: { address, value: true } };
    case 6:
      return { request: { address, value }, response: { address, value } };
    case 7:
      return { request: {}, response: { outputData: value & 0xff } };
    case 8: {
      const data = { subFunction: 0, data: value.toString(16).padStart(4, '0') };
      return { request: data, response: data };
    }
    case 15:
      return { request: { startAddress: address, bits }, response: { startAddress: address, quantity: bits.length } };
    case 16:
      return { request: { startAddress: address, registers: [5, value] }, response: one };
    case 17:
      // Many devices give their unit as the identifier of the server (AP 6.13).
      return { request: {}, response: { data: `${hexDigits(unit, 2)}FF` } };
    case 20:
      return {
        request: { subRequests: [{ referenceType: 6, fileNumber: address, recordNumber: 9, recordLength: 2 }] },
        response: { subResponses: [{ referenceType: 6, recordData: [1, value] }] },
      };
    case 21: {
      const group = { referenceType: 6, fileNumber: address, recordNumber: 9, recordData: [1, value] };
      return { request: { subRequests: [group] }, response: { subRequests: [group] } };
    }
    case 22: {
      const mask = { referenceAddress: address, andMask: value, orMask: 2 };
      return { request: mask, response: mask };
    }
    case 23:
      return {
        request: { readStartAddress: address, readQuantity: 1, writeStartAddress: address + 1, writeRegisters: [3] },
        response: { registers: [value] },
      };
    case 24:
      return { request: { fifoPointerAddress: address }, response: { fifoValues: [value, 2] } };
    case 43: {
      const asked = { meiType: 14, readDeviceIdCode: 1, objectId: 0 };
      return {
        request: asked,
        response: {
          ...asked,
          conformityLevel: 1,
          moreFollows: 0,
          nextObjectId: 0,
          objects: [{ objectId: 0, value: `Pump ${value}` }],
        },
      };
    }
    default: {
      const data = { data: `${hexDigits(address, 4)}${hexDigits(unit, 2)}` };
      return { request: data, response: data };
    }
  }
}

/** What is read of records, apart from who speaks of what: worlds in which it is not the same differ in more than that. */
export function seen(trace: Trace) {
  const records = Array.from({ length: trace.size }, (_, index) => [trace.spoken(index).side, trace.exchangeOf(index)]);
  const exchanges = trace.exchanges(0, trace.exchangeCount);
  return JSON.stringify([records, exchanges.map(({ faults }) => faults.map(({ kind, code }) => [kind, code]))]);
}
