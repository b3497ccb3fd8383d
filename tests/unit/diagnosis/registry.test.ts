import { expect, it } from 'vitest';
import { makeCase } from '../../../src/diagnosis/case.ts';
import { findingKinds } from '../../../src/diagnosis/finding-kinds.ts';
import { ofOthers, ofSoundFrames } from '../../../src/diagnosis/hypotheses/index.ts';
import { hex } from '../modbus/frames.ts';
import { brokenFrames, frames } from '../modbus/vectors.ts';
import { contextOf, userFrames } from './findings.ts';

const hypotheses = [...ofSoundFrames, ...ofOthers];

it('each hypothesis offers only what it is said to offer', () => {
  const users = userFrames.map((frame) =>
    makeCase(hex(frame.hex), contextOf({ ...(frame.answering && { request: frame.answering }) })),
  );
  const broken = brokenFrames.map((frame) => makeCase(hex(frame.hex), { transport: frame.transport }));
  const sound = frames.filter((_, i) => i % 20 === 0).map((frame) => makeCase(hex(frame.hex), {}));
  const others = [...users, ...broken, ...sound].flatMap((item) =>
    hypotheses.flatMap(({ codes, offer }) => offer(item).filter(({ code }) => !codes.includes(code))),
  );
  expect(others).toEqual([]);
});

it('some hypothesis offers each finding', () => {
  const codes = new Set(hypotheses.flatMap((hypothesis) => hypothesis.codes));
  expect([...codes].sort()).toEqual(Object.keys(findingKinds).sort());
});
