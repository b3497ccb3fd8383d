import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  builtInSequences,
  duplicateAt,
  insertAt,
  moveAt,
  movedTo,
  newSequence,
  newStep,
  readSequence,
  readSequences,
  removeAt,
  type SequenceTexts,
  type StepTexts,
  stepAt,
  stepKinds,
  withField,
  writeSequences,
} from '../../../src/sequences/index.ts';
import { hex } from '../modbus/frames.ts';

const none = () => undefined;
const steps = (...list: StepTexts[]): SequenceTexts => ({ ...newSequence('Test'), steps: list });
const faultsOf = (texts: SequenceTexts) => {
  const reading = readSequence(texts);
  return reading.kind === 'faults' ? reading.faults : [];
};
const at = (...indices: number[]) => ({ list: 'steps', at: indices }) as const;

describe('the program of the guide', () => {
  test('sends what the guide sends, with the right checksums', () => {
    const reading = readSequence(builtInSequences[0]!);
    expect(reading).toEqual({
      kind: 'sequence',
      sequence: {
        transport: 'rtu',
        steps: [
          // unit 6, function 06, P0683, 4096 of 8192
          { kind: 'send', bytes: hex('06 06 02 AB 10 00 F5 E5'), onFailure: 'stop' },
          { kind: 'wait', duration: 10 },
          // P0682, bit 0
          { kind: 'send', bytes: hex('06 06 02 AA 00 01 68 25'), onFailure: 'stop' },
          {
            kind: 'until',
            unit: 6,
            table: 'holding-register',
            address: 681,
            type: 'i16',
            order: 'ABCD',
            relation: '≥',
            value: 4000,
            interval: 100,
            timeout: 5000,
            onFailure: 'stop',
          },
          { kind: 'wait', duration: 10_000 },
        ],
        finally: [{ kind: 'send', bytes: hex('06 06 02 AA 00 00 A9 E5'), onFailure: 'stop' }],
      },
    });
  });
});

describe('what was typed', () => {
  test('may be decimal or hexadecimal', () => {
    const reading = readSequence(
      steps(newStep('until', { unit: '0x0B', address: '2A9h', value: '-0x10', interval: '0,5', type: 'i32' })),
    );
    expect(reading).toMatchObject({
      kind: 'sequence',
      sequence: { steps: [{ unit: 11, address: 0x2a9, value: -16, interval: 0.5 }] },
    });
  });

  test('has all its faults told, each with its step', () => {
    const bad = steps(
      newStep('send'),
      newStep('send', { bytes: '06 0' }),
      newStep('wait', { duration: 'soon' }),
      {
        ...newStep('repeat', { times: '1.5' }),
        steps: [
          newStep('until', { unit: '0', address: '65535', type: 'u32', relation: '~', value: '', timeout: '0' }),
          newStep('repeat'),
        ],
      },
      newStep('until', { bit: '3', value: '2' }),
      newStep('until', { bit: '16' }),
      newStep('send', { bytes: '00'.repeat(514) }),
    );
    expect(faultsOf(bad)).toEqual([
      { code: 'field-missing', field: 'bytes', place: at(0) },
      { code: 'not-bytes', field: 'bytes', got: '06 0', place: at(1) },
      { code: 'not-a-number', field: 'duration', got: 'soon', place: at(2) },
      { code: 'not-a-number', field: 'times', got: '1.5', place: at(3) },
      { code: 'over-the-end', field: 'address', last: 65536, place: at(3, 0) },
      { code: 'out-of-range', field: 'unit', got: 0, least: 1, most: 255, place: at(3, 0) },
      {
        code: 'unknown',
        field: 'relation',
        got: '~',
        known: ['=', '≠', '<', '≤', '>', '≥'],
        place: at(3, 0),
      },
      { code: 'field-missing', field: 'value', place: at(3, 0) },
      { code: 'out-of-range', field: 'timeout', got: 0, least: 1, most: 3_600_000, place: at(3, 0) },
      { code: 'no-steps', place: at(3, 1) },
      { code: 'out-of-range', field: 'value', got: 2, least: 0, most: 1, place: at(4) },
      { code: 'out-of-range', field: 'bit', got: 16, least: 0, most: 15, place: at(5) },
      { code: 'too-long', field: 'bytes', got: 514, most: 513, place: at(6) },
    ]);
  });

  test('has to have steps', () => {
    expect(faultsOf(newSequence('Empty'))).toEqual([{ code: 'no-steps', place: at() }]);
  });

  test('is read without throwing, whatever it is', () => {
    fc.assert(
      fc.property(
        fc.constantFrom(...stepKinds),
        fc.dictionary(fc.string(), fc.string()),
        fc.string(),
        (kind, others, text) => {
          const fields = Object.fromEntries(Object.keys(newStep(kind).fields).map((name) => [name, text]));
          readSequence(steps({ ...newStep(kind), fields: { ...fields, ...others } }));
        },
      ),
    );
  });
});

