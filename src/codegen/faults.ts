import { exceptionCodes } from '../modbus/index.ts';
import { type Constant, type Expression, name, type Texts } from './code.ts';

/** What a check can find wrong, by the name of its constant, with the number it answers and the words for it. */
export const faults = {
  'too short': [-1, 'the reply is too short'],
  'too long': [-2, 'the reply is too long'],
  'other unit': [-3, 'another unit replied'],
  'other function': [-4, 'the reply is to another function'],
  'wrong count': [-5, 'the count in the reply is not what was asked for'],
  'echo differs': [-6, 'the reply does not repeat the request'],
  'wrong checksum': [-7, 'the checksum is wrong'],
  'no reply': [-8, 'no reply'],
  'wrong characters': [-9, 'characters that do not belong in an ASCII frame'],
  'other transaction': [-10, 'the reply is to another transaction'],
} as const satisfies Readonly<Record<string, readonly [number, string]>>;

export type FaultName = keyof typeof faults;
const faultNames = Object.keys(faults) as readonly FaultName[];

const constantOf = (of: FaultName): string => `fault ${of}`;

/** The constant of a fault. */
export const fault = (of: FaultName): Expression => name('int', constantOf(of));

/** The constants of these faults, in their order. */
export const faultConstants = (used: ReadonlySet<string>): readonly Constant[] =>
  faultNames
    .filter((of) => used.has(constantOf(of)))
    .map((of) => ({ name: constantOf(of), type: 'int', value: faults[of][0], base: 10, comment: faults[of][1] }));

/** The texts of faults, by number. */
export const faultTexts = (used: ReadonlySet<string>): Texts => ({
  name: 'fault name',
  about: 'What a check found wrong, in words.',
  parameter: 'fault',
  entries: faultNames
    .filter((of) => used.has(constantOf(of)))
    .map((of) => ({ number: faults[of][0], text: faults[of][1] })),
  otherwise: 'unknown',
});

export const exceptionTexts: Texts = {
  name: 'exception name',
  about: 'The name of an exception.',
  parameter: 'code',
  entries: exceptionCodes.map(({ code, name: text }) => ({ number: code, text })),
  otherwise: 'UNKNOWN EXCEPTION',
};
