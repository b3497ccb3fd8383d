import fc from 'fast-check';
import { encodeFrame } from '../../../../src/modbus/index.ts';
import type { TraceInput } from '../../../../src/trace/index.ts';
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
/** Units are larger than function codes, and the bytes of addresses are none of both: damage does not make one of the other. */
export const anyWorld = (least: number, high: number, host: number): fc.Arbitrary<World> =>
  fc.record({
    units: fc.uniqueArray(fc.integer({ min: least, max: least + 40 }), { minLength: 3, maxLength: 3 }),
    base: fc.nat(3).map((n) => ((high + n) << 8) | 0xa0),
    begin: fc.integer({ min: 1_700_000_000, max: 1_800_000_000 }).map((seconds) => seconds * 1e6),
    ends: fc.tuple(
      fc.integer({ min: 1, max: 9 }).map((n) => `10.${host}.${n}.1:${40_000 + host}`),
      fc.constantFrom(`10.${host}.7.2:502`, `10.${host}.7.2:1502`, `[fe80::${host}]:502`),
    ),
    line: fc.constantFrom(`COM${host}`, `plc ${host}`, `fe80::${host}`),
  });
const damages = ['none', 'crc', 'cut', 'begun', 'glued', 'unknown', 'noise', 'lost'] as const;
/** An exchange, on a unit and a table of the world. */
export const anyAct = fc.record({
  unit: fc.nat(2),
  table: fc.nat(1),
  offset: fc.nat(30),
  functionCode: fc.constantFrom(1, 3, 5, 6, 16, 17, 20, 22, 23, 72),
  transport: fc.constantFrom('rtu', 'ascii', 'tcp'),
  damage: fc.constantFrom(...damages),
  answered: fc.constantFrom('data', 'exception', 'not'),
  gap: fc.nat(2_000_000),
});
export type Act = typeof anyAct extends fc.Arbitrary<infer A> ? A : never;

/** The records of what happens in a world. */
export function happened(world: World, acts: readonly Act[]): TraceInput[] {
  let time = world.begin;
  const damaged = (frame: Uint8Array, next: Uint8Array, { damage, transport }: Act) => {
    if (transport !== 'rtu') return frame;
    const other = frame.slice();
    if (damage === 'crc') other[frame.length - 1] = (frame.at(-1) ?? 0) ^ 0x10;
    if (damage === 'unknown') other[1] = 0x6e;
    if (damage === 'cut') return frame.subarray(0, 3);
    if (damage === 'begun') return frame.subarray(2);
    if (damage === 'glued') return Buffer.concat([frame, next]);
    if (damage === 'noise') return hex('FF FE 00');
    return other;
  };
  return acts.flatMap((act): TraceInput[] => {
    const { unit, table, offset, functionCode, transport, damage, answered, gap } = act;
    const { [unit]: unitId = 0 } = world.units;
    // How far addresses are apart is kept.
    const base = world.base + 0x400 * table;
    const common = { transport, unitId, functionCode } as const;
    const asked = anyFields(functionCode, base + offset, unitId);
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
      bytes: damage === 'lost' ? answer : damaged(answer, ask, act),
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
function anyFields(functionCode: number, address: number, unit: number) {
  const one = { startAddress: address, quantity: 2 };
  switch (functionCode) {
    case 1:
      return { request: one, response: { bits: [true, false, true, true, false, false, true, false] } };
    case 3:
      return { request: one, response: { registers: [1, 2] } };
    case 5:
      return {
        request: { address, value: true },
        response: { address, value: true },
      };
    case 6:
      return {
        request: { address, value: 7 },
        response: { address, value: 7 },
      };
    case 16:
      return { request: { startAddress: address, registers: [5, 6] }, response: one };
    case 17:
      // Many devices give their unit as the identifier of the server (AP 6.13).
      return { request: {}, response: { data: `${unit.toString(16).padStart(2, '0')}FF` } };
    case 20:
      return {
        request: { subRequests: [{ referenceType: 6, fileNumber: address, recordNumber: 9, recordLength: 2 }] },
        response: { subResponses: [{ referenceType: 6, recordData: [1, 2] }] },
      };
    case 22: {
      const mask = { referenceAddress: address, andMask: 1, orMask: 2 };
      return { request: mask, response: mask };
    }
    case 23:
      return {
        request: { readStartAddress: address, readQuantity: 1, writeStartAddress: address + 1, writeRegisters: [3] },
        response: { registers: [4] },
      };
    default: {
      const data = { data: `${address.toString(16)}${unit.toString(16)}` };
      return { request: data, response: data };
    }
  }
}