const stepTexts: fc.Arbitrary<StepTexts> = fc.letrec<{ step: StepTexts }>((tie) => ({
  step: fc.oneof(
    { maxDepth: 3, withCrossShrink: true },
    fc.tuple(fc.constantFrom('send', 'wait', 'until'), fc.string()).map(([kind, text]) => {
      const step = newStep(kind);
      const [name = ''] = Object.keys(step.fields);
      return { ...step, fields: { ...step.fields, [name]: text } };
    }),
    fc.array(tie('step'), { maxLength: 3 }).map((inner) => ({ ...newStep('repeat'), steps: inner })),
  ),
})).step;
const sequences: fc.Arbitrary<SequenceTexts> = fc
  .tuple(fc.array(stepTexts, { maxLength: 4 }), fc.array(stepTexts, { maxLength: 2 }))
  .map(([list, last]) => ({ ...newSequence('Test'), steps: list, finally: last }));

describe('a file', () => {
  test('is plain JSON, with numbers where numbers are typed', () => {
    const text = writeSequences([steps(newStep('wait', { duration: '10' }), newStep('until', { address: '0x02A9' }))]);
    expect(JSON.parse(text)).toEqual({
      format: 'framewright-sequences',
      version: 1,
      sequences: [
        {
          name: 'Test',
          about: '',
          transport: 'rtu',
          steps: [
            { kind: 'wait', duration: 10 },
            {
              kind: 'until',
              unit: 1,
              table: 'holding-register',
              address: '0x02A9',
              type: 'u16',
              order: 'ABCD',
              bit: '',
              relation: '=',
              value: 0,
              interval: 100,
              timeout: 5000,
              onFailure: 'stop',
            },
          ],
          finally: [],
        },
      ],
    });
  });

  test('gives back what was written, also what is not right yet', () => {
    fc.assert(
      fc.property(fc.array(sequences, { maxLength: 3 }), (list) => {
        const entries = list.map((sequence) => ({ kind: 'sequence', sequence }));
        expect(readSequences(writeSequences(list), none)).toEqual({ kind: 'sequences', entries });
      }),
    );
  });

  test('may have a frame as a link', () => {
    const text = JSON.stringify({
      format: 'framewright-sequences',
      version: 1,
      sequences: [{ name: 'One', transport: 'rtu', steps: [{ kind: 'send', link: 'rtu/request?unitId=6' }] }],
    });
    expect(readSequences(text, (link) => (link === 'rtu/request?unitId=6' ? '06 03' : undefined))).toMatchObject({
      entries: [{ sequence: { steps: [{ kind: 'send', fields: { bytes: '06 03', onFailure: 'stop' } }] } }],
    });
    expect(readSequences(text, none)).toMatchObject({
      entries: [{ sequence: { steps: [{ fields: { bytes: 'rtu/request?unitId=6' } }] } }],
    });
  });

  test('says of each sequence that is none what is wrong, and takes no part of it', () => {
    const deep = {
      kind: 'repeat',
      steps: [
        {
          kind: 'repeat',
          steps: [{ kind: 'repeat', steps: [{ kind: 'repeat', steps: [{ kind: 'repeat', steps: [] }] }] }],
        },
      ],
    };
    const sequences = [
      7,
      {
        name: 'Jump',
        transport: 'tcp',
        steps: [{ kind: 'jump' }, { kind: 'wait', duration: 1, unit: 3 }],
        finally: 'no',
      },
      { name: 'Deep', transport: 'rtu', steps: [deep] },
      { name: 'Good', transport: 'ascii', steps: [{ kind: 'wait', duration: 1 }] },
      { name: 'Long', transport: 'rtu', steps: Array(501).fill({ kind: 'wait' }) },
    ];
    const text = JSON.stringify({ format: 'framewright-sequences', version: 1, sequences });
    const raw = (number: number) => sequences[number - 1];
    expect(readSequences(text, none)).toEqual({
      kind: 'sequences',
      entries: [
        {
          kind: 'faults',
          number: 1,
          name: '',
          faults: [{ code: 'no-name' }, { code: 'not-a-transport', got: '' }],
          raw: 7,
        },
        {
          kind: 'faults',
          number: 2,
          name: 'Jump',
          faults: [
            { code: 'not-a-transport', got: 'tcp' },
            { code: 'not-a-step', place: at(0), got: 'jump' },
            { code: 'field-unknown', place: at(1), field: 'unit' },
            { code: 'not-a-list', place: { list: 'finally', at: [] } },
          ],
          raw: raw(2),
        },
        {
          kind: 'faults',
          number: 3,
          name: 'Deep',
          faults: [{ code: 'too-deep', place: at(0, 0, 0, 0, 0), most: 4 }],
          raw: raw(3),
        },
        {
          kind: 'sequence',
          sequence: { ...steps(newStep('wait', { duration: '1' })), name: 'Good', transport: 'ascii' },
        },
        { kind: 'faults', number: 5, name: 'Long', faults: [{ code: 'too-many', got: 501, most: 500 }], raw: raw(5) },
      ],
    });
  });

  test('of another kind, or of a newer version, is not read', () => {
    expect(readSequences('{', none)).toMatchObject({ kind: 'unreadable', fault: { code: 'not-json' } });
    for (const text of [
      '[]',
      '7',
      '{"format":"framewright-devices","version":1}',
      '{"format":"framewright-sequences","version":1}',
    ])
      expect(readSequences(text, none)).toEqual({ kind: 'unreadable', fault: { code: 'not-sequences' } });
    expect(readSequences('{"format":"framewright-sequences","version":2,"sequences":[]}', none)).toEqual({
      kind: 'unreadable',
      fault: { code: 'newer-version', version: 2 },
    });
    fc.assert(
      fc.property(fc.jsonValue(), (value) => {
        readSequences(JSON.stringify({ format: 'framewright-sequences', version: 1, sequences: [value] }), none);
      }),
    );
  });
});

