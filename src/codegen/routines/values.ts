import { isBitTable, isScaled, type NamedValue, namedValues, type Profile, unitScale } from '../../devices/index.ts';
import { firstAddress, isNumberType, numberTypes, type Reading } from '../../modbus/index.ts';
import { plainWords } from '../../notation/index.ts';
import { binary, type Expression, type Name, type Routine, type Scalar } from '../code.ts';
import { echoOf } from '../facts.ts';
import { wordsOf } from '../plain-words.ts';
import type { ReplyValue } from '../plan.ts';
import type { Envelope } from './envelope.ts';
import { numberAt, takenTypes } from './numbers.ts';
import { unitsTerm } from './scaled.ts';
import { byte, giveBack, int, plus } from './terms.ts';
import { numberIn, replySteps, type Step } from './walk.ts';

/** A value of a reply, and the routine that takes it out. */
export interface Taking {
  readonly routine: Routine;
  readonly value: ReplyValue;
}

export interface Takings {
  readonly takings: readonly Taking[];
  /** Names of values that stand in the list only. */
  readonly rawOnly: readonly string[];
}

/** What the values of a reply are taken out by. `free` makes a name of a routine that nobody has. */
export interface TakingContext {
  readonly reading: Reading;
  readonly envelope: Envelope;
  readonly profile: Profile | undefined;
  readonly units: boolean;
  /** The list of the reply, and how many items it has room for. */
  readonly items: number;
  readonly free: (wanted: Name) => Name;
}

/** The plain numbers of a reply, and the values that a device has in its list. */
export function takingsOf(context: TakingContext): Takings {
  const { reading, envelope, profile } = context;
  const steps = replySteps(reading, envelope);
  const takings = steps.filter((step) => isOwn(step, reading)).map((step) => plainTaking(step, context));
  const last = steps.at(-1);
  const table = reading.description?.table;
  const lists = last !== undefined && (last.field.kind === 'registers' || last.field.kind === 'bits');
  if (profile === undefined || !lists || table === undefined || table === 'file-record')
    return { takings, rawOnly: [] };
  const first = firstAddress({ direction: 'response', fields: {}, request: reading }, last.field.name);
  if (first === undefined) return { takings, rawOnly: [] };
  const rawOnly: string[] = [];
  const zeros = new Array<number>(context.items).fill(0);
  for (const named of namedValues(profile, table, first, zeros)) {
    const taking = named.cutOff ? undefined : namedTaking(named, last, context);
    if (taking === undefined) rawOnly.push(named.name);
    else takings.push(taking);
  }
  return { takings, rawOnly };
}

/** Whether a field of a reply is a number that only the reply has. */
const isOwn = ({ field }: Step, reading: Reading): boolean =>
  field.plain &&
  field.derive === undefined &&
  echoOf(field, reading) === undefined &&
  reading.fields[field.name] === undefined;

function plainTaking({ field, at }: Step, context: TakingContext): Taking {
  const said = wordsOf(field.name);
  return taking(context, said, numberIn(context.envelope, field, at), '', [field.name], `The ${said} of a good reply.`);
}

function namedTaking({ register, name, at }: NamedValue, list: Step, context: TakingContext): Taking | undefined {
  const { envelope, units } = context;
  const said = plainWords(name);
  const about = `${name}, of a good reply.`;
  const spans = [list.field.name];
  if (isBitTable(register.table)) {
    const one = envelope.byteAt('reply', plus(list.at, int(at >> 3)));
    const bit = binary(binary(one, '&', byte(1 << (at & 7))), '≠', byte(0));
    return taking(context, said, bit, '', spans, about);
  }
  // A number of 64 bits has more digits than a program's own.
  if (!isNumberType(register.type) || !takenTypes.has(register.type) || numberTypes[register.type].registers === 4)
    return undefined;
  // Nor is a part of a number taken out, nor the power of ten that stands in another register.
  if (register.mask !== undefined || register.scaleRegister !== undefined) return undefined;
  const raw = numberAt(envelope, plus(list.at, int(2 * at)), register.type, register.order);
  const scale = units ? unitScale(register) : undefined;
  const value = scale !== undefined && isScaled(register) ? unitsTerm(raw, scale) : raw;
  return taking(context, said, value, scale === undefined ? '' : register.unit, spans, about);
}

function taking(
  { envelope, free }: TakingContext,
  said: Name,
  value: Expression,
  unit: string,
  spans: readonly string[],
  about: string,
): Taking {
  const routine = free(said);
  const type: Scalar = value.type;
  return {
    routine: {
      name: routine,
      about: [unit === '' ? about : `${about.slice(0, -1)}, in ${unit}.`],
      parameters: [{ name: 'reply', type: 'byte', size: envelope.most, comment: 'a good reply' }],
      gives: { kind: 'value', type },
      body: [giveBack(value, { spans })],
    },
    value: { routine, name: said, type, unit },
  };
}
