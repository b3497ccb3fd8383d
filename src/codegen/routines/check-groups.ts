import type { Field } from '../../modbus/index.ts';
import { binary, type Expression, type Name, type Parameter, type Statement } from '../code.ts';
import { countOf, groupLengths, oneGroupOf } from '../facts.ts';
import { wordsOf } from '../plain-words.ts';
import type { Envelope } from './envelope.ts';
import { refuse } from './refuse.ts';
import type { RequestBytes } from './request-bytes.ts';
import { byte, declare, element, int, loop, name, plus, set, times, when, wordOf } from './terms.ts';
import { fixedBytes, formulaTerm, numberIn, type Step, stepsFrom } from './walk.ts';

/** Most bytes of a list that only the frame's end bounds. */
export const MOST_OPEN = 252;

export interface GroupsContext {
  readonly request: RequestBytes;
  readonly envelope: Envelope;
  /** Where the PDU of the reply ends. */
  readonly end: Expression;
  /** All fields of the reply. */
  readonly steps: readonly Step[];
  /** A name that nobody has. */
  readonly called: (wanted: Name) => Name;
}

const [at, end, group, filled, index] = ['at', 'end', 'group', 'filled', 'index'].map((one) => name('int', one)) as [
  Variable,
  Variable,
  Variable,
  Variable,
  Variable,
];
type Variable = ReturnType<typeof name>;

/** Checks groups one after another, and takes out the registers in them; of groups without registers, their bytes. */
export function groupsChecked(step: Step, context: GroupsContext): { body: readonly Statement[]; list: Parameter } {
  const { field } = step;
  const registers = field.group?.find(({ kind }) => kind === 'registers');
  return registers === undefined ? bytesOfGroups(step, context) : registersOfGroups(step, registers, context);
}

/** That one group is there whole, and where the next begins. */
function groupWhole(
  fields: readonly Field[],
  envelope: Envelope,
): { body: readonly Statement[]; next: Expression; inner: readonly Step[] } {
  const inner = stepsFrom(fields, at, envelope);
  const fixed = fixedBytes(fields);
  const last = inner.at(-1);
  const body: Statement[] = [refuse(plus(at, int(fixed)), '>', end, 'wrong count')];
  for (const { field, at: place } of inner) {
    const counted = field.derive !== undefined && field.width > 0 ? countOf(field, fields) : undefined;
    if (counted === undefined) continue;
    const read = numberIn(envelope, field, place);
    const { plus: besides, times: each } = counted.by;
    if (besides > 0) body.push(refuse(read, '<', int(besides), 'wrong count'));
    if (each > 1) body.push(refuse(binary(plus(read, int(-besides)), '%', int(each)), '≠', int(0), 'wrong count'));
  }
  return { body, next: last === undefined ? plus(at, int(fixed)) : plus(last.at, last.bytes ?? int(0)), inner };
}

function bytesOfGroups(step: Step, context: GroupsContext): { body: readonly Statement[]; list: Parameter } {
  const { field, at: from, items, size } = step;
  const { envelope, called } = context;
  const spans = [field.name];
  const comment = wordsOf(field.name);
  const { body: whole, next } = groupWhole(field.group ?? [], envelope);
  const one = [...whole, set(at, next)];
  const through: Statement =
    size.by === 'groups' && items !== undefined
      ? loop('group', int(0), items, field.fewer ? [when(binary(at, '<', end), one)] : one, { spans, comment })
      : { kind: 'while', when: binary(at, '<', end), body: one, spans, comment };
  const list: Parameter = {
    name: called(wordsOf(field.name)),
    type: 'byte',
    size: MOST_OPEN,
    filled: true,
    comment: `${comment} of the reply, as they are sent`,
  };
  const many = binary(end, '-', from);
  return {
    list,
    body: [
      declare('end', context.end, false),
      declare('at', from, true),
      through,
      refuse(at, '≠', end, 'wrong count', { spans }),
      ...oneGroup(step, context),
      refuse(many, '>', int(MOST_OPEN), 'wrong count'),
      loop(
        'index',
        int(0),
        many,
        [set(element('byte', list.name, index), envelope.byteAt('reply', plus(from, index)))],
        {
          spans,
        },
      ),
    ],
  };
}

