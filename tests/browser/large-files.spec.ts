import { randomBytes } from 'node:crypto';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { languages } from '#known';
import { FrameForm } from './form.ts';
import { expect, test } from './page.ts';

const trace = await languages.en.trace();
const input = await languages.en.input();

const SIZE = 50_000_000;
// A worker that comes back to this file after another one does both again.
let folder: string;
test.beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'framewright-'));
});
test.afterAll(() => rmSync(folder, { recursive: true }));

/** A file of 50 MB: the text as often as it fits, or bytes of chance. */
function large(name: string, text?: string): string {
  const path = join(folder, name);
  writeFileSync(path, text === undefined ? randomBytes(SIZE) : Buffer.alloc(SIZE, text));
  return path;
}

interface TraceEvent {
  readonly name: string;
  readonly pid: number;
  readonly tid: number;
  /** Of its thread, in microseconds. */
  readonly tdur?: number;
  readonly args: { readonly name?: string };
}

/**
 * Watches the tasks of the window; the answer is the longest, in milliseconds that the processor worked for it: how long it lay there
 * because others had the processor says nothing of the page.
 */
async function watchTasks(page: Page): Promise<() => Promise<number>> {
  const browser = page.context().browser()!;
  await browser.startTracing(page, { categories: ['disabled-by-default-devtools.timeline', '__metadata'] });
  return async () => {
    const { traceEvents }: { traceEvents: TraceEvent[] } = JSON.parse((await browser.stopTracing()).toString());
    const thread = ({ pid, tid }: TraceEvent) => `${pid} ${tid}`;
    const isWindow = new Set(traceEvents.filter(({ args }) => args.name === 'CrRendererMain').map(thread));
    const tasks = traceEvents.filter((event) => event.name === 'RunTask' && isWindow.has(thread(event)));
    const longest = Math.max(...tasks.map(({ tdur = 0 }) => tdur)) / 1000;
    expect(longest).toBeGreaterThan(0);
    return longest;
  };
}

/** Whether something was still being read when an element with this text came into the page. */
const readingAt = (page: Page, text: string) =>
  page.evaluate(
    (wanted) =>
      new Promise<boolean>((resolve) => {
        new MutationObserver((_, observer) => {
          if (!document.body.textContent.includes(wanted)) return;
          observer.disconnect();
          resolve(document.querySelector('progress') !== null);
        }).observe(document.body, { subtree: true, childList: true, characterData: true });
      }),
    text,
  );

test('50 MB of bytes are said to be no text before they have been read, and are offered as a frame', async ({
  page,
}) => {
  await page.goto('./');
  await expect(page.getByRole('list', { name: 'The frame' })).toBeVisible();
  const longest = await watchTasks(page);
  const early = readingAt(page, trace.binary('dump.bin', SIZE));
  await page.getByLabel(input.openFile).setInputFiles(large('dump.bin'));
  expect(await early).toBe(true);
  await expect(page.getByText(trace.source('dump.bin', 'bytes'), { exact: true })).toBeVisible();
  expect(await longest()).toBeLessThan(200);
  await page.getByRole('button', { name: trace.binaryAsFrame(256, SIZE) }).click();
  await expect(new FrameForm(page).strip).toBeVisible();
  await expect(page.getByRole('textbox', { name: input.label })).toHaveValue(/^([0-9A-F]{2}\s?){256}$/);
});

test('50 MB of a log keep the window free', async ({ page }) => {
  await page.goto('./');
  await expect(page.getByRole('list', { name: 'The frame' })).toBeVisible();
  const longest = await watchTasks(page);
  const line = '[RTU]>Tx > 10:31:12:300 - 01  03  00  6B  00  02  B5  D7\n';
  await page.getByLabel(input.openFile).setInputFiles(large('bus.log', line));
  await expect(page.getByText(trace.source('bus.log', 'text'), { exact: true })).toBeVisible();
  expect(await longest()).toBeLessThan(200);
  await expect(page.getByText(trace.binary('bus.log', SIZE))).toHaveCount(0);
});
