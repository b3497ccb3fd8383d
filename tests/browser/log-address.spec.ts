import type { Page } from '@playwright/test';
import { languages } from '../../src/words/index.ts';
import { allCame, expect, test } from './page.ts';

const words = await languages.en.trace();
const input = await languages.en.input();

const list = (page: Page) => page.getByRole('listbox', { name: /(frame|exchange)s?$/ });
const chosen = (page: Page) => list(page).getByRole('option', { selected: true });
const part = (page: Page, name: string) => page.getByRole('button', { name, exact: true });
const filter = (page: Page) => page.getByRole('combobox', { name: words.filter });

test('a link to the demo log has its filter, its frame and its tab; Back and Forward go through what was clicked', async ({
  page,
}) => {
  await page.goto('./');
  await page.getByRole('button', { name: input.chips['faulty-log'] }).click();
  await expect(list(page)).toHaveAccessibleName('200 frames');
  await part(page, '1 wrong CRC').click();
  await expect(list(page)).toHaveAccessibleName('1 frame');
  await part(page, '3 exceptions').click();
  await list(page).getByRole('option').nth(1).click();
  await expect(page.getByRole('main')).toContainText('ILLEGAL DATA ADDRESS');
  await expect(page).toHaveURL(/#log\?log=demo&filter=exception&row=121$/);
  await page.reload();
  await expect(list(page)).toHaveAccessibleName('3 frames');
  await expect(chosen(page)).toHaveAttribute('aria-posinset', '2');
  await part(page, '3 exceptions').click();
  await expect(chosen(page)).toBeInViewport();
  await page.goBack();
  await expect(page.getByRole('list', { name: 'The frame' })).toBeVisible();
  await page.getByRole('tab', { name: words.tabs.names.statistics }).click();
  await expect(page).toHaveURL(/&tab=statistics$/);
  await page.goBack();
  await expect(filter(page)).toHaveValue('crc');
  await expect(list(page)).toHaveAccessibleName('1 frame');
  await page.goBack();
  await expect(list(page)).toHaveAccessibleName('200 frames');
  await page.goForward();
  await page.goForward();
  await expect(filter(page)).toHaveValue('exception');
  await expect(page.getByRole('tab', { name: words.tabs.names.statistics })).toHaveAttribute('aria-selected', 'true');
});

test('what an address says wrongly is said, and so is a frame that the list lacks', async ({ page }) => {
  await page.goto('./#log?log=demo&row=thirty&fliter=crc&filter=unti:6');
  await expect(list(page)).toHaveAccessibleName('200 frames');
  await expect(page.getByText('“row=thirty”')).toBeVisible();
  await expect(page.getByText('“fliter=crc”')).toBeVisible();
  await expect(page.getByText('Do you mean “unit”?')).toBeVisible();
  await page.goto('./#log?log=demo&row=201');
  await expect(page.getByText(words.missing(200, 200))).toBeVisible();
  await page.goto('./#log?log=demo&row=1&filter=crc');
  await expect(page.getByText(words.missing(0, 200))).toBeVisible();
});

test('the filter and the frame of a pasted log are there again when it is pasted after a reload', async ({ page }) => {
  const log =
    '10:31:12.300 Tx 11 03 00 6B 00 03 76 87\n10:31:14.300 Tx 11 03 00 00 00 04 46 99\n10:31:14.310 Rx 11 83 02 C1 34';
  await page.goto('./#log');
  await expect(page.getByRole('main')).toBeVisible();
  await allCame(page);
  await page.evaluate((text) => navigator.clipboard.writeText(text), log);
  await page.keyboard.press('Control+V');
  await filter(page).fill('exception');
  await expect(list(page)).toHaveAccessibleName('1 frame');
  await list(page).getByRole('option').click();
  await expect(page).toHaveURL(/#log\?log=pasted&filter=exception&row=3$/);
  await page.reload();
  await expect(page.getByText(words.notKept('pasted'))).toBeVisible();
  await allCame(page);
  await page.keyboard.press('Control+V');
  await expect(list(page)).toHaveAccessibleName('1 frame');
  await expect(chosen(page)).toHaveCount(1);
  await expect(page.getByRole('list', { name: 'The frame' })).toBeVisible();
});

test('the frame of an address is in sight in the list, and one that F8 chose in another tab', async ({ page }) => {
  await page.goto('./#log?log=demo&row=149');
  await expect(chosen(page)).toBeInViewport();
  await expect(chosen(page)).toHaveAttribute('aria-posinset', '149');
  await page.getByRole('tab', { name: words.tabs.names.statistics }).click();
  await page.keyboard.press('Shift+F8');
  await page.keyboard.press('Shift+F8');
  await expect(page).toHaveURL(/&row=93&/);
  await page.getByRole('tab', { name: words.tabs.names.rows }).click();
  await expect(chosen(page)).toHaveAttribute('aria-posinset', '93');
  await expect(chosen(page)).toBeInViewport();
});
