import { describe, expect, it, test } from 'vitest';
import { builtInProfiles } from '../../../../src/devices/index.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { targetsOf } from '../../../../src/workbench/frame/form-layout.ts';
import { readLink } from '../../../../src/workbench/frame/link.ts';
import { firstScale, scaleWithUnit } from '../../../../src/workbench/values/own-scale.ts';
import { placeOf, unitsAt } from '../../../../src/workbench/values/targets.ts';
import { readTyped, typedFault, valueInFrame } from '../../../../src/workbench/values/typed-values.ts';

const weg = builtInProfiles.find(({ id }) => id === 'weg-drive');
const drive = { device: weg, own: undefined };
const nothing = { device: undefined, own: undefined };
const hertz = { device: undefined, own: scaleWithUnit({ ...firstScale, factor: '60/8192', unit: 'Hz', most: '60' }) };

function fieldOf(link: string, path: string) {
  const { draft } = readLink(link)!;
  const evaluation = evaluate(draft);
  const control = targetsOf(evaluation).find((target) => target.path === path)!;
  return { draft, evaluation, control };
}

/** Function 06 writes P0683, the speed reference: 8192 are 60 Hz. */
const speed = (value = '1') => fieldOf(`#rtu/request?unitId=6&functionCode=6&address=0x02AB&value=${value}`, 'value');
const registers = fieldOf('#rtu/request?functionCode=16&startAddress=0&registers=0', 'registers');

describe('the text that a field of registers gets', () => {
  test.each([
    ['30 Hz', '4096'],
    ['30.0 Hz', '4096'],
    ['50 Hz', '6827'],
    ['i16 -5', '0xFFFB'],
    // Plain numbers stay as they are.
    ['4096', '4096'],
    ['0x1000', '0x1000'],
    // What cannot be read stays, and the form says why.
    ['300 Hz', '300 Hz'],
    ['3 A', '3 A'],
    ['f32 1', 'f32 1'],
  ])('of %s is %s', (typed, text) => {
    expect(valueInFrame(typed, speed(), drive)).toBe(text);
  });

  it('depends on the device, or on a scale of one’s own', () => {
    expect(valueInFrame('30 Hz', speed(), nothing)).toBe('30 Hz');
    expect(valueInFrame('30 Hz', speed(), hertz)).toBe('4096');
    const elsewhere = fieldOf('#rtu/request?functionCode=6&address=0&value=1', 'value');
    expect(valueInFrame('30 Hz', elsewhere, drive)).toBe('30 Hz');
  });

  it('takes as many registers as the values have, in a list', () => {
    expect(valueInFrame('15 Hz, 30 Hz\nf32 CDAB 21.5', registers, hertz)).toBe('2048 4096 0x0000 0x41AC');
    expect(valueInFrame('text "PUMP"', registers, nothing)).toBe('0x5055 0x4D50');
  });
});

describe('what is wrong with a text as a value', () => {
  it('is the first fault of a value, and more registers than the field has', () => {
    expect(typedFault('300 Hz', speed('300+Hz'), drive)).toMatchObject({ code: 'fault' });
    expect(typedFault('3 A', speed('3+A'), drive)).toMatchObject({
      code: 'fault',
      fault: { code: 'unit-unknown', unit: 'A', known: ['Hz'] },
    });
    expect(typedFault('f32 1', speed('f32+1'), drive)).toEqual({ code: 'too-many', registers: 2 });
    expect(typedFault('61 Hz', registers, hertz)).toMatchObject({ code: 'fault' });
  });

  it('is left to the form for numbers, and for what looks like a mistyped number', () => {
    expect(typedFault('70000', speed(), drive)).toBeUndefined();
    expect(typedFault('abc', speed(), drive)).toBeUndefined();
    expect(typedFault('3A0', speed(), nothing)).toBeUndefined();
  });

  it('is that it is to be typed again, if its device was chosen after', () => {
    expect(typedFault('30 Hz', speed('30+Hz'), drive)).toMatchObject({
      code: 'type-again',
      read: { registers: [4096] },
    });
  });
});

describe('where the registers of a field stand', () => {
  const place = (link: string, path: string) => {
    const { control, draft, evaluation } = fieldOf(link, path);
    return placeOf(control, draft, evaluation);
  };

  it('is said by the form, or by the request that is answered', () => {
    expect(place('#pdu/request?functionCode=6&address=683&value=1', 'value')).toEqual({
      table: 'holding-register',
      first: 683,
    });
    expect(place('#pdu/request?functionCode=23&writeStartAddress=14&writeRegisters=1', 'writeRegisters')).toEqual({
      table: 'holding-register',
      first: 14,
    });
    expect(place('#pdu/reply?functionCode=3&registers=1&answering=0302A90001', 'registers')).toEqual({
      table: 'holding-register',
      first: 681,
    });
    expect(place('#pdu/reply?functionCode=3&registers=1', 'registers')).toBeUndefined();
    expect(place('#pdu/request?functionCode=21&subRequests=1', 'subRequests[0].recordData')).toBeUndefined();
  });

  it('decides the units: the device’s by address, one’s own everywhere', () => {
    const at = (first: number) => ({ table: 'holding-register', first }) as const;
    const both = { device: weg, own: hertz.own };
    expect(unitsAt(drive, at(683), 0).map(({ unit }) => unit)).toEqual(['Hz']);
    expect(unitsAt(drive, at(682), 1).map(({ unit }) => unit)).toEqual(['Hz']);
    expect(unitsAt(drive, at(682), 0)).toEqual([]);
    expect(unitsAt(both, undefined, 0)).toEqual([hertz.own]);
    expect(unitsAt(both, at(683), 0)).toHaveLength(2);
  });
});

it('values are read with their places, for what is said of each', () => {
  expect(readTyped('15 Hz, 30 Hz', registers, hertz)).toMatchObject({
    registers: [2048, 4096],
    tooMany: false,
    faults: [],
  });
  expect(readTyped('', registers, hertz).text).toBeUndefined();
});
