import { describe, expect, test } from 'vitest';
import { makePlan } from '../../../src/codegen/make-plan.ts';
import { targetOffer } from '../../../src/codegen/offers.ts';
import type { Plan } from '../../../src/codegen/plan.ts';
import { programTargets, writeFor, writeProgram } from '../../../src/codegen/program.ts';
import { targetProof } from '../../../src/codegen/proofs.ts';
import { settingsOf } from '../../../src/codegen/settings.ts';
import type { Target } from '../../../src/codegen/target.ts';
import { builtInProfiles } from '../../../src/devices/index.ts';
import type { FrameInput } from '../../../src/modbus/index.ts';
import { programCases, sequences } from '../../programs/cases.ts';
import { unusedIn } from './unused.ts';

const weg = builtInProfiles.find(({ id }) => id === 'weg-drive');
const input = (parts: Partial<FrameInput> = {}): FrameInput => ({
  transport: 'rtu',
  direction: 'request',
  unitId: 6,
  functionCode: 6,
  fields: { address: 683, value: 4096 },
  ...parts,
});

/** A target that keeps what it is given. */
function keeping(parts: Partial<Target> = {}): { readonly target: Target; readonly plan: () => Plan } {
  const plans: Plan[] = [];
  const target: Target = {
    id: 'kept',
    name: 'Kept',
    language: 'plaintext',
    proof: 'rules',
    parts: ['bytes', 'build', 'check', 'exchange'],
    transports: ['rtu', 'ascii', 'tcp'],
    sequences: true,
    write: (plan) => {
      plans.push(plan);
      return { files: [{ name: 'a', text: 'a\n', lines: [{ line: 1, spans: ['value'] }] }], notes: [{ code: 'own' }] };
    },
    ...parts,
  };
  return { target, plan: () => plans[0] as Plan };
}

describe('writeProgram', () => {
  test('gives files, lines and notes; those of the plan come first', () => {
    const { target } = keeping();
    expect(writeFor(target, { request: input({ force: { value: 'FF' } }) })).toEqual({
      files: [{ name: 'a', text: 'a\n' }],
      lines: [{ file: 0, line: 1, spans: ['value'] }],
      notes: [{ code: 'constant', request: expect.any(String), why: 'forced' }, { code: 'own' }],
    });
  });

  test('refuses an unknown target, and what has no bytes', () => {
    expect(() => writeProgram('cobol', { request: input() })).toThrow(RangeError);
    const { target } = keeping();
    expect(() => writeFor(target, { request: input({ fields: { address: 70_000, value: 1 } }) })).toThrow(RangeError);
    expect(() => writeFor(target, { frames: [] })).toThrow(RangeError);
  });

  test.each(programTargets.map(({ id }) => id))('%s: a name of any length gives a file that can be saved', (id) => {
    for (const name of ['x'.repeat(300), '水位'.repeat(100), '/', '']) {
      const files = writeProgram(id, { request: input() }, { name }).files;
      expect(files.length).toBeGreaterThan(0);
      for (const file of files) expect(file.name).toMatch(/^[A-Za-z][\w-]{0,120}(\.\w+)+$/);
    }
  });

  test.each(programTargets.map(({ id }) => id))('%s: is offered in a group', (id) => {
    expect(targetOffer(id).group).toBeDefined();
  });

  test('what was proved is said of every target that runs, and of no other', () => {
    for (const { id, proof } of programTargets)
      expect([id, targetProof(id) !== undefined]).toEqual([id, proof === 'run']);
  });

  test('lists each target once', () => {
    const ids = programTargets.map(({ id }) => id);
    expect(new Set(ids).size).toBe(ids.length);
  });

  test.each([
    ['a part that is missing', { parts: ['bytes', 'check'] }, 'check', [{ code: 'not-offered', what: 'exchange' }]],
    ['another transport', { transports: ['tcp'] }, 'bytes', [{ code: 'not-offered', what: 'rtu' }]],
  ] as const)('%s is written as the nearest, with a note', (_, parts, part, notes) => {
    const { target, plan } = keeping(parts);
    expect(writeFor(target, { request: input() }).notes).toEqual([...notes, { code: 'own' }]);
    expect(plan().options.part).toBe(part);
  });

  test('several frames have one CRC, and names of their own', () => {
    const { target, plan } = keeping();
    const frames = [
      { name: 'Set 30 Hz', request: input() },
      { name: 'Set 30 Hz', request: input({ fields: { address: 683, value: 0 } }) },
      { name: '30 Hz', request: input({ fields: { address: 683, value: 1 } }) },
      { name: 'Größe', request: input({ fields: { address: 683, value: 2 } }) },
    ];
    const { notes } = writeFor(target, { frames });
    expect(plan().requests.map(({ name }) => name)).toEqual(['set 30 hz', 'set 30 hz 2', 'frame 30 hz', 'groesse']);
    expect(plan().code.routines.filter(({ name }) => name === 'crc')).toHaveLength(1);
    expect(notes.filter(({ code }) => code === 'name-changed').map(({ from }) => from)).toEqual([
      'Set 30 Hz',
      '30 Hz',
      'Größe',
    ]);
  });

  test('frames of two transports are refused', () => {
    const frames = [input(), input({ transport: 'ascii' })].map((request) => ({ name: 'a', request }));
    expect(() => writeFor(keeping().target, { frames })).toThrow(RangeError);
  });

  test('a sequence has its steps with their requests, what comes at last included', () => {
    const [start] = sequences;
    if (start === undefined) throw new Error('no sequence');
    const { target, plan } = keeping();
    writeFor(target, { sequence: start });
    const steps = plan().sequence?.steps ?? [];
    expect(steps.map(({ kind }) => kind)).toEqual(['send', 'wait', 'send', 'until', 'wait']);
    expect(plan().sequence?.finally.map(({ kind }) => kind)).toEqual(['send']);
    // Three frames that write, and one that reads.
    expect(plan().requests).toHaveLength(4);
  });

  test('a target without sequences writes their frames, with a note', () => {
    const [start] = sequences;
    if (start === undefined) throw new Error('no sequence');
    const { target, plan } = keeping({ sequences: false });
    expect(writeFor(target, { sequence: start }).notes).toContainEqual({ code: 'not-offered', what: 'sequence' });
    expect([plan().sequence, plan().requests.length]).toEqual([undefined, 4]);
  });
});

