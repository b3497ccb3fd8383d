import type { Field, Reading } from '../../modbus/index.ts';
import { binary, type Expression, type Name, type Parameter, type Routine, type Statement } from '../code.ts';
import { bitsAskedBy, countOf, echoesGroups, echoOf, expectedOf, type Leaf, resultOf } from '../facts.ts';
import { fresh, wordsOf } from '../plain-words.ts';
import { bytesIn, frameChecked } from './check-frame.ts';
import { groupsChecked, MOST_OPEN } from './check-groups.ts';
import type { Envelope } from './envelope.ts';
import { refuse } from './refuse.ts';
import type { RequestBytes } from './request-bytes.ts';
import { byte, declare, element, giveBack, int, loop, name, plus, set, wordOf } from './terms.ts';
import { namesIn, withoutUnused } from './used.ts';
import { formulaTerm, numberIn, replySteps, type Step } from './walk.ts';
import { replyParameters } from './wanted.ts';

const BITS = 8;

/** What checks a reply, and the list that it fills. */
export interface Checking {
  readonly routine: Routine;
  readonly list: Parameter | undefined;
  /** How many elements of the list a good reply fills, if that may be less than all. */
  readonly items: Routine | undefined;
}

/** The routine that checks the reply to a request. `wanted` tells its length; `items`, if it is made, how much of the list is filled. */
export function checking(request: RequestBytes, envelope: Envelope, called: Name, wanted: Name, items: Name): Checking {
  const checker = new Checker(request, envelope, wanted);
  const body = withoutUnused(checker.body());
  return {
    routine: {
      name: called,
      about: [
        'Checks the reply to a request: 0 if it is good, the code of an exception, or one of the faults below 0.',
      ],
      parameters: [
        { name: 'request', type: 'byte', size: envelope.most, comment: 'what was sent' },
        ...replyParameters(envelope),
        ...(checker.list === undefined ? [] : [checker.list]),
      ],
      gives: { kind: 'value', type: 'int' },
      body,
    },
    list: checker.list,
    items: checker.items && itemsRoutine(items, checker.items, replyParameters(envelope)),
  };
}

/** How many elements of the list there are: by a count in the reply, or by how long that is. */
function itemsRoutine(called: Name, body: readonly Statement[], all: readonly Parameter[]): Routine {
  const used = namesIn(body);
  const parameters = all.filter(({ name: of }) => used.has(of));
  const alone = parameters.map((one) => ({
    ...one,
    lengthOf: used.has(one.lengthOf ?? '') ? one.lengthOf : undefined,
  }));
  return {
    name: called,
    about: ['How many elements of the list a good reply fills.'],
    parameters: alone,
    gives: { kind: 'value', type: 'int' },
    body,
  };
}