describe('editing', () => {
  const one = newStep('wait', { duration: '1' });
  const two = newStep('wait', { duration: '2' });
  const three = newStep('wait', { duration: '3' });
  const repeat = (...inner: StepTexts[]): StepTexts => ({ ...newStep('repeat'), steps: inner });

  test('adds, removes, doubles and changes steps, in repetitions too', () => {
    expect(insertAt(steps(one, repeat(two)), at(1, 1), three)).toEqual(steps(one, repeat(two, three)));
    expect(removeAt(steps(one, repeat(two, three)), at(1, 0))).toEqual(steps(one, repeat(three)));
    expect(duplicateAt(steps(one, two), at(0))).toEqual(steps(one, one, two));
    expect(withField(steps(one, repeat(two)), at(1, 0), 'duration', '9')).toEqual(
      steps(one, repeat(newStep('wait', { duration: '9' }))),
    );
  });

  test('moves a step into a repetition, through it and out of it', () => {
    const places = [
      steps(one, repeat(two), three),
      steps(repeat(one, two), three),
      steps(repeat(two, one), three),
      steps(repeat(two), one, three),
      steps(repeat(two), three, one),
    ];
    let place = at(0) as Parameters<typeof moveAt>[1];
    places.slice(0, -1).forEach((before, index) => {
      const to = movedTo(before, place, 1)!;
      expect(moveAt(before, place, 1), `move ${index}`).toEqual(places[index + 1]);
      expect(moveAt(places[index + 1]!, to, -1), `back ${index}`).toEqual(before);
      place = to;
    });
    expect(movedTo(places.at(-1)!, place, 1)).toBeUndefined();
    expect(moveAt(places.at(-1)!, place, 1)).toEqual(places.at(-1));
  });

  test('moves a step back to where it was', () => {
    const placesOf = (list: readonly StepTexts[], around: readonly number[]): number[][] =>
      list.flatMap((step, index) => [[...around, index], ...placesOf(step.steps ?? [], [...around, index])]);
    fc.assert(
      fc.property(sequences, fc.nat(), fc.constantFrom(1 as const, -1 as const), (sequence, nth, by) => {
        const places = placesOf(sequence.steps, []);
        if (places.length === 0) return;
        const place = at(...places[nth % places.length]!);
        const to = movedTo(sequence, place, by);
        if (to === undefined) return;
        const moved = moveAt(sequence, place, by);
        expect(stepAt(moved, to)).toEqual(stepAt(sequence, place));
        expect(moveAt(moved, to, by === 1 ? -1 : 1)).toEqual(sequence);
      }),
    );
  });
});
