import { describe, expect, test } from 'vitest';
import { makePlan } from '../../../src/codegen/make-plan.ts';
import type { ProgramOptions } from '../../../src/codegen/options.ts';
import type { Plan } from '../../../src/codegen/plan.ts';
import { settingsOf } from '../../../src/codegen/settings.ts';
import { structuredText } from '../../../src/codegen/targets/structured-text/structured-text.ts';
import { encodeFrame } from '../../../src/modbus/index.ts';
import { programCases, repliesTo } from '../cases.ts';
import { expectProved } from '../tools.ts';
import { Machine } from './machine.ts';

const WAYS: readonly ProgramOptions[] = [
  {},
  { crc: 'table', comments: false },
  { crc: 'two-tables', part: 'check' },
  { part: 'build', comments: false },
  { echo: true },
  { part: 'bytes' },
];

const written = (plan: Plan): Machine => new Machine(structuredText.write(plan).files[0]?.text ?? '');

/** The name of a routine of the program. */
const routine = (machine: Machine, wanted: string): string => {
  const found = machine.units.find((name) => name.toLowerCase().startsWith(`fc_${wanted}`));
  if (found === undefined) throw new Error(`no ${wanted} among ${machine.units.join(' ')}`);
  return found;
};

const filled = (machine: Machine, bytes: Uint8Array): number[] => [...bytes, ...machine.frame().slice(bytes.length)];

let ran = 0;

describe.each(['rtu', 'ascii', 'tcp'] as const)('Structured Text over %s', (transport) => {
  const cases = programCases(transport);

  test.each(cases.map(({ name, request }, index) => ({ name, request, index })))('$name', ({ request, index }) => {
    ran += 1;
    const bytes = encodeFrame(request);
    const other = WAYS[1 + (index % (WAYS.length - 1))];
    for (const options of transport === 'rtu' ? [WAYS[0], other] : [index % 2 === 0 ? WAYS[0] : other]) {
      const { plan } = makePlan([{ name: undefined, request }], settingsOf(options));
      const machine = written(plan);
      const frame = machine.frame();
      const [planned] = plan.requests;
      const given = planned?.arguments.map(({ parameter, value }) =>
        parameter.type === 'bool' ? (Array.isArray(value) ? value.map(Boolean) : value === 1) : value,
      );
      const length =
        planned?.build === undefined
          ? machine.call(machine.units.find((name) => /frame$/i.test(name)) ?? '', frame)
          : machine.call(routine(machine, 'build'), ...(given ?? []), frame);
      expect(frame.slice(0, Number(length))).toEqual([...bytes]);
      if (planned?.check === undefined) continue;
      const check = routine(machine, 'check');
      for (const { what, bytes: reply, result, list } of repliesTo(request)) {
        if (reply.length > frame.length) continue;
        const size = planned.list?.size;
        const values = size === undefined ? [] : [machine.array(size)];
        const got = machine.call(check, reply.length, filled(machine, bytes), filled(machine, reply), ...values);
        if (result === 'fault') expect([what, Number(got) < 0]).toEqual([what, true]);
        else expect([what, got]).toEqual([what, result]);
        if (list && values[0]) expect(values[0].slice(0, list.length).map(Number)).toEqual(list);
      }
    }
  });
});

test('is said to have been run as it was', () => {
  expectProved('structured-text', { how: 'interpreted', frames: ran });
});
