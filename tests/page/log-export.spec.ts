import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { readCapture } from '../../src/captures/index.ts';
import { languages } from '../../src/words/index.ts';
import { demoLog } from '../../src/workbench/index.ts';
import { button, filter, list, openLog, saving } from '../browser/log-view.ts';
import { expect, test } from './page.ts';

const words = await languages.en.trace();
const { export: own } = words;

async function saved(page: Page): Promise<{ readonly name: string; readonly bytes: Buffer }> {
  const coming = page.waitForEvent('download');
  await button(page, own.save).click();
  const download = await coming;
  return { name: download.suggestedFilename(), bytes: readFileSync((await download.path()) ?? '') };
}

const choose = (page: Page, name: string) => saving(page).getByRole('radio', { name }).check({ force: true });

test('a log is saved in each format, all of it or what is filtered, and opened again', async ({ page }) => {
  await openLog(page, demoLog(), 'unit 6.txt');
  await expect(list(page)).toHaveAccessibleName('200 frames');
  await button(page, own.open).click();
  const capture = await saved(page);
  expect(capture.name).toBe('unit 6-saved.pcapng');
  expect(readCapture(capture.bytes)).toMatchObject({ format: 'pcapng', records: { length: 200 }, problems: [] });
  await expect(saving(page).getByRole('status')).toContainText('200 frames');
  await choose(page, own.formats.json);
  const json = await saved(page);
  expect(readCapture(json.bytes)).toMatchObject({ format: 'json', records: { length: 200 } });
  await button(page, own.close).click();

  await filter(page).fill('exception');
  await expect(list(page)).toHaveAccessibleName('3 frames');
  await button(page, own.open).click();
  await choose(page, own.formats.csv);
  const table = await saved(page);
  expect(readCapture(table.bytes)).toMatchObject({ format: 'csv', records: { length: 3 } });
  await page.keyboard.press('Escape');
  await expect(saving(page)).toBeHidden();
  await page.getByLabel(words.openFile).setInputFiles({ name: table.name, mimeType: 'text/csv', buffer: table.bytes });
  await expect(page.getByText(words.source(table.name, 'csv'))).toBeVisible();
  await expect(list(page)).toHaveAccessibleName('3 frames');
});

test('a report is copied, with nothing of what is replaced', async ({ page }) => {
  // AP 6.3's request to unit 0x7B, and a refusal (exception 02).
  await openLog(
    page,
    ['10:31:12.300 Tx 7B 03 00 6B 00 03 7F 8D', '10:31:12.310 Rx 7B 83 02 E1 28'].join('\n'),
    'unit 6.txt',
  );
  await button(page, own.open).click();
  await choose(page, own.formats.report);
  for (const text of Object.values(own.replaced)) await saving(page).getByLabel(text).check();
  await button(page, own.copy).click();
  await expect(saving(page).getByRole('status')).toHaveText(own.copied(2));
  const report = await page.evaluate(() => navigator.clipboard.readText());
  expect(report).toMatch(/^# Modbus log\n\n- 2 frames, 1 exchange\n- 1 exception\n- unit 1\n/);
  expect(report).not.toMatch(/7B|123|unit 6|40108|00 6B/);
  const { name } = await saved(page);
  expect(name).toBe('log-replaced.md');
});

test('a large file says how far it is, and is given up', async ({ page }) => {
  const records = Array.from({ length: 60_000 }, (_, time) => ({ time: 1000 * time, bytes: '060302A900015425' }));
  await openLog(page, JSON.stringify({ format: 'framewright trace', version: 1, records }));
  await button(page, own.open).click();
  for (const text of Object.values(own.replaced)) await saving(page).getByLabel(text).check();
  await choose(page, own.formats.csv);
  await button(page, own.save).click();
  await expect(page.getByRole('progressbar', { name: own.making })).toBeVisible();
  await saving(page).getByRole('button', { name: own.cancel, exact: true }).click();
  await expect(saving(page).getByRole('status')).toHaveText(own.notMade['given-up']);
});
