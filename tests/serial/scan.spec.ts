import { writeFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { AxeBuilder } from '../browser/axe.ts';
import { openedChooser } from './harness/chooser.ts';
import { expect, test } from './harness/fixtures.ts';

const status = (page: Page) => page.getByRole('region', { name: 'Connection' }).getByRole('status');

/** Opens the view, connects with 19200 baud, 8E1, and opens a panel. */
async function connect(page: Page, panel: string): Promise<void> {
  await page.goto('/#bus');
  await page.getByRole('button', { name: 'Connect…' }).click();
  const chooser = await openedChooser();
  await chooser.pick(0);
  await expect(status(page)).toContainText('Connected to FTDI FT232R, 19200 baud, 8E1.');
  await page.getByRole('tab', { name: panel }).click();
}

test('a scan opens the port with other speeds, and puts back what it had', async ({ page, plugAdapter }) => {
  const { cable } = await plugAdapter({ unit: 3 });
  await connect(page, 'Scan');
  await page.getByText('Other speeds and formats').click();
  await page.getByLabel('38400', { exact: true }).check();
  await page.getByLabel('8N2', { exact: true }).check();
  await page.getByLabel('First unit').fill('3');
  await page.getByLabel('Last unit').fill('4');
  await page.getByLabel('Wait for a reply (ms)').fill('3000');
  await page.getByRole('button', { name: 'Start the scan' }).click();
  await expect.poll(cable.settings).toBe('38400 none 2 none');
  const found = page.getByRole('region', { name: 'What was found' }).locator('tbody tr');
  await expect(page.getByText('The scan is complete.')).toBeVisible();
  // A pseudo-terminal carries bytes at any speed.
  await expect(found).toHaveCount(1);
  await expect(found.locator('td').first()).toHaveText('3');
  await expect(found).toContainText('38400 baud, 8N2');
  await expect(status(page)).toContainText('Connected to FTDI FT232R, 19200 baud, 8E1.');
  await expect.poll(cable.settings).toBe('19200 even 1 none');
});

test('what others send is split, paired and counted', async ({ page, plugAdapter }) => {
  const { cable } = await plugAdapter({ unit: null });
  await connect(page, 'Listen');
  await page.getByRole('button', { name: 'Listen', exact: true }).click();
  await expect(page.getByText('Listening. Nothing can be sent meanwhile.')).toBeVisible();
  // Unit 17 is asked for three registers from 107 on, answers, and refuses the next time (PI-MBUS-300).
  const bytes = '11 03 00 6B 00 03 76 87  11 03 06 AE 41 56 52 43 40 49 AD  11 03 00 6B 00 03 76 87  11 83 02 C1 34';
  writeFileSync(
    cable.device,
    Uint8Array.from(bytes.split(/ +/), (pair) => Number.parseInt(pair, 16)),
  );
  const counts = page.getByRole('region', { name: 'What was heard, by unit and function' });
  await expect(counts.locator('tbody td')).toHaveText([
    '17 (0x11)',
    '03 Read Holding Registers',
    '2',
    '1',
    '1',
    '0',
    '0',
  ]);
  const lines = page
    .getByRole('region', { name: 'Log' })
    .getByRole('listbox', { name: '4 frames' })
    .getByRole('option');
  await expect(lines).toHaveCount(4);
  await expect(lines.first()).toContainText('request');
  await page.setViewportSize({ width: 320, height: 900 });
  expect(await new AxeBuilder(page).findings()).toEqual([]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320);
  await page.getByRole('button', { name: 'Stop listening' }).click();
  await expect(page.getByText('Listening was stopped.')).toBeVisible();
});
