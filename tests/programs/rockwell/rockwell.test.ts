import { describe, expect, test } from 'vitest';
import { makePlan } from '../../../src/codegen/make-plan.ts';
import { settingsOf } from '../../../src/codegen/settings.ts';
import { rockwell } from '../../../src/codegen/targets/rockwell/rockwell.ts';
import { encodeFrame, type FrameInput } from '../../../src/modbus/index.ts';
import { programCases, repliesTo } from '../cases.ts';
import { RockwellFault, routinesOf } from './rockwell-rules.ts';

const written = (request: FrameInput, options = {}) => {
  const { plan } = makePlan([{ name: undefined, request }], settingsOf({ part: 'check', ...options }));
  const [routines, tags] = rockwell.write(plan).files.map(({ text }) => text);
  return { plan, routines: routines ?? '', tags: tags ?? '' };
};
const routineNames = (text: string) => [...text.matchAll(/^\/\/ ---- routine (\w+)$/gm)].map(([, name = '']) => name);

describe.each(['rtu', 'ascii', 'tcp'] as const)('routines of Studio 5000 over %s', (transport) => {
  test.each(programCases(transport, 5).map(({ name, request }, index) => ({ name, request, index })))(
    '$name keeps the rules, and what it says gives the bytes',
    ({ request, index }) => {
      const { plan, routines, tags } = written(request, index % 2 === 0 ? {} : { crc: 'table' });
      const program = routinesOf(tags, routines);
      const names = routineNames(routines);
      const has = (wanted: RegExp) => names.find((name) => wanted.test(name));
      const tag = (routine: string, name: string): string => `${routine}${name}`.toUpperCase();
      const setup = has(/^ModbusSetup$/);
      if (setup) program.run(setup);
      const build = has(/^Build/) ?? has(/Frame$/) ?? '';
      for (const { parameter, value } of plan.requests[0]?.arguments ?? []) {
        const found = program.tags.find(
          (one) =>
            one === tag(build, parameter.name.replaceAll(' ', '')) ||
            one === tag(build, `${parameter.name.replaceAll(' ', '')}Value`),
        );
        if (found === undefined) throw new Error(`${build} has no ${parameter.name}`);
        program.set(found, value);
      }
      program.run(build);
      const frame = program.get(tag(build, 'Frame')) as readonly number[];
      expect(frame.slice(0, Number(program.get(tag(build, 'Result'))))).toEqual([...encodeFrame(request)]);
      const check = has(/^Check/);
      if (check === undefined) return;
      for (const { what, bytes, result } of repliesTo(request)) {
        const reply = program.get(tag(check, 'Reply')) as readonly number[];
        if (bytes.length > reply.length) continue;
        program.set(tag(check, 'Request'), frame);
        program.set(tag(check, 'Reply'), [...bytes, ...reply.slice(bytes.length)]);
        program.set(tag(check, 'ReplyLength'), bytes.length);
        program.run(check);
        const got = program.get(tag(check, 'Result'));
        if (result === 'fault') expect([what, Number(got) < 0]).toEqual([what, true]);
        else expect([what, got]).toEqual([what, result]);
      }
    },
  );
});

describe('the rules refuse', () => {
  const { routines, tags } = written(
    programCases('rtu', 0).find(({ name }) => name === 'write register')?.request as FrameInput,
  );
  test.each<[what: string, from: string | RegExp, to: string]>([
    ['SHR', /(\w+) \/ 2\b/, 'SHR($1, 1)'],
    ['>>', /(\w+) \/ 2\b/, '$1 >> 1'],
    ['a literal with a type', '16#FFFF', 'WORD#16#FFFF'],
    ['a conversion by name', /:= (\w+) AND 16#FF;/, ':= WORD_TO_BYTE($1);'],
    ['a tag that is not in the list', /^(\w+) := 16#FFFF/m, 'Gone := 16#FFFF'],
    ['a routine that there is not', /JSR\(\w+,/, 'JSR(Gone,'],
    ['a call with a value', /JSR\((\w+), 0\);/, 'x := $1();'],
  ])('%s', (_, from, to) => {
    expect(() => routinesOf(tags, routines)).not.toThrow();
    expect(routines.replace(from, to)).not.toBe(routines);
    expect(() => routinesOf(tags, routines.replace(from, to))).toThrow(RockwellFault);
  });

  test('a tag without a sign', () => {
    expect(() => routinesOf(tags.replace('DINT[256]', 'USINT[256]'), routines)).toThrow(RockwellFault);
  });
});
