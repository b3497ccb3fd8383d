import { describe, expect, test } from 'vitest';
import { readPdu, said, word, zeros } from '../frames.ts';

/** A reply of `code` with this byte count and as many bytes. */
const counted = (code: number) => (count: number) => said(readPdu('response', [code, count, ...zeros(count)]));

test.each([0x01, 0x02])('a reply of %i has 1 to 250 bytes of bits', (code) => {
  const reply = counted(code);
  for (const count of [1, 2, 250]) expect(reply(count)).toEqual([]);
  for (const count of [0, 251, 255]) expect(reply(count)).toContain('error count-out-of-range');
});

test.each([0x03, 0x04, 0x17])('a reply of %i has 2 to 250 bytes of registers, an even number', (code) => {
  const reply = counted(code);
  for (const count of [2, 4, 250]) expect(reply(count)).toEqual([]);
  for (const count of [0, 252, 254]) expect(reply(count)).toContain('error count-out-of-range');
  expect(reply(3)).toEqual(['error count-odd', 'error pdu-rest']);
});

test('the event log has 0 to 64 events behind six bytes (AP 6.10)', () => {
  const log = (count: number) => said(readPdu('response', [0x0c, count, ...zeros(count)]));
  for (const count of [6, 7, 70]) expect(log(count)).toEqual([]);
  expect(log(71)).toEqual(['error count-out-of-range']);
  expect(log(5)).toContain('error count-out-of-range');
});

test('a server id has at least its id and the run indicator (PI 11h)', () => {
  const id = (count: number) => said(readPdu('response', [0x11, count, ...zeros(count)]));
  for (const count of [2, 3, 251]) expect(id(count)).toEqual(['note server-id-layout-open']);
  expect(id(0)).toContain('error count-out-of-range');
});

describe('the queue has 0 to 31 values (AP 6.18)', () => {
  const queue = (bytes: number, count: number, values: number) =>
    said(readPdu('response', [0x18, ...word(bytes), ...word(count), ...zeros(2 * values)]));

  test('its byte count covers the FIFO count', () => {
    expect(queue(2, 0, 0)).toEqual([]);
    expect(queue(4, 1, 1)).toEqual([]);
    expect(queue(64, 31, 31)).toEqual([]);
  });
  test('32 are an error', () => {
    expect(queue(66, 32, 32)).toEqual(['error count-out-of-range', 'error count-out-of-range']);
  });
  test('counts that contradict one another are an error', () => {
    expect(queue(4, 2, 1)).toEqual(['error count-wrong']);
    expect(queue(6, 1, 2)).toEqual(['error count-wrong']);
    expect(queue(0, 0, 0)).toContain('error count-out-of-range');
  });
});

describe('a byte count against the quantity before it', () => {
  test('0F: one byte for eight coils, two for nine', () => {
    expect(said(readPdu('request', [0x0f, 0, 0, 0, 8, 1, 0xff]))).toEqual([]);
    expect(said(readPdu('request', [0x0f, 0, 0, 0, 9, 2, 0xff, 0x01]))).toEqual([]);
    expect(said(readPdu('request', [0x0f, 0, 0, 0, 9, 1, 0xff]))).toEqual(['error count-contradicts-quantity']);
    expect(said(readPdu('request', [0x0f, 0, 0, 0, 8, 2, 0xff, 0]))).toEqual(['error count-contradicts-quantity']);
  });
  test('10: two bytes a register', () => {
    const { problems } = readPdu('request', [0x10, 0, 0, 0, 3, 4, 0, 0, 0, 0]);
    expect(problems).toMatchObject([
      { code: 'count-contradicts-quantity', severity: 'error', got: 4, expected: 6, quantity: 3, section: 'AP 6.12' },
    ]);
  });
  test('17: two bytes a register written', () => {
    const pdu = [0x17, 0, 0, 0, 1, 0, 0, 0, 2, 2, 0, 0];
    expect(said(readPdu('request', pdu))).toEqual(['error count-contradicts-quantity']);
  });
});

describe('unused high bits should be zero (AP 6.1, AP 6.11)', () => {
  test('in what is written', () => {
    expect(said(readPdu('request', [0x0f, 0, 0x13, 0, 10, 2, 0xcd, 0x03]))).toEqual([]);
    const reading = readPdu('request', [0x0f, 0, 0x13, 0, 10, 2, 0xcd, 0x07]);
    expect(reading.problems).toMatchObject([{ code: 'padding-not-zero', severity: 'warning', got: 1 }]);
    expect(reading.fields['bits']).toEqual([1, 0, 1, 1, 0, 0, 1, 1, 1, 1]);
    expect(reading.forced).toEqual({ padding: 1 });
  });
  test('in what is read, where the request tells how many bits count', () => {
    const reply = [0x01, 0x03, 0xcd, 0x6b, 0x0d];
    expect(said(readPdu('response', reply))).toEqual([]);
    expect(said(readPdu('response', reply, [0x01, 0, 0x13, 0, 19]))).toEqual(['warning padding-not-zero']);
    expect(said(readPdu('response', reply, [0x01, 0, 0x13, 0, 20]))).toEqual([]);
  });
});
