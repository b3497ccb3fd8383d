import type { Page, Route } from '@playwright/test';
import { languages } from '#known';
import {
  connected,
  endWorkers,
  letWorkersBeEnded,
  openBus,
  openFile,
  openText,
  status,
  useVirtualBus,
} from './ended-workers.ts';
import { expect, test } from './page.ts';

// What the browser says of workers that these tests keep from coming.
test.use({
  expected:
    /^((503:|failed:) \S+\/(session|trace|digest)-worker-\S+( net::ERR_FAILED)?|console error: Failed to load resource: .* 503 \(.*\)|(failed: \S+|console error: Failed to load resource:) net::ERR_INTERNET_DISCONNECTED)$/,
});

const traceWords = await languages.en.trace();
const checksumWords = await languages.en.checksum();

/** Lets a worker's script not come, once or always; returns whether it was asked for. */
async function keepAway(page: Page, script: RegExp, times?: number): Promise<() => boolean> {
  let asked = false;
  const refuse = (route: Route) => {
    asked = true;
    return route.fulfill({ status: 503, body: '' });
  };
  await page.route(script, refuse, times === undefined ? {} : { times });
  return () => asked;
}

test('a bus whose worker is not served, is opened offline, or ends while a request waits says so, and comes with the next click', async ({
  page,
  context,
}) => {
  await letWorkersBeEnded(page);
  await keepAway(page, /session-worker/, 1);
  await page.goto('./#rtu/request?unitId=99&functionCode=3&startAddress=0&quantity=1');
  await openBus(page);
  await useVirtualBus(page).click();
  await expect(status(page)).toContainText('did not load');
  await context.setOffline(true);
  const failed = page.waitForEvent('requestfailed');
  await useVirtualBus(page).click();
  await failed;
  await expect(status(page)).toContainText('did not load');
  await context.setOffline(false);
  await useVirtualBus(page).click();
  await expect(status(page)).toContainText(connected);

  await page.getByRole('button', { name: 'Send' }).click();
  await endWorkers(page);
  await expect(status(page)).toContainText('has ended unexpectedly');
  await expect(page.getByText(/waiting for the reply/)).toHaveCount(0);
  await useVirtualBus(page).click();
  await expect(status(page)).toContainText(connected);
  await expect(page.getByRole('button', { name: 'Send' })).toBeEnabled();
});

test('a log and a file are said not to have been read where their workers do not come', async ({ page }) => {
  const asked = await keepAway(page, /(trace|digest)-worker/);
  await openText(page);
  await expect(page.getByText(traceWords.failed['not-loaded'])).toBeVisible();
  expect(asked()).toBe(true);
  await openFile(page);
  await expect(page.getByText(checksumWords.failed)).toBeVisible();
});

test('a log is said not to have been read when its worker ends', async ({ page }) => {
  await letWorkersBeEnded(page);
  // A reader that lives, and never comes to an end.
  const body = `navigator.locks.request(name, () => { postMessage('alive'); return new Promise(() => {}); });`;
  await page.route(/trace-worker/, (route) => route.fulfill({ contentType: 'text/javascript', body }));
  await openText(page);
  await expect(page.getByRole('progressbar')).toBeVisible();
  await expect
    .poll(() => page.evaluate(async () => (await navigator.locks.query()).pending?.map(({ name }) => name)))
    .toEqual([expect.stringMatching('framewright-trace')]);
  await endWorkers(page);
  await expect(page.getByText(traceWords.failed.died)).toBeVisible();
  await expect(page.getByRole('progressbar')).toHaveCount(0);
});
