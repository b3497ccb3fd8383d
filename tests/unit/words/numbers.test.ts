import { describe, expect, it } from 'vitest';
import { plainRegister } from '../../../src/devices/index.ts';
import { languages } from '../../../src/words/index.ts';

const timing = await languages.en.timing();
const wire = await languages.en.wire();
const poll = await languages.en.poll();
const complaints = await languages.en.complaints();

describe('numbers of the Timing view', () => {
  it('are in the unit that suits them, at most three decimals', () => {
    const times = [520.8333, 999.9999, 1000, 4010.4166, 999_999, 1_000_000, 1_259_000];
    expect(times.map(timing.time)).toEqual([
      '520.833 µs',
      '1000 µs',
      '1 ms',
      '4.010 ms',
      '999.999 ms',
      '1 s',
      '1.259 s',
    ]);
    expect([520.8333, 4010.4166, 1_259_000].map(timing.otherTime)).toEqual(['0.521 ms', '4010.417 µs', '1259 ms']);
    expect([1, 38.5, 11].map(timing.bits)).toEqual(['1 bit', '38.5 bits', '11 bits']);
  });

  it('are never more than there are, where they say “at most”', () => {
    expect(timing.most(35.99)).toBe('At most 35.9 exchanges a second.');
    expect(timing.most(1)).toBe('At most 1 exchanges a second.');
    expect(timing.most(0.999)).toBe('At most 59.9 exchanges a minute.');
    expect(timing.eachDevice(2.59)).toBe('Each device is asked 2.5 times a second.');
    expect(timing.eachDevice(0.5)).toBe('Each device is asked every 2 s.');
  });

  it('say of a gap what it does to the frame', () => {
    const silences = { t15: 1718.75, t35: 4010.4166 };
    expect(timing.rtuGap('whole', silences)).toBe(
      'The characters before and after it belong together: t1.5 is 1.719 ms and t3.5 is 4.010 ms here.',
    );
    expect(timing.rtuGap('discarded', silences)).toMatch(/^Longer than t1\.5 and shorter than t3\.5: /);
    expect(timing.rtuGap('two-frames', silences)).toMatch(
      /^The frame ends before the gap, and another begins after it/,
    );
    expect(timing.asciiGap('whole')).toBe('Up to 1 s may pass between two characters.');
    expect(timing.asciiGap('discarded')).toMatch(/^More than 1 s is an error/);
  });
});

describe('numbers on the wire', () => {
  it('have as many digits as matter', () => {
    expect([-5.2083, 0, 9.8765, 859.375, 4583.333, 1_200_000].map(wire.time)).toEqual([
      '−5.208 µs',
      '0 µs',
      '9.877 µs',
      '859.4 µs',
      '4.583 ms',
      '1.2 s',
    ]);
  });

  it('are at the marks of a scale in one unit', () => {
    expect([0, 50, 150].map((time) => wire.mark(time, 50))).toEqual(['0 µs', '50 µs', '150 µs']);
    expect([0, 500, 1500].map((time) => wire.mark(time, 500))).toEqual(['0 ms', '0.5 ms', '1.5 ms']);
    expect([0, 200_000].map((time) => wire.mark(time, 200_000))).toEqual(['0 s', '0.2 s']);
  });

  it('say what a receiver made of them', () => {
    const reception = (received: number, wrong: number, same: boolean) =>
      wire.reception({ sent: 8, received, wrong, same });
    expect(reception(0, 0, false)).toBe('It reads nothing at all.');
    expect(reception(8, 0, true)).toBe('It reads the same bytes, all without an error.');
    expect(reception(8, 3, false)).toMatch(/^8 bytes sent, 8 read, 3 of them with an error\. A receiver discards/);
    expect(reception(7, 0, false)).toMatch(/^8 bytes sent, 7 read, 0 of them with an error\. They are other bytes/);
  });
});

describe('a value that was read', () => {
  const line = { ...plainRegister, name: 'W', table: 'holding-register', address: 0, unit: 'W' } as const;
  const scaled = { ...line, scaleRegister: { address: 1 } };

  it('has the power of ten that its scale register holds, or says that this is not known', () => {
    expect(poll.reading(5003, scaled, -2)).toBe('50.03 W');
    expect(poll.reading(5003, scaled, 2)).toBe('500300 W');
    expect(poll.reading(5003, scaled)).toBe('raw 5003, scale unknown');
    expect(poll.reading(0xffff, { ...scaled, notImplemented: '0xFFFF' }, -2)).toBe('not implemented');
  });

  it('has all its digits, also where it is one of 64 bits that is scaled', () => {
    const energy = { ...scaled, type: 'u64', unit: 'Wh' } as const;
    expect(poll.reading(12345678901234567n, energy, -3)).toBe('12345678901234.567 Wh');
  });
});

it('a number that has more digits than any number of JavaScript is said to be too large', () => {
  const outOfRange = (text: string) =>
    complaints.inputError({ code: 'number-out-of-range', got: Number(text), least: 1, most: 247 });
  expect(outOfRange('248')).toBe('248 does not fit: whole numbers from 1 to 247 (0x01 to 0xF7).');
  expect(outOfRange('9'.repeat(400))).toBe(
    'So large a number does not fit: whole numbers from 1 to 247 (0x01 to 0xF7).',
  );
});
