import { describe, expect, it } from 'vitest';
import { defaultSettings, type ScanFinding, type ScanOrder, type TrialNews } from '../../../../src/bus/index.ts';
import {
  type NoAnswerStep,
  noAnswerSteps,
  type StepFinding,
  scanFinding,
  stepMarks,
  trialFinding,
  type Unanswered,
} from '../../../../src/workbench/index.ts';
import { hex } from '../../modbus/frames.ts';

const READ: Unanswered = { request: hex('21 03 03 E7 00 04 F3 1A'), transport: 'rtu' };
/** Its reply has the same bytes (AP 6.6). */
const WRITE: Unanswered = { request: hex('06 06 02 AB 10 00 F5 E5'), transport: 'rtu' };
const SIGNS = { open: '.', running: 'r', tried: 't', excluded: 'x', found: 'f' } as const;

/** A sign for each step, in the order of `noAnswerSteps`, when one thing was observed in one of them. */
function marksOf(step: NoAnswerStep, finding: StepFinding, about: Unanswered = READ): string {
  const marks = stepMarks(new Map([[step, finding]]), undefined, about);
  return noAnswerSteps.map((each) => SIGNS[marks.get(each)!.state]).join('');
}

describe('what an observation excludes', () => {
  const line = { settings: defaultSettings };
  // unit, line, echo, gap, length, wires, termination, power
  const cases: readonly (readonly [NoAnswerStep, StepFinding, string, string])[] = [
    ['unit', { code: 'unit-answers', unit: 33 }, 'xxx..x.x', 'xx...x.x'],
    ['unit', { code: 'others-answer', unit: 33, units: [1] }, 'f.x.....', 'f.......'],
    ['unit', { code: 'none-answers', asked: 247 }, 't.......', 't.......'],
    ['unit', { code: 'garbled' }, 't.......', 't.......'],
    ['unit', { code: 'gateway-answers' }, 't.......', 't.......'],
    ['unit', { code: 'stopped', done: 1, total: 247 }, '........', '........'],
    ['line', { code: 'line-answers', ...line }, 'xxx..x.x', 'xx...x.x'],
    ['line', { code: 'other-line-answers', ...line }, 'xfx..x.x', 'xf...x.x'],
    ['line', { code: 'lines-silent', tried: 32, notOpened: 0 }, '.t......', '.t......'],
    ['echo', { code: 'returned' }, '..x.....', '..x.....'],
    ['echo', { code: 'returned-as-reply' }, '..t.....', '..t.....'],
    ['echo', { code: 'nothing-returned' }, '..t.....', '..t.....'],
    ['echo', { code: 'answers-behind-echo' }, 'xxxxxx.x', 'xxxxxx.x'],
    ['echo', { code: 'answers-unfiltered' }, 'xxfxxx.x', 'xxfxxx.x'],
    ['gap', { code: 'answers-after-silence' }, 'xxxfxx.x', 'xxxfxx.x'],
    ['gap', { code: 'answers-late' }, 'xxxfxx.x', 'xxxfxx.x'],
    ['gap', { code: 'still-silent' }, '...t....', '...t....'],
    ['length', { code: 'answers-half' }, 'xxx.fx.x', 'xx..fx.x'],
    ['length', { code: 'still-silent' }, '....t...', '....t...'],
    ['length', { code: 'garbled' }, '....t...', '....t...'],
    ['wires', { code: 'checked' }, '.....x..', '.....x..'],
    ['termination', { code: 'checked' }, '......x.', '......x.'],
    ['power', { code: 'checked' }, '.......x', '.......x'],
  ];
  it.each(cases)('%s: %o', (step, finding, reading, writing) => {
    expect(marksOf(step, finding)).toBe(reading);
    // The filter that takes away the echo may take away a reply with the same bytes.
    expect(marksOf(step, finding, WRITE)).toBe(writing);
  });

  it('is nothing while all is silent, whatever was tried', () => {
    const silent = new Map<NoAnswerStep, StepFinding>([
      ['unit', { code: 'none-answers', asked: 247 }],
      ['line', { code: 'lines-silent', tried: 32, notOpened: 1 }],
      ['echo', { code: 'nothing-returned' }],
      ['gap', { code: 'still-silent' }],
      ['length', { code: 'still-silent' }],
    ]);
    const states = [...stepMarks(silent, undefined, READ).values()].map(({ state }) => state);
    expect(states).toEqual(['tried', 'tried', 'tried', 'tried', 'tried', 'open', 'open', 'open']);
  });

  it('stands although the step itself was tried in vain', () => {
    const findings = new Map<NoAnswerStep, StepFinding>([
      ['echo', { code: 'nothing-returned' }],
      ['length', { code: 'answers-half' }],
    ]);
    expect(stepMarks(findings, undefined, READ).get('echo')).toEqual({
      state: 'excluded',
      finding: { code: 'ruled-out', by: 'length' },
    });
  });
});

