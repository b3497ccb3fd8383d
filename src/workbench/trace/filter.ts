import { type FaultKind, faultKinds } from '../../trace/index.ts';

/** What a filter asks of a record, or of an exchange. */
export interface Described {
  readonly unit: number;
  /** Without the exception bit. */
  readonly functionCode: number;
  readonly faults: readonly FaultKind[];
  /** The causes that explain its faults. */
  readonly causes: readonly string[];
}

/** A word of a filter that says nothing, and where it stands. */
export interface FilterMistake {
  readonly code: 'not-known' | 'not-a-number';
  readonly from: number;
  readonly to: number;
}

export type Filter =
  | { readonly kind: 'filter'; readonly isAll: boolean; readonly test: (described: Described) => boolean }
  | { readonly kind: 'mistakes'; readonly mistakes: readonly FilterMistake[] };

type Test = (described: Described) => boolean;

/** Reads a filter: terms that all have to hold. */
export function parseFilter(text: string): Filter {
  const tests: Test[] = [];
  const mistakes: FilterMistake[] = [];
  for (const { 0: term, index } of text.matchAll(/\S+/g)) {
    const read = readTerm(term);
    if (typeof read === 'function') tests.push(read);
    else mistakes.push({ code: read, from: index, to: index + term.length });
  }
  if (mistakes.length > 0) return { kind: 'mistakes', mistakes };
  return {
    kind: 'filter',
    isAll: tests.length === 0,
    test: (described) => tests.every((test) => test(described)),
  };
}

function readTerm(term: string): Test | FilterMistake['code'] {
  const kind = faultKinds.find((one) => one === term || (one === 'checksum' && term === 'crc'));
  if (kind) return ({ faults }) => faults.includes(kind);
  if (term === 'fault') return ({ faults }) => faults.length > 0;
  const [name, value = ''] = term.split(':');
  if (name === 'cause') return ({ causes }) => causes.includes(value);
  if (name !== 'unit' && name !== 'fc') return 'not-known';
  const wanted = value.split(',').map(Number);
  if (value === '' || wanted.some((number) => !Number.isInteger(number))) return 'not-a-number';
  return name === 'unit' ? ({ unit }) => wanted.includes(unit) : ({ functionCode }) => wanted.includes(functionCode);
}
