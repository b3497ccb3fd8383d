import { expect, test } from 'vitest';
import { builtInProfiles, departure, deviceTraits, type Trait } from '../../../src/devices/index.ts';
import { decodeFrame, fromHex } from '../../../src/modbus/index.ts';

/** What of the first problem of a frame is the device's own way. */
function ofFirst(device: string, hex: string, request?: string) {
  const profile = builtInProfiles.find(({ id }) => id === device)!;
  const reading = decodeFrame(fromHex(hex)!, {
    transport: 'pdu',
    direction: request === undefined ? 'request' : 'response',
    request: request === undefined ? undefined : fromHex(request),
  });
  return departure(profile, reading, reading.problems[0]!);
}

// Two floats of Enron's from 7001 (1B59): eight bytes for a quantity of 2.
const FLOATS = '03 08 447A2000 489F9060';

test('Enron: a reply with four bytes for each value asked for is the convention', () => {
  expect(ofFirst('enron-daniel', FLOATS, '03 1B59 0002')).toBe('one-address-each-value');
  // 16-bit integers from 3001 (0BB9) have two bytes each, so that eight are too many.
  expect(ofFirst('enron-daniel', FLOATS, '03 0BB9 0002')).toBeUndefined();
  // Six bytes are no two floats.
  expect(ofFirst('enron-daniel', '03 06 447A2000 489F', '03 1B59 0002')).toBeUndefined();
  // What no device was chosen for, and what input registers have, is wrong as ever.
  expect(ofFirst('weg-drive', FLOATS, '03 1B59 0002')).toBeUndefined();
  expect(ofFirst('enron-daniel', '04 08 447A2000 489F9060', '04 1B59 0002')).toBeUndefined();
});

test('Enron: a write of one value with quantity 1 and byte count 4 is the convention', () => {
  expect(ofFirst('enron-daniel', '10 1B59 0001 04 447A2000')).toBe('one-address-each-value');
  expect(ofFirst('enron-daniel', '10 0BB9 0001 04 447A2000')).toBeUndefined();
});

test('I-8xx7: any first byte but 00 is ON, and eight coils have byte count 2', () => {
  expect(ofFirst('i-8xx7', '05 0001 0100')).toBe('any-value-is-on');
  expect(ofFirst('i-8xx7', '05 0001 0001')).toBeUndefined();
  expect(ofFirst('i-8xx7', '0F 0000 0008 02 FF 00')).toBe('byte-count-plus-one');
  expect(ofFirst('i-8xx7', '0F 0000 0008 03 FF 00 00')).toBeUndefined();
  expect(ofFirst('weg-drive', '05 0001 0100')).toBeUndefined();
});

/** Of each trait a device that has it, with a request or reply that is right by it alone. */
const BY_TRAIT: Readonly<Record<Trait, Parameters<typeof ofFirst>>> = {
  'one-address-each-value': ['enron-daniel', FLOATS, '03 1B59 0002'],
  'any-value-is-on': ['i-8xx7', '05 0001 0100'],
  'byte-count-plus-one': ['i-8xx7', '0F 0000 0008 02 FF 00'],
};

test.each(deviceTraits)('%s makes a frame right, of a device that has it', (trait) => {
  const [device, ...frame] = BY_TRAIT[trait];
  expect(ofFirst(device, ...frame)).toBe(trait);
  for (const { id, traits } of builtInProfiles)
    if (!traits.includes(trait)) expect(ofFirst(id, ...frame)).toBeUndefined();
});
