import type { Page } from '@playwright/test';
import { Bus, READ_33 } from '../browser/bus-view.ts';
import { expect, test } from './page.ts';

const rows = (page: Page) => page.getByRole('region', { name: 'What was found' }).locator('tbody tr');
const firstCells = (page: Page) => rows(page).locator('td:first-child');
const start = (page: Page) => page.getByRole('button', { name: 'Start the scan' });

test('units, functions and addresses are found, copied, and opened as frames', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.tab('Scan');
  const last = page.getByLabel('Last unit');
  await last.fill('many');
  await expect(last).toHaveAttribute('aria-invalid', 'true');
  await last.fill('0x28');
  await expect(page.getByText('40 requests, 4 s at most.')).toBeVisible();
  await page.getByLabel('Wait for a reply (ms)').fill('50');
  await start(page).click();
  await expect(page.getByText('The scan is complete.')).toBeVisible();
  // The devices of the sources.
  await expect(firstCells(page)).toHaveText(['1', '6', '9', '17', '33']);
  await expect(page.getByRole('heading', { name: '5 units found' })).toBeVisible();
  await page.getByRole('button', { name: 'Copy as Markdown' }).click();
  await expect(page.getByText('Copied.')).toBeVisible();
  const text = await page.evaluate(() => navigator.clipboard.readText());
  expect(text).toMatch(/^\| 1 \| 01 \| 19200 baud, 8E1 \| Reply \| [\d.]+ ms \|$/m);

  await page.getByLabel('Functions of a unit').check();
  await page.getByLabel('Unit to scan').fill('6');
  await start(page).click();
  await expect(page.getByRole('heading', { name: '2 functions found' })).toBeVisible();
  // The drive of the source knows 03 and the identification, of those that change nothing.
  await expect(rows(page).filter({ hasText: 'yes' }).locator('td:first-child')).toHaveText(['03', '43 (0x2B)']);
  await expect(rows(page).filter({ hasText: 'ILLEGAL FUNCTION' })).toHaveCount(10);

  await page.getByLabel('Addresses of a unit').check();
  await page.getByLabel('Unit to scan').fill('33');
  await page.getByLabel('First address').fill('990');
  await page.getByLabel('Last address').fill('1010');
  await start(page).click();
  await expect(page.getByText('The scan is complete.')).toBeVisible();
  await expect(rows(page).filter({ hasText: 'Reply' }).first()).toBeVisible();
  await rows(page).filter({ hasText: 'Reply' }).first().getByRole('button', { name: 'Open' }).click();
  await expect(page.getByRole('textbox', { name: 'Unit (slave address)' })).toHaveValue('33');
  await page.goBack();
  // What was found is still there, and so is what was chosen.
  // The tab is in the address.
  await expect(rows(page).filter({ hasText: 'Reply' }).first()).toBeVisible();
  await page.reload();
  await expect(page.getByLabel('First address')).toHaveValue('990');
});

test('other speeds are tried, the line is put back, and a scan can be stopped', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.tab('Scan');
  await page.getByText('Other speeds and formats').click();
  await page.getByLabel('9600', { exact: true }).check();
  await page.getByLabel('19200', { exact: true }).check();
  await page.getByLabel('Last unit').fill('2');
  await page.getByLabel('Wait for a reply (ms)').fill('50');
  await start(page).click();
  await expect(page.getByText('The scan is complete.')).toBeVisible();
  await expect(rows(page).filter({ hasText: '19200 baud, 8E1' }).locator('td:first-child')).toHaveText(['1']);
  await expect(bus.status).toContainText('Connected to the virtual bus, 19200 baud, 8E1.');

  await page.getByLabel('Last unit').fill('247');
  await page.getByLabel('Wait for a reply (ms)').fill('2000');
  await start(page).click();
  await expect(rows(page)).not.toHaveCount(0);
  await page.getByRole('button', { name: 'Stop the scan' }).click();
  await expect(page.getByText('The scan was stopped.')).toBeVisible();
  await expect(bus.status).toContainText('Connected to the virtual bus, 19200 baud, 8E1.');
});

test('while this page listens it sends nothing', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open('rtu/request?unitId=1&functionCode=3&startAddress=10&quantity=2');
  await bus.tab('Listen');
  await bus.button('Listen').click();
  await expect(page.getByText('Nothing has been heard yet.')).toBeVisible();
  await bus.button('Send').click();
  await expect(page.getByText('Not sent: this page is listening')).toBeVisible();
  await bus.tab('Poll');
  await bus.button('Start').click();
  await expect(page.locator('.poll').getByText('Not sent: this page is listening')).toBeVisible();
  await bus.tab('Listen');
  await page.getByRole('button', { name: 'Stop listening' }).click();
  await expect(page.getByText('Listening was stopped.')).toBeVisible();
  await bus.button('Send').click();
  await expect(bus.result).toContainText(/Answered\.|refused/);
});
