import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { join } from 'node:path';
import { expect } from 'vitest';
import type { FrameInput, Transport, Values } from '../../../src/modbus/index.ts';
import type { ProgramCase } from '../cases.ts';
import { loopback, SLAVE_PORT } from '../line.ts';
import { cache } from '../tools.ts';

/** A server by libmodbus, on a pseudo-terminal and on loopback; what it holds stands in `native/slave.c`. */
export interface Slave {
  /** The path of the pseudo-terminal. */
  readonly serial: string;
  /** The address of the server by TCP; its port is `SLAVE_PORT`. */
  readonly host: string;
  readonly end: () => void;
}

const UNIT = 17;

export async function startSlave(): Promise<Slave> {
  const host = loopback();
  const child = spawn(join(cache, 'slave'), [host, String(SLAVE_PORT), String(UNIT)], {
    stdio: ['pipe', 'pipe', 'inherit'],
  });
  const [path] = await once(child.stdout, 'data');
  return { serial: String(path).trim(), host, end: () => void child.stdin.end() };
}

interface Served {
  readonly name: string;
  readonly functionCode: number;
  readonly fields: Values;
  /** 0, or the code of an exception. */
  readonly result?: number;
  readonly list?: readonly number[];
}

/** What the server is asked, one after the other, and what it answers. */
const served: readonly Served[] = [
  { name: 'coils', functionCode: 1, fields: { startAddress: 0, quantity: 10 }, list: [1, 0, 0, 1, 0, 0, 1, 0, 0, 1] },
  { name: 'inputs', functionCode: 2, fields: { startAddress: 1, quantity: 9 }, list: [0, 1, 0, 1, 0, 1, 0, 1, 0] },
  { name: 'registers', functionCode: 3, fields: { startAddress: 8, quantity: 2 }, list: [1008, 1009] },
  { name: 'input registers', functionCode: 4, fields: { startAddress: 3, quantity: 1 }, list: [2003] },
  { name: 'set coil', functionCode: 5, fields: { address: 20, value: true } },
  { name: 'set coils', functionCode: 15, fields: { startAddress: 22, bits: [1, 1, 0] } },
  { name: 'coils set', functionCode: 1, fields: { startAddress: 20, quantity: 5 }, list: [1, 1, 1, 1, 0] },
  { name: 'set register', functionCode: 6, fields: { address: 50, value: 0x1234 } },
  { name: 'mask register', functionCode: 22, fields: { referenceAddress: 50, andMask: 0xf2, orMask: 0x25 } },
  { name: 'set registers', functionCode: 16, fields: { startAddress: 51, registers: [1, 0xffff] } },
  // AP 6.16: 0x1234 AND 0xF2, OR (0x25 AND NOT 0xF2).
  { name: 'registers set', functionCode: 3, fields: { startAddress: 50, quantity: 3 }, list: [0x35, 1, 0xffff] },
  {
    name: 'set and read',
    functionCode: 23,
    fields: { readStartAddress: 52, readQuantity: 2, writeStartAddress: 53, writeRegisters: [7] },
    list: [0xffff, 7],
  },
  { name: 'server id', functionCode: 17, fields: {} },
  { name: 'beyond the last', functionCode: 3, fields: { startAddress: 195, quantity: 10 }, result: 2 },
  { name: 'not known to it', functionCode: 11, fields: {}, result: 1 },
];

const framed = (transport: Transport, { functionCode, fields }: Served, unitId = UNIT): FrameInput => ({
  transport,
  direction: 'request',
  unitId,
  ...(transport === 'tcp' && { transactionId: 0x0102 }),
  functionCode,
  fields,
});

/** The requests that the server is asked, of these functions; all if none are given. */
export const slaveCases = (transport: Transport, of?: readonly number[]): readonly ProgramCase[] =>
  served
    .filter(({ functionCode }) => of?.includes(functionCode) ?? true)
    .map((one) => ({ name: one.name, request: framed(transport, one) }));

/** A request to a unit that is not there. */
export const toNobody = (transport: Transport): FrameInput =>
  framed(transport, { name: '', functionCode: 3, fields: { startAddress: 8, quantity: 2 } }, UNIT + 1);

/** Holds what a program said, of each request `name: good` and its list, against what the server has. */
export function expectServed(text: string): void {
  const verdict = /: (?:good|exception (\d+): .*|exception (\d+), .*|fault (-\d+)\W.*)$/;
  const said: { result: number; list: string }[] = [];
  for (const line of text.replace(/(?<=\w)\[\d+\]/g, '').split(/\r?\n/)) {
    const found = verdict.exec(line.trimEnd());
    if (found) said.push({ result: Number(found[1] ?? found[2] ?? found[3] ?? 0), list: '' });
    const last = said.at(-1);
    if (found || last === undefined) continue;
    const items = line.match(/-?\b\d+\b|\btrue\b|\bfalse\b/gi) ?? [];
    last.list += items.map((item) => ` ${/true/i.test(item) ? 1 : /false/i.test(item) ? 0 : item}`).join('');
  }
  expect(said.map(({ result, list }, at) => [served[at]?.name, result, served[at]?.list ? list : ''])).toEqual(
    served.map(({ name, result = 0, list = [] }) => [name, result, list.map((item) => ` ${item}`).join('')]),
  );
}
