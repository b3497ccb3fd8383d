import type { Page, Route } from '@playwright/test';
import { languages } from '../../src/words/index.ts';
import { expect, test } from './page.ts';

// What the browser says of workers that these tests keep from coming.
test.use({
  expected:
    /^((503:|failed:) \S+\/(session|trace|digest)-worker-\S+( net::ERR_FAILED)?|console error: Failed to load resource: .* 503 \(.*\)|(failed: \S+|console error: Failed to load resource:) net::ERR_INTERNET_DISCONNECTED)$/,
});

const inputWords = await languages.en.input();
const traceWords = await languages.en.trace();
const checksumWords = await languages.en.checksum();

const connected = 'Connected to the virtual bus';
const status = (page: Page) => page.getByRole('region', { name: 'Connection' }).getByRole('status');
const useVirtualBus = (page: Page) => page.getByRole('button', { name: 'Use the virtual bus' });
const openBus = (page: Page) => page.getByRole('link', { name: 'Bus', exact: true }).click();

/** Lets a test end every worker of the page, as the browser does when memory runs out: no event tells of it. */
const letWorkersBeEnded = (page: Page) =>
  page.addInitScript(() => {
    const workers: Worker[] = [];
    const Own = window.Worker;
    window.Worker = class extends Own {
      constructor(address: string | URL, options?: WorkerOptions) {
        super(address, options);
        workers.push(this);
      }
    };
    Object.assign(window, { endWorkers: () => workers.splice(0).forEach((worker) => void worker.terminate()) });
  });

const endWorkers = (page: Page) => page.evaluate(() => (window as unknown as { endWorkers(): void }).endWorkers());

/** A page in which workers cannot be made, as where a policy forbids them. */
const forbidWorkers = (page: Page) =>
  page.addInitScript(() => {
    window.Worker = class {
      constructor() {
        throw new DOMException('forbidden', 'SecurityError');
      }
    } as unknown as typeof Worker;
  });

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

const longText = '06 06 02 AB 10 00 F5 E5\n'.repeat(2500);

async function openText(page: Page): Promise<void> {
  await page.goto('./');
  await page
    .getByLabel(inputWords.openFile)
    .setInputFiles({ name: 'bus.log', mimeType: 'text/plain', buffer: Buffer.from(longText) });
}

async function openFile(page: Page): Promise<void> {
  await page.goto('./#checksum');
  const buffer = Buffer.from('123456789');
  await page
    .locator('.checksum-input input[type=file]')
    .setInputFiles({ name: 'nine', mimeType: 'text/plain', buffer });
}

test('a bus whose worker is not served says so, and comes with the next click', async ({ page }) => {
  await keepAway(page, /session-worker/, 1);
  await page.goto('./');
  await openBus(page);
  await useVirtualBus(page).click();
  await expect(status(page)).toContainText('did not load');
  await useVirtualBus(page).click();
  await expect(status(page)).toContainText(connected);
});

test('a bus that is opened offline says so, and comes when the network is back', async ({ page, context }) => {
  await page.goto('./');
  await openBus(page);
  await expect(useVirtualBus(page)).toBeVisible();
  await context.setOffline(true);
  await useVirtualBus(page).click();
  await expect(status(page)).toContainText('did not load');
  await context.setOffline(false);
  await useVirtualBus(page).click();
  await expect(status(page)).toContainText(connected);
});

test('where workers are forbidden, the bus says so', async ({ page }) => {
  await forbidWorkers(page);
  await page.goto('./');
  await openBus(page);
  await useVirtualBus(page).click();
  await expect(status(page)).toContainText('A policy of the browser or of the server forbids workers');
  await expect(useVirtualBus(page)).toBeEnabled();
});

test('a bus whose worker ends while a request waits says so, and can be used again', async ({ page }) => {
  await letWorkersBeEnded(page);
  await page.goto('./#rtu/request?unitId=99&functionCode=3&startAddress=0&quantity=1');
  await openBus(page);
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

test('a poll whose worker ends says so, and goes on when it is connected again', async ({ page }) => {
  await letWorkersBeEnded(page);
  await page.goto('./#rtu/request?unitId=33&functionCode=3&startAddress=999&quantity=4');
  await openBus(page);
  await page.getByLabel('Speed of the virtual bus').selectOption('fast');
  await useVirtualBus(page).click();
  await expect(status(page)).toContainText(connected);
  await page.getByRole('tab', { name: 'Poll' }).click();
  await page
    .locator('.poll')
    .getByRole('button', { name: /^(Poll|Start)/ })
    .click();
  await expect(page.getByRole('button', { name: 'Stop' }).first()).toBeVisible();
  await endWorkers(page);
  await expect(page.getByText('The connection was closed, and the poll has ended.')).toBeVisible();
  await useVirtualBus(page).click();
  await expect(status(page)).toContainText(connected);
});

test('a sequence whose worker ends says that the line was lost', async ({ page }) => {
  await letWorkersBeEnded(page);
  await page.goto('./#bus');
  await useVirtualBus(page).click();
  await expect(status(page)).toContainText(connected);
  await page.getByRole('checkbox', { name: /Read only/ }).uncheck();
  await page.getByRole('tab', { name: 'Sequence' }).click();
  const panel = page.locator('.sequence');
  await panel.getByRole('button', { name: 'Start' }).click();
  await expect(panel.locator('.step[aria-current=step]')).toHaveCount(1);
  await endWorkers(page);
  await expect(panel.locator('.run-said')).toHaveText(
    'The line was lost. “Finally” could not be sent, because there is no line any more: look at the machine.',
  );
  await expect(panel.locator('.step-mark').last()).toHaveText('✗ the line is lost');
  await expect(panel.locator('.step[aria-current=step]')).toHaveCount(0);
});

test.describe('a log', () => {
  const { failed } = traceWords;

  test('is said not to have been read where its worker does not come', async ({ page }) => {
    const asked = await keepAway(page, /trace-worker/);
    await openText(page);
    await expect(page.getByText(failed['not-loaded'])).toBeVisible();
    expect(asked()).toBe(true);
  });

  test('is said not to have been read where workers are forbidden', async ({ page }) => {
    await forbidWorkers(page);
    await openText(page);
    await expect(page.getByText(failed.forbidden)).toBeVisible();
    await page.goto('./#log?log=demo');
    await expect(page.getByRole('status').filter({ hasText: failed.forbidden })).toBeVisible();
  });

  test('is said not to have been read when its worker ends', async ({ page }) => {
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
    await expect(page.getByText(failed.died)).toBeVisible();
    await expect(page.getByRole('progressbar')).toHaveCount(0);
  });
});

test.describe('the checksum of a file', () => {
  test('is said to have failed where its worker does not come', async ({ page }) => {
    await keepAway(page, /digest-worker/);
    await openFile(page);
    await expect(page.getByText(checksumWords.failed)).toBeVisible();
  });

  test('is said to have failed where workers are forbidden', async ({ page }) => {
    await forbidWorkers(page);
    await openFile(page);
    await expect(page.getByText(checksumWords.failed)).toBeVisible();
  });
});
