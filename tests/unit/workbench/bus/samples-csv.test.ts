import { expect, it } from 'vitest';
import { Samples } from '../../../../src/bus/index.ts';
import { plainRegister, type Register } from '../../../../src/devices/index.ts';
import type { PolledValue } from '../../../../src/workbench/bus/poll-source.ts';
import { samplesAsCsv } from '../../../../src/workbench/bus/samples-csv.ts';

const words = { timeColumn: 'Time', timeCell: (time: number) => `at ${time}` };

const value = (name: string, change: Partial<Register>): PolledValue => ({
  name,
  place: '',
  register: { ...plainRegister, name, table: 'holding-register', address: 0, ...change },
  where: { read: 0, at: 0, size: 1 },
});

it('is saved as UTF-8 with its mark, a line a round, empty where nothing was read', () => {
  const values = [value('Speed', { unit: 'Hz' }), value('State, or "mode"', {})];
  const samples = new Samples(2);
  samples.begin(1000);
  samples.read(0, 0, 4096, 30);
  samples.read(1, 0, 19, 19);
  samples.begin(2000);
  samples.failed(0);
  samples.read(1, 0, 3, 3);
  expect(samplesAsCsv(samples, values, words)).toBe(
    '\uFEFFTime,Speed (Hz),"State, or ""mode"""\r\nat 1000,30,19\r\nat 2000,,3\r\n',
  );
});

it('has as many digits as the type of a value holds', () => {
  const types = ['f16', 'f32', 'f64', 'i64', 'text'] as const;
  const samples = new Samples(types.length);
  samples.begin(0);
  samples.read(0, 0, 0.0999755859375, 0.0999755859375);
  samples.read(1, 0, 0.10000000149011612, 0.10000000149011612);
  samples.read(2, 0, 0.1, 0.1 + 0.2);
  samples.read(3, 0, -9_007_199_254_740_993n, -9_007_199_254_740_993n);
  samples.read(4, 0, 'V2.11');
  const rows = samplesAsCsv(
    samples,
    types.map((type) => value(type, { type })),
    words,
  ).split('\r\n');
  expect(rows[1]).toBe('at 0,0.09998,0.1,0.3,-9007199254740993,V2.11');
});
