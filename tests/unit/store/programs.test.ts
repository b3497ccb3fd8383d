import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { Page, Programs } from '../../../src/store/index.ts';
import type { ProgramSurroundings } from '../../../src/workbench/index.ts';
import { TestBrowser, TestWindow } from './window.ts';

const surroundings = signal<ProgramSurroundings>({
  profile: undefined,
  line: { baud: 19_200, dataBits: 8, parity: 'even', stopBits: 1 },
});
const WRITE = '#rtu/request?unitId=6&functionCode=6&address=683&value=4096';

/** A page at an address, and its programs, in a new tab of a browser. */
function opened(hash: string, browser = new TestBrowser()) {
  const window = new TestWindow(hash);
  const storage = browser.tab();
  const page = new Page(window.bar, window.after);
  return { window, page, programs: new Programs(page, storage, surroundings) };
}

describe('the program that is shown', () => {
  it('is in the link with its target and its part while its tab is open', () => {
    const { window, page, programs } = opened(WRITE);
    page.openTab('program');
    programs.open();
    programs.chooseTarget('c');
    programs.choosePart('check');
    window.wait(1000);
    expect(window.entries.at(-1)).toBe(
      '#rtu/request?v=5&unitId=6&functionCode=6&address=683&value=4096&tab=program&program=c.check',
    );
    expect(programs.options.value).toMatchObject({ part: 'check', line: { baud: 19_200 } });
    page.openTab('crc');
    window.wait(1000);
    expect(window.entries.at(-1)).toMatch(/value=4096&tab=crc$/);
  });

  it('is the one of the link, or else the one of the last time', () => {
    const browser = new TestBrowser();
    const linked = opened(`${WRITE}&tab=program&program=arduino.build`, browser);
    expect(linked.page.tab.value).toBe('program');
    expect(linked.programs.choice.value).toEqual({ target: 'arduino', part: 'build' });
    linked.programs.chooseTarget('c');
    const { page, programs } = opened(`${WRITE}&tab=program`, browser);
    expect(programs.choice.value).toEqual({ target: 'c', part: 'build' });
    programs.open();
    expect(page.link.value).toMatch(/&tab=program&program=c\.build$/);
  });

  it('is another where the link names one that is not known here, which is told until one is chosen', () => {
    const { page, programs } = opened(`${WRITE}&v=5&tab=program&program=cobol.build`);
    expect(programs.unknown.value).toBe('cobol.build');
    expect(programs.choice.value).toEqual({ target: 'structured-text', part: 'exchange' });
    expect(page.brokenLink.value).toBeUndefined();
    programs.chooseTarget('c');
    expect(programs.unknown.value).toBeUndefined();
  });

  it('is written as it was set, in every tab', () => {
    const browser = new TestBrowser();
    opened(WRITE, browser).programs.set({ crc: 'table', names: 'unit = slave' });
    expect(opened(WRITE, browser).programs.options.value).toMatchObject({ crc: 'table', names: { unit: 'slave' } });
  });
});
