import { describe, expect, test } from 'vitest';
import { decodeFrame, encodeFrame, toHex } from '../../../src/modbus/index.ts';
import { encodedAgain, expectEveryByteInOneSpan, hex } from './frames.ts';
import { frames } from './vectors.ts';

/** Derived values that the vectors name and a reading says in another way. */
const SAID_OTHERWISE = new Set(['dataBytes', 'exceptionFunctionCode', 'originalFunctionCode']);

test('the vectors are all there', () => {
  expect(frames).toHaveLength(906);
  expect(new Set(frames.map(({ transport }) => transport))).toEqual(new Set(['rtu', 'ascii', 'tcp', 'pdu']));
});

describe.each(frames)('$id', (frame) => {
  const { transport, direction, fields, derived = {} } = frame;
  const bytes = hex(frame.hex);
  const request = frame.request === undefined ? undefined : hex(frame.request);
  const reading = decodeFrame(bytes, { transport, direction, request });

  test('decodes to its fields without an error', () => {
    expect(reading.fields).toEqual(fields);
    expect(reading.unitId).toBe(frame.unitId);
    expect(reading.transactionId).toBe(frame.transactionId);
    expect(reading.functionCode).toBe(frame.functionCode);
    for (const [name, value] of Object.entries(derived)) {
      if (!SAID_OTHERWISE.has(name)) expect(reading.derived, name).toHaveProperty(name, value);
    }
    expect(reading.problems.filter(({ severity }) => severity === 'error')).toEqual([]);
    expect(reading.outcome).toEqual({ kind: 'whole' });
    expect(reading.forced).toEqual({});
    expectEveryByteInOneSpan(reading, bytes.length);
  });

  test('encodes to its bytes, whatever stands under the names of derived values', () => {
    expect(toHex(encodeFrame(frame))).toBe(frame.hex);
    expect(encodedAgain(reading)).toBe(frame.hex);
    const nonsense = Object.fromEntries(Object.keys(reading.derived).map((name) => [name, 'nonsense']));
    expect(toHex(encodeFrame({ ...frame, fields: { ...fields, ...nonsense } }))).toBe(frame.hex);
  });
});
