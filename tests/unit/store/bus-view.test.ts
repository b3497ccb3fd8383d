import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import type { SentResult } from '../../../src/bus/index.ts';
import { BusView, Page, type Question } from '../../../src/store/index.ts';
import { hex } from '../modbus/frames.ts';
import { TestWindow } from './window.ts';

const FRAME = 'rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3';
const OTHER = 'rtu/request?unitId=17&functionCode=3&startAddress=108&quantity=3';
const READ = hex('11 03 00 6B 00 03 76 87');
const result = (outcome: SentResult['outcome']): SentResult => ({
  request: READ,
  transport: 'rtu',
  outcome,
  verdict: 'bad',
  duration: 1,
  attempts: 1,
  echo: 'none',
  findings: [],
  strays: 0,
});

/** The Bus view at an address, with a frame as the current one. */
function open(hash: string) {
  const window = new TestWindow(`#${FRAME}`);
  const page = new Page(window.bar, window.after);
  const go = (next: string) => {
    window.goTo(next);
    page.address.take();
  };
  go(hash);
  const answers: boolean[] = [];
  const bus = {
    last: signal<SentResult | undefined>(undefined),
    question: signal<Question | undefined>(undefined),
    answer(yes: boolean) {
      answers.push(yes);
      bus.question.value = undefined;
    },
  };
  return { window, page, bus, answers, go, view: new BusView(page, bus) };
}

describe('the tab that is open', () => {
  it('is the one of the address, which follows; one that is not known is that of the reply', () => {
    const { view, window, go } = open('#bus?tab=poll&search=06');
    expect(view.shown.value).toEqual({ tab: 'poll', search: '06' });
    view.open('scan');
    window.wait(250);
    expect(window.entries.at(-1)).toBe('#bus?tab=scan&search=06');
    go('#bus?tab=constructor');
    expect(view.shown.value.tab).toBe('reply');
    view.open('listen');
    view.open('reply');
    window.wait(250);
    expect(window.entries.at(-1)).toBe('#bus');
  });

  it('that comes by itself is told, so that somebody is brought to it; one that stands already is not', () => {
    const { bus, view } = open('#bus');
    expect(view.brought.value).toBeUndefined();
    bus.last.value = result('silent');
    expect(view.brought.value).toBe('no-answer');
    view.brought.value = undefined;
    bus.last.value = undefined;
    bus.last.value = result('silent');
    expect(view.brought.value).toBeUndefined();
    view.open('poll');
    bus.last.value = undefined;
    bus.last.value = result('reply');
    expect([view.brought.value, view.shown.value.tab]).toEqual([undefined, 'poll']);
    view.open('frame');
    bus.last.value = undefined;
    bus.last.value = result('reply');
    expect(view.shown.value.tab).toBe('reply');
  });

  it('is that of the reply, or of what to look at if none came, while one of them is open', () => {
    const { bus, view } = open('#bus');
    bus.last.value = result('silent');
    expect(view.shown.value.tab).toBe('no-answer');
    bus.last.value = undefined;
    expect(view.shown.value.tab).toBe('no-answer');
    bus.last.value = result('reply');
    expect(view.shown.value.tab).toBe('reply');
    view.open('poll');
    bus.last.value = result('silent');
    expect(view.shown.value.tab).toBe('poll');
  });
});

describe('a question about a request', () => {
  const question: Question = {
    command: { kind: 'send', id: 1, request: READ, confirmed: true },
    why: 'first-write',
  };

  it('is closed when another frame is the current one, and stays while it is the same', () => {
    const { bus, page, answers } = open('#bus');
    bus.question.value = question;
    page.takeFrame(FRAME);
    expect(answers).toEqual([]);
    page.takeFrame(OTHER);
    expect([answers, bus.question.value]).toEqual([[false], undefined]);
  });

  it('is closed with the view', () => {
    const { bus, view, answers } = open('#bus');
    bus.question.value = question;
    view.stop();
    expect(answers).toEqual([false]);
  });
});
