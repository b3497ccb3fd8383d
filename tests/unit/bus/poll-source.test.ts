import { beforeAll, describe, expect, it } from 'vitest';
import { itemsOf, Samples } from '../../../src/bus/index.ts';
import { builtInProfiles } from '../../../src/devices/index.ts';
import { fromHex, toHex } from '../../../src/modbus/index.ts';
import { chartData } from '../../../src/ui/bus-poll/chart-data.ts';
import { samplesAsCsv } from '../../../src/ui/bus-poll/csv.ts';
import { loadWords } from '../../../src/ui/bus-poll/language.ts';
import { pollSettings } from '../../../src/ui/bus-poll/settings.ts';
import { deviceSource, frameSource, heldBy, numberOf, type PollSource } from '../../../src/ui/bus-poll/source.ts';
import type { Draft } from '../../../src/workbench/frame/draft.ts';
import { evaluate } from '../../../src/workbench/frame/evaluate.ts';

beforeAll(loadWords);

const request = (texts: Draft['texts'], change: Partial<Draft> = {}): ReturnType<typeof frameSource> => {
  const draft: Draft = { transport: 'rtu', kind: 'request', texts, force: {}, answering: '', ...change };
  return frameSource(draft, evaluate(draft));
};
const polled = (source: ReturnType<typeof frameSource>): PollSource => {
  if (typeof source === 'string') throw new Error(source);
  return source;
};
const device = (id: string, lines: readonly string[], unit = 1) => {
  const profile = builtInProfiles.find((one) => one.id === id)!;
  return deviceSource(profile, { ...pollSettings.value, unit, lines: { [id]: lines } }, 'rtu');
};

describe('the frame at hand as what is polled', () => {
  it('has each register with its address', () => {
    const { values, requests } = polled(request({ unitId: '1', functionCode: '3', startAddress: '10', quantity: '2' }));
    expect(requests.map((bytes) => toHex(bytes))).toEqual(['0103000A0002E409']);
    expect(values.map(({ name, place }) => [name, place])).toEqual([
      ['Holding register 10', '400011, 0x000A'],
      ['Holding register 11', '400012, 0x000B'],
    ]);
  });

  it('has each bit, and what 17 reads of what it writes and reads', () => {
    const bits = polled(request({ functionCode: '2', startAddress: '0', quantity: '9' }));
    expect(bits.values.map(({ register: { table, address } }) => [table, address]).at(-1)).toEqual([
      'discrete-input',
      8,
    ]);
    const both = polled(
      request({
        functionCode: '0x17',
        readStartAddress: '3',
        readQuantity: '6',
        writeStartAddress: '14',
        writeRegisters: '255 255 255',
      }),
    );
    expect(both.values.map(({ register: { address } }) => address)).toEqual([3, 4, 5, 6, 7, 8]);
  });

  it('says why a frame is not polled', () => {
    expect(request({ functionCode: '3', startAddress: 'x' })).toBe('no-frame');
    expect(request({ functionCode: '3' }, { kind: 'reply' })).toBe('not-request');
    expect(request({ functionCode: '3' }, { transport: 'tcp' })).toBe('not-serial');
    expect(request({ functionCode: '16' })).toBe('reads-nothing');
    expect(request({ functionCode: '7' })).toBe('reads-nothing');
    expect(request({ unitId: '0', functionCode: '3' })).toBe('broadcast');
  });
});