describe('what was observed', () => {
  const units: ScanOrder = {
    kind: 'scan',
    what: 'units',
    transport: 'rtu',
    timeout: 100,
    first: 1,
    last: 247,
    lines: [],
  };
  const ended = { done: 247, total: 247 };
  const unit = (unit: number, outcome: 'reply' | 'exception' | 'broken', exceptionCode?: number): ScanFinding => ({
    what: 'unit',
    unit,
    settings: defaultSettings,
    outcome,
    request: READ.request,
    ...(exceptionCode !== undefined && { exceptionCode }),
  });
  const found = (...all: ScanFinding[]) => scanFinding(READ, units, all, ended, defaultSettings);

  it('a unit is there if it sends a sound reply, or refuses', () => {
    expect(found(unit(33, 'reply'))).toEqual({ code: 'unit-answers', unit: 33 });
    expect(found(unit(33, 'exception', 2))).toEqual({ code: 'unit-answers', unit: 33 });
    expect(found(unit(1, 'reply'), unit(33, 'broken'))).toEqual({ code: 'others-answer', unit: 33, units: [1] });
  });

  it('a broken reply proves no unit, and a gateway does not answer for the device behind it', () => {
    expect(found(unit(33, 'broken'))).toEqual({ code: 'garbled' });
    for (const code of [0x0a, 0x0b]) expect(found(unit(33, 'exception', code))).toEqual({ code: 'gateway-answers' });
    expect(found()).toEqual({ code: 'none-answers', asked: 247 });
  });

  const tried = (given: Partial<TrialNews>): readonly TrialNews[] => [
    { kind: 'tried', index: 0, outcome: 'silent', returned: false, ...given },
  ];
  it('an echo that comes back alone hides nothing, unless it may be the reply', () => {
    expect(trialFinding('echo', READ, tried({ returned: true }))).toEqual({ code: 'returned' });
    expect(trialFinding('echo', WRITE, tried({ returned: true }))).toEqual({ code: 'returned-as-reply' });
    expect(trialFinding('echo', WRITE, tried({ returned: true, outcome: 'reply' }))).toEqual({
      code: 'returned-as-reply',
    });
    expect(trialFinding('echo', READ, tried({ returned: true, outcome: 'reply' }))).toEqual({
      code: 'answers-behind-echo',
    });
    expect(trialFinding('echo', READ, tried({ outcome: 'reply' }))).toEqual({ code: 'answers-unfiltered' });
    expect(trialFinding('echo', READ, tried({}))).toEqual({ code: 'nothing-returned' });
  });

  it('a trial is answered by the device, by a gateway, or by something that is not a reply', () => {
    expect(trialFinding('length', READ, tried({ outcome: 'exception', exceptionCode: 2 }))).toEqual({
      code: 'answers-half',
    });
    expect(trialFinding('length', READ, tried({ outcome: 'exception', exceptionCode: 0x0b }))).toEqual({
      code: 'gateway-answers',
    });
    expect(trialFinding('gap', READ, tried({ outcome: 'broken' }))).toEqual({ code: 'garbled' });
    expect(trialFinding('gap', READ, tried({}))).toEqual({ code: 'still-silent' });
    expect(trialFinding('gap', READ, [])).toBeUndefined();
  });
});
