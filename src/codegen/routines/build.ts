import { type Field, fieldsOf, type Reading, type Values } from '../../modbus/index.ts';
import {
  binary,
  convert,
  type Expression,
  type Name,
  number,
  type Routine,
  type Scalar,
  type Statement,
} from '../code.ts';
import { bytesOf, flagBytes } from '../facts.ts';
import { fresh, wordsOf } from '../plain-words.ts';
import type { BuildArgument } from '../plan.ts';
import type { Envelope } from './envelope.ts';
import {
  byte,
  declare,
  element,
  highByte,
  int,
  loop,
  lowByte,
  name,
  plus,
  type Remarks,
  set,
  times,
  when,
} from './terms.ts';

/** The routine that builds a request, and what its parameters are in it. */
export interface Building {
  readonly routine: Routine;
  readonly arguments: readonly BuildArgument[];
  /** Groups that are constant because they have too many numbers. */
  readonly constant: readonly string[];
}

/** More numbers than these in groups are constant bytes. */
const MOST_IN_GROUPS = 12;
const BITS = 8;

/** What is said of a field's parameter. */
export type Explained = (field: string) => string;

/** The routine that builds this request from its parameters. */
export function building(
  reading: Reading,
  envelope: Envelope,
  called: Name,
  about: readonly string[],
  explained: Explained,
): Building {
  const made = new Maker(envelope, explained);
  made.request(reading);
  return {
    routine: {
      name: called,
      about,
      parameters: made.arguments.map(({ parameter }) => parameter),
      gives: { kind: 'frame', most: made.length },
      body: made.body,
    },
    arguments: made.arguments,
    constant: made.constant,
  };
}

class Maker {
  readonly arguments: BuildArgument[] = [];
  readonly constant: string[] = [];
  body: Statement[] = [];
  length = 0;
  readonly #taken = new Set<Name>(['frame', 'checksum', 'length', 'index', 'bit', 'packed', 'at']);
  readonly #envelope: Envelope;
  readonly #explained: Explained;

  constructor(envelope: Envelope, explained: Explained) {
    this.#envelope = envelope;
    this.#explained = explained;
  }

  request(reading: Reading): void {
    const { description, fields, unitId = 0, transactionId = 0, functionCode = 0, transport } = reading;
    const bare = transport === 'pdu';
    const unit = bare ? byte(0) : this.#parameter('unit', 'byte', unitId, 'unitId');
    const transaction =
      transport === 'tcp' ? this.#parameter('transaction', 'word', transactionId, 'transactionId') : number('word', 0);
    this.#put(byte(functionCode), { spans: ['functionCode'], comment: `function ${this.#explained('functionCode')}` });
    const list = [...fieldsOf(description, 'request', fields)].map(({ field }) => field);
    const deciding = decidingFields(reading);
    this.#fields(list, fields, (field) => deciding.has(field.name), '');
    const pduBytes = this.#bytes;
    const inside = this.body;
    this.body = [...this.#envelope.head(pduBytes, transaction)];
    if (!bare) this.#put(unit, { spans: ['unitId'], comment: 'unit' });
    this.body.push(...inside, ...this.#envelope.end);
    const { lengthOf, code, tail } = this.#envelope;
    const whole = lengthOf(int(code + pduBytes + tail));
    this.length = whole.kind === 'number' ? whole.value : 0;
  }

  #bytes = 0;

  #put(value: Expression, remarks: Remarks): void {
    this.body.push(...this.#envelope.put(value, remarks));
    this.#bytes++;
  }

  #parameter(wanted: Name, type: Scalar, value: number, field: string): Expression {
    const called = fresh(this.#taken, wanted);
    this.arguments.push({ parameter: { name: called, type, comment: this.#explained(field) }, value });
    return name(type, called);
  }

  #array(wanted: Name, type: Scalar, value: readonly number[], field: string): Name {
    const called = fresh(this.#taken, wanted);
    const comment = this.#explained(field);
    this.arguments.push({ parameter: { name: called, type, size: value.length, comment }, value });
    return called;
  }

  #fields(list: readonly Field[], values: Values, isConstant: (field: Field) => boolean, suffix: string): void {
    for (const field of list) {
      const value = values[field.name];
      const said = wordsOf(field.name) + suffix;
      if (field.derive !== undefined) this.#derived(field, values, said);
      else if (field.group !== undefined) this.#groups(field, value as readonly Values[]);
      else if (field.plain) {
        const of = isConstant(field)
          ? number(typeOf(field), Number(value))
          : this.#parameter(said, typeOf(field), Number(value), field.name);
        this.#number(field, of, said);
      } else if (field.kind === 'flag') this.#flag(field, value === true || value === 1, said);
      else if (field.kind === 'registers') this.#list(said, 'word', value as readonly number[], field, 2);
      else if (field.kind === 'bits') this.#bits(said, value as readonly number[], field);
      else if (field.kind === 'list') this.#list(said, 'byte', value as readonly number[], field, 1);
      else if (field.kind === 'bytes') this.#list(said, 'byte', bytesOf(value), field, 1);
      else throw new TypeError(`${field.name}: a field of kind ${field.kind}`);
    }
  }

  #number({ name: of, width }: Field, value: Expression, said: string): void {
    const spans = [of];
    if (width === 2) this.#put(constantOr(value, BITS), { spans, comment: `${said}, high byte` });
    this.#put(constantOr(value, 0), { spans, comment: width === 2 ? `${said}, low byte` : said });
  }

  /** A count follows from the lengths of lists, which do not change. */
  #derived(field: Field, values: Values, said: string): void {
    const value = Number(field.derive?.(values));
    this.#number(field, number(typeOf(field), value), `${said}: ${value}`);
  }

  #flag(field: Field, value: boolean, said: string): void {
    const of = this.#parameter(said, 'bool', value ? 1 : 0, field.name);
    const { on, off } = flagBytes(field);
    const spans = [field.name];
    const side = (bytes: readonly number[], comment: string) =>
      bytes.flatMap((one, index) =>
        this.#envelope.put(byte(one), { spans, comment: index === 0 ? comment : undefined }),
      );
    this.body.push(when(of, side(on, `${said}: on`), side(off, `${said}: off`), { spans }));
    this.#bytes += on.length;
  }

  #list(said: string, type: 'word' | 'byte', value: readonly number[], field: Field, width: 1 | 2): void {
    if (value.length === 0) return;
    const spans = [field.name];
    const of = this.#array(said, type, value, field.name);
    const item = element(type, of, name('int', 'index'));
    const parts = width === 2 ? [highByte(item), lowByte(item)] : [item];
    const body = parts.flatMap((part) => this.#envelope.put(part, { spans }));
    this.body.push(loop('index', int(0), int(value.length), body, { spans, comment: said }));
    this.#bytes += width * value.length;
  }

  /** Eight bits a byte, the first in its lowest bit. */
  #bits(said: string, value: readonly number[], field: Field): void {
    if (value.length === 0) return;
    const spans = [field.name];
    const of = this.#array(said, 'bool', value, field.name);
    const [packed, at] = [name('byte', 'packed'), name('int', 'at')];
    const bytes = Math.ceil(value.length / BITS);
    const here = (index: Expression, bit: Expression) =>
      when(element('bool', of, index), [set(packed, binary(packed, '|', binary(byte(1), '<<', bit)))]);
    const first = times(BITS, name('int', 'index'));
    const fits = value.length % BITS === 0;
    const one = here(at, name('int', 'bit'));
    this.body.push(
      loop(
        'index',
        int(0),
        int(bytes),
        [
          declare('packed', byte(0), true),
          loop('bit', int(0), int(BITS), [
            declare('at', plus(first, name('int', 'bit')), false),
            fits ? one : when(binary(at, '<', int(value.length)), [one]),
          ]),
          ...this.#envelope.put(packed, { spans }),
        ],
        { spans, comment: `${said}, eight a byte, the first in the lowest bit` },
      ),
    );
    this.#bytes += bytes;
  }

