import { type Field, fieldsOf, type Reading } from '../../modbus/index.ts';
import { binary, type Expression } from '../code.ts';
import { type Formula, type Size, sizeOf } from '../facts.ts';
import type { Envelope } from './envelope.ts';
import { int, plus, times, toInt, wordOf } from './terms.ts';

/** A field of a reply, where it begins, and how long it is if it is a list. */
export interface Step {
  readonly field: Field;
  readonly at: Expression;
  readonly size: Size;
  /** Bytes, as an `int`; `undefined` if only a walk through them tells, or the end of the frame. */
  readonly bytes: Expression | undefined;
  /** The numbers that a count and a quantity before it state. */
  readonly count: Expression | undefined;
  readonly items: Expression | undefined;
}

/** `times × n / by`, rounded up, and `plus`. */
export function formulaTerm({ times: factor, by, plus: more }: Formula, n: Expression): Expression {
  const scaled = times(factor, n);
  return plus(by === 1 ? scaled : binary(plus(scaled, int(by - 1)), '/', int(by)), int(more));
}

/** The number that a field of one or two bytes holds in the array `reply`, as an `int`. */
export const numberIn = (envelope: Envelope, { width }: Field, at: Expression): Expression =>
  toInt(
    width === 1
      ? envelope.byteAt('reply', at)
      : wordOf(envelope.byteAt('reply', at), envelope.byteAt('reply', plus(at, int(1)))),
  );

/**
 * The fields one after another from a place on. What follows a list without a known length is left out. `stated` answers how
 * the number of a count is read again.
 */
export function stepsFrom(
  fields: readonly Field[],
  from: Expression,
  envelope: Envelope,
  stated: (field: Field, at: Expression) => Expression = (field, at) => numberIn(envelope, field, at),
): readonly Step[] {
  const steps: Step[] = [];
  let at = from;
  let count: Expression | undefined;
  let items: Expression | undefined;
  for (const field of fields) {
    const size: Size = field.width > 0 ? { by: 'constant', bytes: field.width } : sizeOf(field);
    const decides = size.by === 'count' ? count : size.by === 'items' ? items : undefined;
    const bytes =
      size.by === 'constant'
        ? int(size.bytes)
        : 'formula' in size && decides !== undefined
          ? formulaTerm(size.formula, decides)
          : undefined;
    steps.push({ field, at, size, bytes, count, items });
    if (bytes === undefined) break;
    if (field.derive !== undefined && field.width > 0) {
      const number = stated(field, at);
      if (field.kind === 'count') count = number;
      else items = number;
    }
    at = plus(at, bytes);
  }
  return steps;
}

/** The fields of the reply to a request; a choice is taken as the request has it. */
export const replySteps = (
  { description, fields }: Reading,
  envelope: Envelope,
  stated?: (field: Field, at: Expression) => Expression,
): readonly Step[] =>
  stepsFrom(
    [...fieldsOf(description, 'response', fields)].map(({ field }) => field),
    int(envelope.code + 1),
    envelope,
    stated,
  );

/** The bytes from a group's start that are there whatever its lists hold, up to and with the last count. */
export const fixedBytes = (group: readonly Field[]): number => group.reduce((sum, { width }) => sum + width, 0);
