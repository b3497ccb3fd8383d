import type { Scalar } from '../../code.ts';
import type { Names } from '../../names.ts';
import type { PlannedRequest } from '../../plan.ts';

/** A rung: a contact, the block that it starts, and a coil for each of its truths. */
export interface Rung {
  /** The type of the block, and its instance. */
  readonly block: string;
  readonly instance: string;
  readonly contact: string;
  /** What stands at the inputs besides: the input, its type and its value. */
  readonly inputs: readonly (readonly [input: string, type: string, value: string])[];
  /** What is passed to be changed: the parameter, and the type of the variable that has its name. */
  readonly passed: readonly (readonly [parameter: string, type: string])[];
  /** Outputs with coils; the first one stands in the rung, the others below. */
  readonly coils: readonly (readonly [output: string, coil: string])[];
}

const LITERALS: Readonly<Partial<Record<Scalar, string>>> = { byte: 'BYTE', word: 'WORD', dword: 'DWORD' };

/** The rung for the block of a request, or of the sequence. */
export function rungOf(request: PlannedRequest | undefined, requests: readonly PlannedRequest[], names: Names): Rung {
  const block = names.of(request?.name ?? 'modbus sequence', 'type');
  const plain = block.replace(/^FB_/, '');
  const inputs = (request?.arguments ?? []).flatMap(({ parameter, value }) => {
    const type = LITERALS[parameter.type];
    if (typeof value !== 'number' || type === undefined) return [];
    return [[names.of(parameter.name, 'variable'), type, `${type}#${value}`] as const];
  });
  const answered = requests.some(({ check }) => check !== undefined);
  return {
    block,
    instance: `Do${plain}`,
    contact: `Start${plain}`,
    inputs,
    passed: answered
      ? [
          ['RxBuffer', 'T_ModbusFrame'],
          ['RxCount', 'DINT'],
        ]
      : [],
    coils: [
      ['TxStart', `Send${plain}`],
      ['Done', `Done${plain}`],
      ['Error', `Error${plain}`],
    ],
  };
}

/** Text that stands in XML. */
export const xmlText = (text: string): string => text.replace(/[&<>"']/g, (one) => `&#${one.charCodeAt(0)};`);
