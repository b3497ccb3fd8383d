import { describe, expect, it } from 'vitest';
import { diagnose } from '../../../src/diagnosis/index.ts';
import { hex } from '../modbus/frames.ts';
import { contextOf, findingsOf, firstOf, isValid, type Known, spaced, userFrames } from './findings.ts';

const knownOf = ({ transport, answering }: (typeof userFrames)[number], withTransport: boolean): Known => ({
  ...(withTransport && transport !== 'data' && { transport }),
  ...(answering && { request: answering }),
});

const cases = userFrames.map((frame) => [`${frame.id}: ${frame.finding}`, frame] as const);

describe.each([
  ['with the transport', true],
  ['from the bytes alone', false],
])('frames of users, %s', (_, withTransport) => {
  it.each(cases)('%s', (_name, frame) => {
    const found = firstOf(frame.hex, knownOf(frame, withTransport));
    expect(found.code).toBe(frame.finding);
    if (frame.repaired) expect(spaced(found.repaired[0]!)).toBe(frame.repaired);
  });
});

it('has all 39 of them', () => {
  expect(userFrames).toHaveLength(39);
});

it.each(cases)('%s: all repaired frames are valid', (_, frame) => {
  const found = diagnose(hex(frame.hex), contextOf(knownOf(frame, true)));
  expect(found.flatMap(({ repaired }) => repaired).filter((repaired) => !isValid(repaired))).toEqual([]);
});

it('knows a misprint of the WEG guide', () => {
  // The guide prints E6 A1 where F5 E5 belongs.
  const [found, ...others] = findingsOf('06 06 02 AB 10 00 E6 A1', { transport: 'rtu' });
  expect(found).toMatchObject({ code: 'known-misprint', from: 6, to: 8, got: 0xa1e6, expected: 0xe5f5 });
  expect(found!.repaired.map(spaced)).toEqual(['06 06 02 AB 10 00 F5 E5']);
  expect(others.every(({ confidence }) => confidence === 'possible')).toBe(true);
});
