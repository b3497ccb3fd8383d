import { describe, expect, it } from 'vitest';
import { itemsOf } from '../../../../src/bus/index.ts';
import { builtInProfiles } from '../../../../src/devices/index.ts';
import { fromHex, toHex } from '../../../../src/modbus/index.ts';
import { defaultPoll } from '../../../../src/workbench/bus/poll-settings.ts';
import {
  deviceSource,
  frameSource,
  heldBy,
  numberOf,
  type PollSource,
  type SourceWords,
} from '../../../../src/workbench/bus/poll-source.ts';
import type { Draft } from '../../../../src/workbench/frame/draft.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';

const words: SourceWords = {
  name: ({ table, address }) => `${table} ${address}`,
  place: (printed, address) => `${printed} = ${address}`,
  frameTitle: ({ functionCode }, size, transport) => `${functionCode}, ${size} of ${transport}`,
  deviceTitle: (name, unit) => `${name} at ${unit}`,
};

const request = (texts: Draft['texts'], change: Partial<Draft> = {}): ReturnType<typeof frameSource> => {
  const draft: Draft = { transport: 'rtu', kind: 'request', texts, force: {}, answering: '', ...change };
  return frameSource(draft, evaluate(draft), words);
};
const polled = (source: ReturnType<typeof frameSource>): PollSource => {
  if (typeof source === 'string') throw new Error(source);
  return source;
};
const device = (id: string, lines: readonly string[], unit = 1) => {
  const profile = builtInProfiles.find((one) => one.id === id)!;
  return deviceSource(profile, { ...defaultPoll, unit, lines: { [id]: lines } }, 'rtu', words);
};

describe('the current frame as what is polled', () => {
  it('has each register with its address', () => {
    const { title, values, requests } = polled(
      request({ unitId: '1', functionCode: '3', startAddress: '10', quantity: '2' }),
    );
    expect(title).toBe('3, 8 of rtu');
    expect(requests.map((bytes) => toHex(bytes))).toEqual(['0103000A0002E409']);
    expect(values.map(({ name, place }) => [name, place])).toEqual([
      ['holding-register 10', '40011 = 10'],
      ['holding-register 11', '40012 = 11'],
    ]);
  });

  it('has numbers of six digits where they were typed so, and beyond those of five', () => {
    const places = (startAddress: string) =>
      polled(request({ unitId: '1', functionCode: '3', startAddress, quantity: '2' })).values.map(({ place }) => place);
    expect(places('400011')).toEqual(['400011 = 10', '400012 = 11']);
    expect(places('9998')).toEqual(['49999 = 9998', '410000 = 9999']);
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
    expect(source.title).toBe('WEG drive at 6');
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

  it('reads the scale registers that its lines need, each once', () => {
    const source = polled(device('sunspec-inverter', ['A', 'AphA', 'W']));
    // A and AphA at 40072 and 40073 have their power of ten at 40076, W at 40084 has it at 40085: 14 registers from 0x9C88.
    expect(source.requests.map((bytes) => toHex(bytes.subarray(0, 6)))).toEqual(['01039C88000E']);
    expect(source.values.map(({ name, where, power }) => [name, where.at, power?.at])).toEqual([
      ['A', 0, 4],
      ['AphA', 1, 4],
      ['W', 12, 13],
    ]);
    const alone = polled(
      deviceSource(
        builtInProfiles.find(({ id }) => id === 'sunspec-inverter')!,
        { ...defaultPoll, gap: 0, lines: { 'sunspec-inverter': ['A'] } },
        'rtu',
        words,
      ),
    );
    expect(alone.requests.map((bytes) => toHex(bytes.subarray(0, 6)))).toEqual(['01039C880001', '01039C8C0001']);
    expect(alone.values.map(({ where, power }) => [where, power])).toEqual([
      [
        { read: 0, at: 0, size: 1 },
        { read: 1, at: 0, size: 1 },
      ],
    ]);
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