class Checker {
  list: Parameter | undefined = undefined;
  items: readonly Statement[] | undefined = undefined;
  readonly #request: RequestBytes;
  readonly #reading: Reading;
  readonly #envelope: Envelope;
  readonly #wanted: Name;
  readonly #taken = new Set<Name>([
    'request',
    'reply',
    'reply length',
    'wanted',
    'index',
    'bytes',
    'at',
    'end',
    'group',
    'asked',
    'filled',
  ]);
  readonly #body: Statement[] = [];
  /** How many bytes of the frame there are, and where the PDU ends. */
  readonly #bytes: Expression;
  readonly #end: Expression;

  constructor(request: RequestBytes, envelope: Envelope, wanted: Name) {
    this.#request = request;
    this.#reading = request.reading;
    this.#envelope = envelope;
    this.#wanted = wanted;
    this.#bytes = bytesIn(envelope);
    this.#end = plus(this.#bytes, int(-envelope.tail));
  }

  body(): readonly Statement[] {
    this.#add(...frameChecked(this.#envelope, this.#wanted));
    this.#fields();
    this.#body.push(giveBack(int(0)));
    return this.#body;
  }

  #add(...statements: readonly Statement[]): void {
    this.#body.push(...statements);
  }

  #asked(at: number): Expression {
    return this.#envelope.byteAt('request', int(at));
  }

  /** How many bytes have been seen to be there. */
  #there = 0;

  /** Makes sure that bytes up to a place of the PDU are there. */
  #need(to: number): void {
    if (to <= this.#there) return;
    this.#there = to;
    this.#add(refuse(this.#bytes, '<', int(to + this.#envelope.tail), 'too short'));
  }

  #fields(): void {
    const local = new Map<Field, Expression>();
    const stated = (field: Field) => {
      const one = name('int', fresh(this.#taken, wordsOf(field.name)));
      local.set(field, one);
      return one;
    };
    const steps = replySteps(this.#reading, this.#envelope, stated);
    const last = steps.at(-1);
    const open = last?.size.by === 'end';
    const fields = steps.map(({ field }) => field);
    const fixed = steps.reduce((sum, { field }) => sum + field.width, this.#envelope.code + 1);
    // Its own length told that the frame of RTU is whole, unless only silence ends it.
    if (this.#envelope.transport === 'rtu' && !open) this.#there = fixed;
    this.#need(fixed);
    for (const step of steps) {
      if (step.field.derive !== undefined && step.field.width > 0) this.#count(step, fields, local.get(step.field));
      else if (step.field.width > 0) this.#echo(step);
    }
    if (last === undefined || last.field.width > 0) {
      if (this.#envelope.transport !== 'rtu')
        this.#add(refuse(this.#bytes, '>', int(fixed + this.#envelope.tail), 'too long'));
      return;
    }
    this.#list(last, steps, local);
  }

  /** A count: as it was asked for, and as its list has it. */
  #count({ field, at }: Step, fields: readonly Field[], local: Expression | undefined): void {
    const spans = [field.name];
    const read = numberIn(this.#envelope, field, at);
    if (local?.kind === 'name') this.#add(declare(local.name, read, false, { spans, comment: wordsOf(field.name) }));
    const count = local ?? read;
    const expected = this.#expected(field);
    if (expected !== undefined) this.#add(refuse(count, '≠', expected, 'wrong count', { spans }));
    const { least } = field.range ?? { least: 0 };
    const counted = countOf(field, fields);
    const plusBytes = counted?.by.plus ?? 0;
    if (expected === undefined && plusBytes > 0 && least > 0)
      this.#add(refuse(count, '<', int(plusBytes), 'wrong count', { spans }));
    this.#echoOf(field, at);
  }

  /** The number that a count of the reply must be, by the numbers of the request. */
  #expected(field: Field): Expression | undefined {
    const expected = expectedOf(field, this.#reading);
    if (expected === undefined) return undefined;
    const terms: Expression[] = [];
    for (const { leaf, formula } of expected.terms) {
      const asked = this.#request.leaf(leaf);
      if (asked === undefined) return undefined;
      terms.push(formulaTerm(formula, asked));
    }
    return terms.reduceRight<Expression>((sum, term) => plus(term, sum), int(expected.plus));
  }

  #echo({ field, at }: Step): void {
    this.#echoOf(field, at);
  }

  /** A number that repeats one of the request. */
  #echoOf(field: Field, at: Expression): void {
    const asked = echoOf(field, this.#reading);
    const place = asked === undefined ? undefined : this.#request.place(asked);
    if (place === undefined || place.to - place.from !== field.width) return;
    for (let index = 0; index < field.width; index++)
      this.#add(
        refuse(
          this.#envelope.byteAt('reply', plus(at, int(index))),
          '≠',
          this.#asked(place.from + index),
          'echo differs',
          { spans: [field.name], comment: index === 0 ? `${wordsOf(field.name)}, as in the request` : undefined },
        ),
      );
  }

  #list(step: Step, steps: readonly Step[], local: ReadonlyMap<Field, Expression>): void {
    const { field } = step;
    if (field.group !== undefined && echoesGroups(field, this.#reading)) this.#echoedGroups(step);
    else if (field.group !== undefined) this.#through(step, steps);
    else {
      this.#exactEnd(step);
      const echoed = echoOf(field, this.#reading);
      if (echoed !== undefined) this.#echoedBytes(step, echoed);
      else this.#fill(step, steps, local);
    }
  }

  /** That the frame ends where its list does. */
  #exactEnd({ at, bytes, size }: Step): void {
    if (bytes === undefined || (this.#envelope.transport === 'rtu' && size.by !== 'end')) return;
    const end = plus(plus(at, bytes), int(this.#envelope.tail));
    this.#add(refuse(this.#bytes, '<', end, 'too short'), refuse(this.#bytes, '>', end, 'too long'));
  }

  /** Raw bytes that repeat those of the request. */
  #echoedBytes({ field, at, size }: Step, echoed: string): void {
    const place = this.#request.place(echoed);
    const spans = [field.name];
    const many = place === undefined ? 0 : place.to - place.from;
    const end = plus(at, int(many));
    if (size.by === 'end' || (size.by === 'constant' && size.bytes !== many))
      this.#add(refuse(this.#end, '≠', end, 'echo differs', { spans }));
    if (place === undefined) return;
    const index = name('int', 'index');
    const differs = refuse(
      this.#envelope.byteAt('reply', plus(at, index)),
      '≠',
      this.#envelope.byteAt('request', plus(index, int(place.from))),
      'echo differs',
    );
    this.#add(
      loop('index', int(0), int(many), [differs], { spans, comment: `${wordsOf(field.name)}, as in the request` }),
    );
  }

  /** Takes the items of a list out. */
  #fill(step: Step, steps: readonly Step[], local: ReadonlyMap<Field, Expression>): void {
    const { field, at } = step;
    const width = field.kind === 'registers' ? 2 : 1;
    const bytes = step.bytes ?? binary(this.#end, '-', at);
    const spans = [field.name];
    const items = name('int', 'filled');
    const bitsBy = field.kind === 'bits' ? bitsAskedBy(field, this.#reading) : undefined;
    const asked = bitsBy && this.#request.leaf(bitsBy);
    const value: Expression =
      asked ??
      (field.kind === 'bits' ? binary(int(BITS), '*', bytes) : width === 2 ? binary(bytes, '/', int(2)) : bytes);
    const isExpected = steps.some(
      ({ field: other }) => countOf(other, [field]) && expectedOf(other, this.#reading) !== undefined,
    );
    if (asked === undefined && !isExpected && value.kind !== 'number')
      this.items = withoutUnused([...this.#body.filter(({ kind }) => kind === 'declare'), giveBack(value)]);
    this.#add(declare('filled', value, false));
    for (const other of steps) {
      const counted = other.field.derive && other.field.width > 0 ? countOf(other.field, [field]) : undefined;
      const count = local.get(other.field);
      if (counted === undefined || count === undefined || field.kind === 'bits') continue;
      // A count that is what was asked for makes whole items; and what a list is measured by is right by itself.
      const isSize = step.count === count && width === 1 && step.size.by === 'count';
      if (!isSize && expectedOf(other.field, this.#reading) === undefined)
        this.#add(refuse(count, '≠', formulaTerm(counted.by, items), 'wrong count', { spans: [other.field.name] }));
    }
    const room = this.#room(step, steps, bitsBy);
    const called = fresh(this.#taken, wordsOf(field.name));
    const type = field.kind === 'bits' ? 'bool' : width === 2 ? 'word' : 'byte';
    this.list = { name: called, type, size: room, filled: true, comment: `${wordsOf(field.name)} of the reply` };
    const index = name('int', 'index');
    this.#add(
      refuse(items, '>', int(room), 'wrong count', { comment: 'more than there is room for' }),
      loop('index', int(0), items, [set(element(type, called, index), this.#item(field, at, index))], { spans }),
    );
  }

  #item({ kind }: Field, at: Expression, index: Expression): Expression {
    const { byteAt } = this.#envelope;
    if (kind === 'bits') {
      const one = byteAt('reply', plus(at, binary(index, '/', int(BITS))));
      return binary(binary(binary(one, '>>', binary(index, '%', int(BITS))), '&', byte(1)), '≠', byte(0));
    }
    if (kind !== 'registers') return byteAt('reply', plus(at, index));
    const first = plus(at, binary(int(2), '*', index));
    return wordOf(byteAt('reply', first), byteAt('reply', plus(first, int(1))));
  }

  /** How many items the list has room for: as many as are asked for now, else as many as a reply can have. */
  #room({ field, size, bytes }: Step, steps: readonly Step[], bitsBy: Leaf | undefined): number {
    const now = bitsBy && this.#reading.fields[bitsBy.name];
    if (typeof now === 'number' && now > 0) return now;
    const width = field.kind === 'registers' ? 2 : 1;
    const each = field.kind === 'bits' ? BITS : 1 / width;
    if (bytes?.kind === 'number') return Math.max(1, bytes.value * each);
    if (size.by === 'count' || size.by === 'items') {
      const kind = size.by === 'count' ? 'count' : 'quantity';
      const by = steps.find(
        (one) => one.field.derive && one.field.width > 0 && (one.field.kind === 'count') === (kind === 'count'),
      );
      const most = by && (this.#askedNow(by.field) ?? by.field.range?.most);
      if (most !== undefined) return Math.max(1, Math.floor(resultOf(size.formula, most) * each));
    }
    return MOST_OPEN;
  }

  /** What a count must be in the reply to the current request. */
  #askedNow(field: Field): number | undefined {
    const expected = expectedOf(field, this.#reading);
    if (expected === undefined) return undefined;
    return expected.terms.reduce(
      (sum, { leaf, formula }) => sum + resultOf(formula, this.#valueOf(leaf)),
      expected.plus,
    );
  }

  #valueOf({ name: of, group }: Leaf): number {
    const { fields } = this.#reading;
    const list = group && (fields[group.list] as readonly Readonly<Record<string, unknown>>[]);
    return Number(group === undefined ? fields[of] : list?.[group.index]?.[of]);
  }

  /** Groups that repeat those of the request, whose length their count tells. */
  #echoedGroups(step: Step): void {
    const place = this.#request.place(step.field.name);
    if (place === undefined) return;
    const spans = [step.field.name];
    const index = name('int', 'index');
    const end = int(place.to);
    this.#add(
      refuse(this.#end, '≠', plus(step.at, int(place.to - place.from)), 'echo differs', { spans }),
      loop(
        'index',
        int(this.#envelope.code + 1),
        end,
        [refuse(this.#envelope.byteAt('reply', index), '≠', this.#envelope.byteAt('request', index), 'echo differs')],
        { spans, comment: 'all groups, as in the request' },
      ),
    );
  }

  /** Group after group: that they fill the reply, are as they were asked for, and what they hold. */
  #through(step: Step, steps: readonly Step[]): void {
    if (step.bytes !== undefined && this.#envelope.transport !== 'rtu') this.#exactEnd(step);
    const called = (wanted: Name) => fresh(this.#taken, wanted);
    const context = { request: this.#request, envelope: this.#envelope, end: this.#end, steps, called };
    const { body, list } = groupsChecked(step, context);
    this.#add(...body);
    this.list = list;
  }
}
