import type { Reading } from '../../modbus/index.ts';
import { binary, type Name, type Routine, type Statement } from '../code.ts';
import { asciiCharacters, type Envelope } from './envelope.ts';
import { byte, declare, element, giveBack, int, loop, name, plus, set, toInt, when, wordOf } from './terms.ts';
import { fixedBytes, replySteps, type Step, stepsFrom } from './walk.ts';

const length = name('int', 'reply length');
const at = name('int', 'at');
const EXCEPTION = 0x80;
/** Unit, function, code and CRC. */
const EXCEPTION_BYTES = 5;

/** The routine `(reply, reply length) → int` that says how long the whole reply is. */
export function wantedRoutine(reading: Reading, envelope: Envelope, called: Name): Routine {
  const { transport } = reading;
  const bodies = {
    rtu: () => byFields(reading, envelope),
    ascii: byLineEnd,
    tcp: byHeader,
    pdu: () => [giveBack(int(0))],
  };
  return {
    name: called,
    about: [
      transport === 'ascii' ? 'How many characters the whole reply has,' : 'How many bytes the whole reply has,',
      'or how many must be there before more can be said; 0 if only silence ends it.',
    ],
    parameters: replyParameters(envelope),
    gives: { kind: 'value', type: 'int' },
    body: bodies[transport](),
  };
}

/** What was received. */
export const replyParameters = (envelope: Envelope): Routine['parameters'] => [
  { name: 'reply', type: 'byte', size: envelope.most, comment: 'what was received' },
  { name: 'reply length', type: 'int', lengthOf: 'reply', comment: 'how much of it was received' },
];

/** The end of the header's length field, and the bytes that it does not count. */
const COUNTED_FROM = 6;

const byHeader = (): readonly Statement[] => [
  when(binary(length, '<', int(COUNTED_FROM)), [giveBack(int(COUNTED_FROM))]),
  giveBack(plus(toInt(wordOf(element('byte', 'reply', int(4)), element('byte', 'reply', int(5)))), int(COUNTED_FROM)), {
    spans: ['length'],
    comment: 'the header counts the bytes behind it',
  }),
];

const byLineEnd = (): readonly Statement[] => [
  when(binary(length, '>', int(0)), [
    when(
      binary(element('byte', 'reply', binary(length, '-', int(1))), '=', byte(asciiCharacters.lf)),
      [giveBack(length)],
      [],
      { comment: 'LF ends the frame' },
    ),
  ]),
  giveBack(plus(length, int(1))),
];

function byFields(reading: Reading, envelope: Envelope): readonly Statement[] {
  const { code, tail } = envelope;
  const steps = replySteps(reading, envelope);
  const last = steps.at(-1);
  const open = last?.size.by === 'end';
  const fixed = code + 1 + steps.reduce((sum, { field }) => sum + field.width, 0) + tail;
  const counts = steps.filter(({ field }) => field.derive !== undefined && field.width > 0);
  const first = placeBehind(counts[0]) ?? code + 1;
  const body: Statement[] = [
    when(binary(length, '<', int(Math.max(code + 1, Math.min(first, EXCEPTION_BYTES)))), [
      giveBack(int(Math.min(fixed, EXCEPTION_BYTES))),
    ]),
    when(
      binary(binary(envelope.byteAt('reply', int(code)), '&', byte(EXCEPTION)), '≠', byte(0)),
      [giveBack(int(EXCEPTION_BYTES))],
      [],
      { comment: 'an exception', spans: ['functionCode'] },
    ),
  ];
  if (open || last === undefined) return [...body, giveBack(int(open ? 0 : fixed))];
  // Bytes after those that an exception has are waited for.
  const needed = Math.max(code + 1, ...counts.map((step) => placeBehind(step) ?? 0));
  if (needed > EXCEPTION_BYTES) body.push(when(binary(length, '<', int(needed)), [giveBack(int(needed + tail))]));
  if (last.size.by === 'groups') return [...body, ...throughGroups(last, envelope)];
  return [...body, giveBack(plus(plus(last.at, last.bytes ?? int(0)), int(tail)))];
}

const placeBehind = (step: Step | undefined): number | undefined =>
  step?.at.kind === 'number' ? step.at.value + step.field.width : undefined;

/** Group after group, each as long as its counts say. */
function throughGroups({ field, at: from, items }: Step, envelope: Envelope): readonly Statement[] {
  const group = field.group ?? [];
  const inner = stepsFrom(group, at, envelope);
  const end = inner.at(-1);
  const fixed = fixedBytes(group);
  const more = plus(at, int(fixed));
  return [
    declare('at', from, true),
    loop('group', int(0), items ?? int(0), [
      when(binary(length, '<', more), [giveBack(plus(more, int(envelope.tail)))]),
      set(at, end === undefined ? more : plus(end.at, end.bytes ?? int(0))),
    ]),
    giveBack(plus(at, int(envelope.tail))),
  ];
}
