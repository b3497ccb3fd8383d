import type { Page } from '@playwright/test';
import { languages } from '../../src/words/index.ts';
import {
  connected,
  endWorkers,
  letWorkersBeEnded,
  openBus,
  openFile,
  openText,
  status,
  useVirtualBus,
} from '../browser/ended-workers.ts';
import { expect, test } from './page.ts';

const traceWords = await languages.en.trace();
const checksumWords = await languages.en.checksum();

/** A page in which workers cannot be made, as where a policy forbids them. */
const forbidWorkers = (page: Page) =>
  page.addInitScript(() => {
    window.Worker = class {
      constructor() {
        throw new DOMException('forbidden', 'SecurityError');
      }
    } as unknown as typeof Worker;
  });

test('where workers are forbidden, the bus says so', async ({ page }) => {
  await forbidWorkers(page);
  await page.goto('./');
  await openBus(page);
  await useVirtualBus(page).click();
  await expect(status(page)).toContainText('A policy of the browser or of the server forbids workers');
  await expect(useVirtualBus(page)).toBeEnabled();
});

test('where workers are forbidden, a log is said not to have been read, and the checksum of a file to have failed', async ({
  page,
}) => {
  const { forbidden } = traceWords.failed;
  await forbidWorkers(page);
  await openText(page);
  await expect(page.getByText(forbidden)).toBeVisible();
  await page.goto('./#log?log=demo');
  await expect(page.getByRole('status').filter({ hasText: forbidden })).toBeVisible();
  await openFile(page);
  await expect(page.getByText(checksumWords.failed)).toBeVisible();
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
