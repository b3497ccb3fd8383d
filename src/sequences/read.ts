import { byteOrders, entityTables, isBitTable, readDecimal } from '../devices/index.ts';
import { fromHex, LAST_ADDRESS, MOST_ASCII, numberTypes, plainTypeNames } from '../modbus/index.ts';
import { elementsOf } from './condition.ts';
import { listNames, onFailures, relations, type Sequence, type Step, type StepPlace } from './sequence.ts';
import type { SequenceTexts, StepTexts } from './texts.ts';

/** Why a step cannot be carried out, or why there is no step. */
export type StepFault =
  | { readonly code: 'field-missing'; readonly field: string }
  | { readonly code: 'not-a-number'; readonly field: string; readonly got: string }
  | {
      readonly code: 'out-of-range';
      readonly field: string;
      readonly got: number;
      readonly least: number;
      readonly most: number;
    }
  | { readonly code: 'unknown'; readonly field: string; readonly got: string; readonly known: readonly string[] }
  | { readonly code: 'not-bytes'; readonly field: string; readonly got: string }
  | { readonly code: 'too-long'; readonly field: string; readonly got: number; readonly most: number }
  | { readonly code: 'over-the-end'; readonly field: string; readonly last: number }
  /** A sequence or a repetition without steps; `at` of the place is empty for the sequence. */
  | { readonly code: 'no-steps' };

export type PlacedFault = StepFault & { readonly place: StepPlace };

export type SequenceReading =
  | { readonly kind: 'sequence'; readonly sequence: Sequence }
  | { readonly kind: 'faults'; readonly faults: readonly PlacedFault[] };

/** An hour, in milliseconds. */
const LONGEST = 3_600_000;
const MOST_TIMES = 10_000;
const LAST_UNIT_NUMBER = 0xff;

/** Decimals, and hexadecimal as `0x2A9` or `2A9h`. */
const numberOf = (text: string): number | undefined => {
  const [, sign, digits] =
    /^([-+]?)(?:0x([0-9a-f]{1,12}))$/i.exec(text.replace(/^([-+]?)([0-9a-f]+)h$/i, '$10x$2')) ?? [];
  if (digits === undefined) return readDecimal(text);
  return (sign === '-' ? -1 : 1) * Number.parseInt(digits, 16);
};

/** Reads what was typed. If it is not a sequence, answers everything that is wrong with it. Never throws. */
export function readSequence(texts: SequenceTexts): SequenceReading {
  const faults: PlacedFault[] = [];
  const [steps = [], last = []] = listNames.map((list) => readSteps(texts[list], { list, at: [] }, faults));
  if (texts.steps.length === 0) faults.unshift({ code: 'no-steps', place: { list: 'steps', at: [] } });
  if (faults.length > 0) return { kind: 'faults', faults };
  return { kind: 'sequence', sequence: { transport: texts.transport, steps, finally: last } };
}

const readSteps = (all: readonly StepTexts[], { list, at }: StepPlace, faults: PlacedFault[]): readonly Step[] =>
  all.map((step, index) => readStep(step, { list, at: [...at, index] }, faults));

function readStep({ kind, fields, steps = [] }: StepTexts, place: StepPlace, faults: PlacedFault[]): Step {
  const fault = (one: StepFault) => faults.push({ ...one, place });
  const textOf = (field: string) => fields[field]?.trim() ?? '';
  const number = (field: string, least: number, most: number): number => {
    const text = textOf(field);
    const got = numberOf(text);
    if (text === '') fault({ code: 'field-missing', field });
    else if (got === undefined) fault({ code: 'not-a-number', field, got: text });
    else if (!(got >= least && got <= most)) fault({ code: 'out-of-range', field, got, least, most });
    else return got;
    return least;
  };
  const whole = (field: string, least: number, most: number): number => {
    const got = number(field, least, most);
    if (Number.isInteger(got)) return got;
    fault({ code: 'not-a-number', field, got: textOf(field) });
    return least;
  };
  const oneOf = <T extends string>(field: string, known: readonly [T, ...T[]] | readonly T[]): T => {
    const got = textOf(field);
    const found = known.find((each) => each === got);
    if (found === undefined) fault({ code: 'unknown', field, got, known });
    return found ?? (known[0] as T);
  };
  switch (kind) {
    case 'send': {
      const text = textOf('bytes');
      const bytes = fromHex(text);
      if (text === '') fault({ code: 'field-missing', field: 'bytes' });
      else if (bytes === undefined) fault({ code: 'not-bytes', field: 'bytes', got: text });
      else if (bytes.length > MOST_ASCII)
        fault({ code: 'too-long', field: 'bytes', got: bytes.length, most: MOST_ASCII });
      return { kind, bytes: bytes ?? new Uint8Array(), onFailure: oneOf('onFailure', onFailures) };
    }
    case 'wait':
      return { kind, duration: number('duration', 0, LONGEST) };
    case 'repeat': {
      if (steps.length === 0) fault({ code: 'no-steps' });
      return { kind, times: whole('times', 1, MOST_TIMES), steps: readSteps(steps, place, faults) };
    }
    case 'until': {
      const table = oneOf('table', entityTables);
      const address = whole('address', 0, LAST_ADDRESS);
      const type = oneOf('type', plainTypeNames);
      const last = address + elementsOf({ table, type }) - 1;
      if (last > LAST_ADDRESS) fault({ code: 'over-the-end', field: 'address', last });
      // The bits of a float have no meaning of their own, and a coil has only one.
      const bits = isBitTable(table) || numberTypes[type].kind === 'float' ? 0 : 16 * numberTypes[type].registers;
      const bit = textOf('bit') === '' || bits === 0 ? undefined : whole('bit', 0, bits - 1);
      const binary = isBitTable(table) || bit !== undefined;
      return {
        kind,
        unit: whole('unit', 1, LAST_UNIT_NUMBER),
        table,
        address,
        type,
        order: oneOf('order', byteOrders),
        ...(bit !== undefined && { bit }),
        relation: oneOf('relation', relations),
        value: binary ? whole('value', 0, 1) : number('value', -Number.MAX_VALUE, Number.MAX_VALUE),
        interval: number('interval', 0, LONGEST),
        timeout: number('timeout', 1, LONGEST),
        onFailure: oneOf('onFailure', onFailures),
      };
    }
  }
}
