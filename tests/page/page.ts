import type { Page as PlaywrightPage, expect as playwrightExpect, test as playwrightTest } from '@playwright/test';
import { test as base, beforeEach, describe, vi, expect as vitestExpect } from 'vitest';
import { expect as drawnExpect } from './drawn/expect.ts';
import { drawn } from './drawn/locator.ts';
import { Page } from './drawn/page.ts';

interface Options {
  /** What the page may complain of. */
  readonly expected?: RegExp;
  readonly locale?: string;
  readonly timezoneId?: string;
}

let options: Options = {};

/** A test of the page drawn in this process, which must print no warning and no error, and throw nothing. */
const ofPage = base.extend<{ page: Page }>({
  // biome-ignore lint/correctness/noEmptyPattern: Vitest reads the names of fixtures from this pattern.
  page: async ({}, use) => {
    const { expected, locale, timezoneId } = options;
    options = {};
    const zone = process.env['TZ'];
    if (timezoneId) process.env['TZ'] = timezoneId;
    const page = new Page(locale);
    const said = [vi.spyOn(console, 'error'), vi.spyOn(console, 'warn')];
    await use(page);
    await page.close();
    const all = [...page.complaints, ...said.flatMap(({ mock }) => mock.calls.map(String))];
    const complaints = all.filter((complaint) => !expected?.test(complaint));
    for (const spy of said) spy.mockRestore();
    if (zone === undefined) delete process.env['TZ'];
    else process.env['TZ'] = zone;
    vitestExpect(complaints, 'what the page complained of').toEqual([]);
  },
});

type Test = Pick<typeof playwrightTest, 'describe' | 'step' | 'use'> &
  ((title: string, run: (given: { page: PlaywrightPage }) => Promise<void>) => void);

/** Playwright's test, as far as a page without a browser can be tested. */
export const test = Object.assign(ofPage, {
  describe,
  step: (_: string, run: () => unknown) => run(),
  /** For the tests of this file, or of the group around it. */
  use: (given: Options) =>
    beforeEach(() => {
      options = { ...options, ...given };
    }),
}) as unknown as Test;

export const expect = drawnExpect as unknown as typeof playwrightExpect;

/** Waits until the page has drawn what was done to it, and until every part of it that this asks for has come and is drawn. */
export async function allCame(_: PlaywrightPage): Promise<void> {
  for (let left = 10; left > 0; left--) {
    await drawn();
  }
}