describe('registers of a device as what is polled', () => {
  it('has lines in one request, and their values in their type and unit', () => {
    const source = polled(device('weg-drive', ['P0681 actual speed', 'P0682 control word'], 6));
    // unit 6 reads 2 registers from 681 (0x02A9)
    expect(source.requests.map((bytes) => toHex(bytes.subarray(0, 6)))).toEqual(['060302A90002']);
    const [speed, control] = source.values;
    // −4096 is half of full scale, 60 Hz, in reverse.
    const held = heldBy(speed!, [0xf000]);
    expect(held).toBe(-4096);
    expect(numberOf(held!, speed!)).toBeCloseTo(-30, 10);
    expect(heldBy(control!, [0x0013])).toBe(0x13);
  });

  it('has single values of a long line, and splits one that is longer than a request', () => {
    const few = polled(device('s7-200', ['VW{800+2n}#1', 'VW{800+2n}#3']));
    expect(few.values.map(({ name, where }) => [name, where])).toEqual([
      ['VW802', { read: 0, at: 0, size: 1 }],
      ['VW806', { read: 0, at: 2, size: 1 }],
    ]);
    expect(polled(device('s7-200', ['VW{800+2n}'])).requests).toHaveLength(8);
  });

  it('says when nothing is chosen', () => {
    expect(device('weg-drive', [])).toBe('nothing-chosen');
    expect(device('weg-drive', ['gone'])).toBe('nothing-chosen');
  });

  it('reads values that are one address and two registers', () => {
    const [profile] = builtInProfiles.filter(({ traits }) => traits.includes('one-address-each-value'));
    const line = profile!.registers.find(({ type }) => type === 'f32')!;
    const source = polled(device(profile!.id, [`${line.name}#0`, `${line.name}#1`]));
    expect(source.reads).toMatchObject([{ address: line.address, quantity: 2, width: 2 }]);
    // unit, function code, byte count 8, 1.0, 2.0, CRC
    const reply = fromHex('0103083F80000040000000428B')!;
    const items = itemsOf(source.reads[0]!, source.requests[0]!, reply, 'rtu');
    expect(
      items && source.values.map((value) => heldBy(value, items.slice(value.where.at, value.where.at + 2))),
    ).toEqual([1, 2]);
  });
});

describe('what is drawn', () => {
  const samples = (count: number, number: (round: number) => number | undefined) => {
    const all = new Samples(1);
    for (let round = 0; round < count; round++) {
      all.begin(round * 1000);
      const one = number(round);
      if (one === undefined) all.failed(0);
      else all.read(0, round * 1000, one, one);
    }
    return all;
  };

  it('is each round while they are few, with gaps', () => {
    const all = samples(4, (round) => (round === 2 ? undefined : round));
    expect(chartData(all, [0], 1000)).toEqual([
      [1, 2, 3],
      [1, null, 3],
    ]);
  });

  it('is bounded, and loses no peak', () => {
    const all = samples(50_000, (round) => (round === 33_333 ? 1000 : round === 41_001 ? -1000 : 1));
    const [times, values] = chartData(all, [0], Number.NEGATIVE_INFINITY, 1000);
    expect(times.length).toBeLessThanOrEqual(1010);
    expect(values).toHaveLength(times.length);
    expect(Math.max(...(values as number[]))).toBe(1000);
    expect(Math.min(...(values as number[]))).toBe(-1000);
    expect(times).toEqual(times.toSorted((a, b) => a - b));
    expect([times[0], times.at(-1)]).toEqual([0, 49_999]);
  });

  it('goes on in the same groups as rounds are added', () => {
    const [first] = chartData(
      samples(120_000, () => 1),
      [0],
      Number.NEGATIVE_INFINITY,
    );
    const [second] = chartData(
      samples(120_001, () => 1),
      [0],
      Number.NEGATIVE_INFINITY,
    );
    expect(first.slice(2, 100)).toEqual(second.slice(2, 100));
  });
});

it('is saved as UTF-8 with its mark, a line a round, empty where nothing was read', () => {
  const { values } = polled(device('weg-drive', ['P0681 actual speed', 'P0682 control word']));
  const samples = new Samples(2);
  samples.begin(Date.UTC(2024, 0, 2, 3, 4, 5, 678));
  samples.read(0, 0, 4096, (4096 * 60) / 8192);
  samples.read(1, 0, 19, 19);
  samples.begin(Date.UTC(2024, 0, 2, 3, 4, 6));
  samples.failed(0);
  samples.read(1, 0, 3, 3);
  expect(samplesAsCsv(samples, values)).toBe(
    [
      '\uFEFFTime (UTC),P0681 actual speed (Hz),P0682 control word',
      '2024-01-02T03:04:05.678Z,30,19',
      '2024-01-02T03:04:06.000Z,,3',
      '',
    ].join('\r\n'),
  );
});
