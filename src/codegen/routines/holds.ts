import { isBitTable } from '../../devices/index.ts';
import { numberTypes, type Order, type Reading, registerPlaces } from '../../modbus/index.ts';
import type { Until } from '../../sequences/index.ts';
import { binary, convert, type Expression, type Name, number, type Routine, type Statement } from '../code.ts';
import type { Envelope } from './envelope.ts';
import { numberAt } from './numbers.ts';
import { byte, giveBack, int, name, toInt, when } from './terms.ts';
import { replySteps } from './walk.ts';

const INT_MOST = 2 ** 31 - 1;
const DWORD_MOST = 2 ** 32 - 1;
const FALSE: Expression = { kind: 'truth', type: 'bool', value: false };

/** A condition of a sequence, as a routine `(reply) → bool`. */
export function holdsRoutine(until: Until, reading: Reading, envelope: Envelope, called: Name, about: string): Routine {
  const at = replySteps(reading, envelope).at(-1)?.at;
  const value = at && valueOfReply(until, envelope, at);
  if (value === undefined) throw new TypeError('a condition on a reply without a list');
  const isBcd = !isBitTable(until.table) && numberTypes[until.type].kind === 'bcd' && until.bit === undefined;
  const got = name(value.type, 'value');
  const body: Statement[] = [{ kind: 'declare', name: 'value', value, changes: false }];
  if (isBcd) body.push(when(binary(got, '<', int(0)), [giveBack(FALSE)], [], { comment: 'a digit above 9' }));
  body.push(giveBack(compared(got, until)));
  return {
    name: called,
    about: [about],
    parameters: [{ name: 'reply', type: 'byte', size: envelope.most, comment: 'a good reply' }],
    gives: { kind: 'value', type: 'bool' },
    body,
  };
}

function valueOfReply({ table, type, order, bit }: Until, envelope: Envelope, at: Expression): Expression {
  if (isBitTable(table)) return toInt(binary(envelope.byteAt('reply', at), '&', byte(1)));
  if (bit === undefined) return numberAt(envelope, at, type, order);
  // The bits of a number are those of the unsigned one; of BCD, of the number that the digits make.
  const { registers, kind } = numberTypes[type];
  if (registers === 4) {
    const half = bit < 32 ? 4 : 0;
    const low = lowHalfFirst(order) ? 4 - half : half;
    const part = numberAt(envelope, shifted(at, low), 'u32', order);
    return toInt(binary(binary(part, '>>', int(bit % 32)), '&', number('dword', 1)));
  }
  if (kind === 'bcd') {
    const whole = numberAt(envelope, at, type, order);
    return binary(binary(whole, '/', int(2 ** bit)), '%', int(2));
  }
  const whole = numberAt(envelope, at, registers === 1 ? 'u16' : 'u32', order);
  const wide = convert('dword', whole);
  return toInt(binary(binary(wide, '>>', int(bit)), '&', number('dword', 1)));
}

const lowHalfFirst = (order: Order): boolean => (registerPlaces(order, 4)[0] ?? 0) >= 2;

const shifted = (at: Expression, by: number): Expression =>
  at.kind === 'number' ? int(at.value + by) : binary(at, '+', int(by));

/** The comparison: of whole numbers where both are, else of `real`. Nothing is equal to a float that is no number. */
function compared(got: Expression, { relation, value }: Until): Expression {
  const most = got.type === 'dword' ? DWORD_MOST : INT_MOST;
  const least = got.type === 'dword' ? 0 : -INT_MOST;
  const whole = got.type !== 'real' && Number.isInteger(value) && value >= least && value <= most;
  if (whole) return binary(got, relation, number(got.type, value, 10));
  const [left, right] = [convert('real', got), number('real', value)];
  if (relation === '=') return binary(binary(left, '≥', right), 'and', binary(left, '≤', right));
  if (relation === '≠') return binary(binary(left, '<', right), 'or', binary(left, '>', right));
  return binary(left, relation, right);
}
