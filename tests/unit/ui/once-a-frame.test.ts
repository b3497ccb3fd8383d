import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { onceAFrame } from '../../../src/ui/parts/workers/once-a-frame.ts';

const frames: (() => void)[] = [];
const page = { hidden: false };
const draw = () => {
  for (const frame of frames.splice(0)) frame();
};

beforeEach(() => {
  frames.length = 0;
  page.hidden = false;
  vi.stubGlobal('document', page);
  vi.stubGlobal('requestAnimationFrame', (frame: () => void) => frames.push(frame));
  vi.stubGlobal('cancelAnimationFrame', () => frames.splice(0));
});
afterEach(() => vi.unstubAllGlobals());

describe('what comes from a worker', () => {
  it('is heard when the window draws, in its order', () => {
    const heard: number[] = [];
    const mail = onceAFrame(({ n }: { n: number }) => heard.push(n));
    mail.take({ n: 1 });
    mail.take({ n: 2 });
    expect([heard, frames.length]).toEqual([[], 1]);
    draw();
    expect(heard).toEqual([1, 2]);
    mail.take({ n: 3 });
    draw();
    expect(heard).toEqual([1, 2, 3]);
  });

  it('is heard at once while the window is hidden, with what waits', () => {
    const heard: number[] = [];
    const mail = onceAFrame(({ n }: { n: number }) => heard.push(n));
    mail.take({ n: 1 });
    page.hidden = true;
    mail.take({ n: 2 });
    expect([heard, frames.length]).toEqual([[1, 2], 0]);
  });

  it('is not heard any more once it was stopped, also by one that was heard before it', () => {
    const heard: number[] = [];
    const mail = onceAFrame(({ n }: { n: number }) => {
      heard.push(n);
      if (n === 2) mail.stop();
    });
    for (const n of [1, 2, 3]) mail.take({ n });
    draw();
    expect(heard).toEqual([1, 2]);
  });
});
