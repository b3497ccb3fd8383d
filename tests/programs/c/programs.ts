import { expect } from 'vitest';
import { type Profile, plainRegister } from '../../../src/devices/index.ts';
import { encodeFrame, toHex } from '../../../src/modbus/index.ts';
import { type CaseReply, type ProgramCase, repliesTo } from '../cases.ts';

/** What is written to a driver (`driver.h`), and what it must answer. */
export interface Drive {
  readonly input: string;
  readonly replies: readonly { readonly of: ProgramCase; readonly reply: CaseReply }[];
}

export function driveOf(cases: readonly ProgramCase[]): Drive {
  const replies = cases.flatMap((of, index) => repliesTo(of.request).map((reply) => ({ of, index, reply })));
  const input = replies.map(({ index, reply }) => `${index} ${toHex(reply.bytes) || '-'}\n`).join('');
  return { input, replies };
}

/** The result that a program prints: `name: good`, `name: exception 2, …`, `name: fault -7, …`. */
const resultOf = (line: string): number =>
  Number(/: (?:exception|fault) (-?\d+), \S/.exec(line)?.[1] ?? (/: good$/.test(line) ? 0 : Number.NaN));

/** Holds what a driver printed against the bytes that the encoder makes and the results that the cases expect. */
export function expectDriven(out: string, cases: readonly ProgramCase[], { replies }: Drive): void {
  const [frames = '', ...checks] = out.trimEnd().split('#\n');
  expect(frames.trim().split('\n')).toEqual(cases.map(({ request }) => toHex(encodeFrame(request))));
  const got = replies.map(({ of, reply }, index) => {
    const [line = '', ...values] = (checks[index] ?? '').trimEnd().split('\n');
    const result = resultOf(line);
    const list =
      reply.list && values.filter((value) => value.includes('] = ')).map((value) => Number(value.split(' = ')[1]));
    return { of: of.name, what: reply.what, result: reply.result === 'fault' && result < 0 ? 'fault' : result, list };
  });
  expect(got).toEqual(
    replies.map(({ of, reply }) => ({ of: of.name, what: reply.what, result: reply.result, list: reply.list })),
  );
}

/** Names of which none may be a name of a program. */
export const nastyNames: readonly string[] = [
  'class',
  'main',
  'read',
  '2nd frame',
  'Größe',
  '水位',
  '"quoted" \\',
  '*/ end ??/',
  'back\\',
  'line\nbreak',
  'exchange',
  'requests',
  'a'.repeat(300),
  '%s%n',
  '',
];

/** A device whose texts would break out of comments and strings. */
export const nastyProfile: Profile = {
  id: 'nasty',
  name: 'x */ "y" \\',
  source: '',
  convention: 'five-digit',
  traits: [],
  notes: [],
  registers: ['back\\', 'trigraph ??/', '*/ int x = "', '\u202Eline\u2028break\r\nint y;'].map((name, index) => ({
    ...plainRegister,
    name,
    table: 'holding-register',
    address: 0x6b + index,
  })),
};

/** A drive: values of one and two registers, scaled. */
export const drive: Profile = {
  id: 'drive',
  name: 'Drive',
  source: '',
  convention: 'five-digit',
  traits: [],
  notes: [],
  registers: [
    { ...plainRegister, name: 'Speed', table: 'holding-register', address: 10, type: 'i16', factor: 0.1, unit: 'Hz' },
    { ...plainRegister, name: 'Current', table: 'holding-register', address: 11, type: 'f32', unit: 'A' },
    { ...plainRegister, name: 'Energy', table: 'holding-register', address: 13, type: 'u32', unit: 'Wh' },
    { ...plainRegister, name: 'Torque', table: 'holding-register', address: 15, type: 'i32', order: 'CDAB' },
  ],
};