/** That the only group is the one that was asked for. */
function oneGroup({ field, at: from }: Step, { request, envelope, steps }: GroupsContext): readonly Statement[] {
  const rule = oneGroupOf(field, request.reading);
  const asked = rule && request.place(rule.repeats);
  if (rule === undefined || asked === undefined) return [];
  const inner = stepsFrom(field.group ?? [], from, envelope);
  const last = inner.at(-1);
  const answered = inner.find(({ field: one }) => one.name === rule.repeats);
  if (last === undefined || answered === undefined) return [];
  const differs = [
    refuse(plus(from, int(fixedBytes(field.group ?? []))), '>', end, 'echo differs'),
    refuse(plus(last.at, last.bytes ?? int(0)), '≠', end, 'echo differs'),
    refuse(numberIn(envelope, answered.field, answered.at), '≠', request.number(asked), 'echo differs'),
  ];
  if (rule.when === undefined) return differs;
  const { name: choice, value } = rule.when;
  const place = request.place(choice);
  const step = steps.find(({ field: one }) => one.name === choice);
  if (place === undefined || step === undefined) return [];
  const both = binary(
    binary(envelope.byteAt('request', int(place.from)), '=', byte(value)),
    'and',
    binary(envelope.byteAt('reply', step.at), '=', byte(value)),
  );
  return [
    when(both, differs, [], { comment: `${wordsOf(choice)} ${value}: one, as in the request`, spans: [field.name] }),
  ];
}

function registersOfGroups(
  step: Step,
  registers: Field,
  context: GroupsContext,
): { body: readonly Statement[]; list: Parameter } {
  const { field, at: from } = step;
  const { envelope, request, steps, called } = context;
  const spans = [field.name];
  const { body: whole, next, inner } = groupWhole(field.group ?? [], envelope);
  const place = inner.find(({ field: one }) => one === registers);
  const words = binary(place?.bytes ?? int(0), '/', int(2));
  const count = steps.find(({ field: one }) => one.derive !== undefined && one.width > 0)?.field;
  const lengths = count && groupLengths(field, count, request.reading);
  const asked = lengths && request.groups(lengths.leaf);
  const room =
    asked === undefined || lengths === undefined
      ? MOST_OPEN / 2
      : Math.max(
          1,
          asked.values.reduce((sum, one) => sum + one, 0),
        );
  const list: Parameter = {
    name: called(wordsOf(registers.name)),
    type: 'word',
    size: room,
    filled: true,
    comment: `${wordsOf(registers.name)} of all groups, one after another`,
  };
  const first = plus(place?.at ?? at, times(2, index));
  const asAsked =
    asked === undefined || lengths === undefined
      ? []
      : [
          refuse(group, '≥', int(asked.values.length), 'wrong count'),
          refuse(
            place?.bytes ?? int(0),
            '≠',
            formulaTerm(
              lengths.formula,
              request.numberAt(plus(int(asked.from), times(asked.stride, group)), asked.width),
            ),
            'wrong count',
          ),
        ];
  const one: Statement[] = [
    ...whole,
    ...asAsked,
    refuse(next, '>', end, 'wrong count'),
    refuse(plus(filled, words), '>', int(room), 'wrong count'),
    loop('index', int(0), words, [
      set(
        element('word', list.name, filled),
        wordOf(envelope.byteAt('reply', first), envelope.byteAt('reply', plus(first, int(1)))),
      ),
      set(filled, plus(filled, int(1))),
    ]),
    set(at, next),
    ...(asAsked.length === 0 ? [] : [set(group, plus(group, int(1)))]),
  ];
  return {
    list,
    body: [
      declare('end', context.end, false),
      declare('at', from, true),
      declare('filled', int(0), true),
      ...(asAsked.length === 0 ? [] : [declare('group', int(0), true)]),
      { kind: 'while', when: binary(at, '<', end), body: one, spans, comment: wordsOf(field.name) },
    ],
  };
}