describe('a plan', () => {
  test('says what each byte is, as the device calls it', () => {
    const { target, plan } = keeping();
    writeFor(target, { request: input() }, { profile: weg, part: 'bytes' });
    const [request] = plan().requests;
    expect(request?.about).toBe(
      'Write Single Register, unit 6: address 683 = register 40684 = P0683 speed reference, value 4096',
    );
    expect(request?.name).toBe('write p0683 4096');
    expect(request?.rows.map(({ from, to, span, comment }) => [from, to, span, comment])).toEqual([
      [0, 1, 'unitId', 'unit 6'],
      [1, 2, 'functionCode', 'function 06 Write Single Register'],
      [2, 4, 'address', 'address: 683 = register 40684 = P0683 speed reference'],
      [4, 6, 'value', 'value: 4096'],
      [6, 8, 'checksum', 'CRC, low byte first'],
    ]);
  });

  test('has the line of its device, or what is usual', () => {
    expect(settingsOf({ profile: weg }).line).toEqual({
      port: '/dev/ttyUSB0',
      baud: 9600,
      dataBits: 8,
      parity: 'none',
      stopBits: 1,
    });
    expect(settingsOf({ line: { port: 'COM3', baud: undefined } }).line).toEqual({
      port: 'COM3',
      baud: 19_200,
      dataBits: 8,
      parity: 'even',
      stopBits: 1,
    });
  });

  test('too many numbers in groups are constant, and so are broken, raw and forced frames', () => {
    const why = (request: FrameInput) =>
      makePlan([{ name: undefined, request }], settingsOf()).notes.map(({ code, why: one }) => [code, one]);
    const many = {
      subRequests: [1, 2, 3, 4, 5].map((fileNumber) => ({
        referenceType: 6,
        fileNumber,
        recordNumber: 0,
        recordLength: 1,
      })),
    };
    expect(why(input({ functionCode: 0x14, fields: many }))).toEqual([['constant', 'too-many-numbers']]);
    expect(why(input({ functionCode: 0x41, fields: { data: '01' } }))).toEqual([['constant', 'raw']]);
    expect(why(input({ force: { checksum: 1 } }))).toEqual([['constant', 'forced']]);
    expect(why(input({ direction: 'response' }))).toEqual([['constant', 'reply']]);
  });

  test.each(['rtu', 'ascii', 'tcp'] as const)('of %s has nothing that is not used', (transport) => {
    for (const { name, request } of programCases(transport, 20))
      for (const part of ['bytes', 'build', 'check', 'exchange'] as const) {
        const { plan } = makePlan(
          [{ name: undefined, request }],
          settingsOf({ part, crc: 'two-tables', profile: weg, units: true }),
        );
        expect({ name, part, unused: unusedIn(plan) }).toEqual({ name, part, unused: [] });
      }
  });
});
