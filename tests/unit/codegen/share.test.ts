import { describe, expect, test } from 'vitest';
import { makePlan } from '../../../src/codegen/make-plan.ts';
import { settingsOf } from '../../../src/codegen/settings.ts';
import type { FrameInput } from '../../../src/modbus/index.ts';

const request = (functionCode: number, fields: FrameInput['fields']): FrameInput => ({
  transport: 'rtu',
  direction: 'request',
  unitId: 6,
  functionCode,
  fields,
});
const planOf = (...asked: readonly (readonly [string | undefined, FrameInput])[]) =>
  makePlan(
    asked.map(([name, one]) => ({ name, request: one })),
    settingsOf(),
  ).plan;

describe('routines of several requests that do the same', () => {
  const write = (address: number, value: number) => request(0x06, { address, value });
  const coil = (address: number) => request(0x05, { address, value: true });

  test('are one routine, called by the function', () => {
    const { code, requests } = planOf(['set speed', write(683, 4096)], ['run', write(682, 1)]);
    expect(code.routines.map(({ name }) => name)).toEqual([
      'crc',
      'build write single register',
      'write single register wanted',
      'check write single register',
    ]);
    for (const { build, wanted, check } of requests)
      expect([build, wanted, check]).toEqual([
        'build write single register',
        'write single register wanted',
        'check write single register',
      ]);
    expect(requests.map(({ name }) => name)).toEqual(['set speed', 'run']);
    expect(code.routines[1]?.about.join(' ')).not.toContain('683');
  });

  test('are called by what they are of if the functions differ', () => {
    const { requests } = planOf(['run', write(682, 1)], ['light', coil(1)]);
    expect(requests.map(({ build }) => build)).toEqual(['build run', 'build light']);
    expect(requests.map(({ wanted }) => wanted)).toEqual(['reply wanted', 'reply wanted']);
  });

  test('keep a name that another request has', () => {
    const { requests } = planOf(
      ['write single register', coil(3)],
      ['write single register', write(683, 1)],
      ['run', write(682, 1)],
    );
    const builds = requests.map(({ build }) => build);
    expect(builds[1]).toBe(builds[2]);
    expect(builds[0]).not.toBe(builds[1]);
  });

  test('call each other by the names that they have', () => {
    const { code } = planOf(['one', write(1, 1)], ['two', write(2, 2)], ['three', coil(3)], ['four', coil(4)]);
    const names = code.routines.map(({ name }) => name);
    const called = [...JSON.stringify(code).matchAll(/"routine":"([^"]+)"/g)].map(([, name]) => name);
    expect(new Set(names).size).toBe(names.length);
    for (const name of called) expect(names).toContain(name);
  });

  test('stay as they are called for one request', () => {
    expect(planOf(['run', write(682, 1)]).requests[0]).toMatchObject({ build: 'build run', check: 'check run' });
  });
});