  #groups(field: Field, list: readonly Values[]): void {
    const group = field.group ?? [];
    const numbers = list.reduce((sum, item) => sum + numbersIn(group, item), 0);
    if (numbers > MOST_IN_GROUPS) {
      this.constant.push(field.name);
      const accepted = field.accept(list, field.name);
      const out = new Uint8Array(field.length(accepted));
      field.write(out, 0, accepted, undefined);
      for (const [index, one] of out.entries())
        this.#put(byte(one), { spans: [field.name], comment: index === 0 ? wordsOf(field.name) : undefined });
      return;
    }
    for (const [index, item] of list.entries())
      this.#group(field, group, item, list.length === 1 ? '' : ` ${index + 1}`);
  }

  /** The bytes of a group belong to the span of the list it is in. */
  #group(field: Field, group: readonly Field[], item: Values, suffix: string): void {
    const only = ({ allowed }: Field) => allowed?.length === 1;
    const before = this.body;
    this.body = [];
    this.#fields(group, item, only, suffix);
    const inside = this.body.map((one) => within(one, field.name));
    this.body = [...before, ...inside];
  }
}

/** The statement with the span of the list around it added. */
function within(statement: Statement, span: string): Statement {
  const spans = statement.spans && [span];
  if (statement.kind !== 'for') return { ...statement, spans };
  return { ...statement, spans, body: statement.body.map((one) => within(one, span)) };
}

const numbersIn = (group: readonly Field[], item: Values): number =>
  group.reduce((sum, field) => {
    const value = item[field.name];
    if (field.derive !== undefined || field.allowed?.length === 1) return sum;
    return sum + (Array.isArray(value) ? value.length : typeof value === 'string' ? value.length / 2 : 1);
  }, 0);

/** The fields whose values decide which fields follow. */
export function decidingFields({ description, fields }: Reading): ReadonlySet<string> {
  const found = new Set<string>();
  let layout = description?.request;
  while (layout?.then !== undefined) {
    const { by, cases, otherwise }: NonNullable<typeof layout.then> = layout.then;
    found.add(by);
    const value = fields[by];
    layout = typeof value === 'number' ? (cases[value] ?? otherwise) : undefined;
  }
  return found;
}

const typeOf = ({ width }: Field): 'byte' | 'word' => (width === 1 ? 'byte' : 'word');

/** A byte of a number, from a bit on; a constant at once. */
function constantOr(value: Expression, shift: number): Expression {
  if (value.kind === 'number') return byte((value.value >> shift) & 0xff);
  return shift === 0 ? convert('byte', value) : highByte(value);
}
