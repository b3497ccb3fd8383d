import { languages } from '../../src/words/index.ts';
import { button, chosen, filter, list, openTab, paste } from '../browser/log-view.ts';
import { expect, test } from './page.ts';

const words = await languages.en.trace();
const input = await languages.en.input();

test('a link to the demo log has its filter, its frame and its tab; Back and Forward go through what was clicked', async ({
  page,
}) => {
  await page.goto('./');
  await page.getByRole('button', { name: input.chips['faulty-log'] }).click();
  await expect(list(page)).toHaveAccessibleName('200 frames');
  await button(page, '1 wrong CRC').click();
  await expect(list(page)).toHaveAccessibleName('1 frame');
  await button(page, '3 exceptions').click();
  await list(page).getByRole('option').nth(1).click();
  await expect(page.getByRole('main')).toContainText('ILLEGAL DATA ADDRESS');
  await expect(page).toHaveURL(/#log\?log=demo&filter=exception&row=121$/);
  await page.reload();
  await expect(list(page)).toHaveAccessibleName('3 frames');
  await expect(chosen(page)).toHaveAttribute('aria-posinset', '2');
  await button(page, '3 exceptions').click();
  await page.goBack();
  await expect(page.getByRole('list', { name: 'The frame' })).toBeVisible();
  await openTab(page, words.tabs.names.statistics);
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
  await paste(page, log);
  await filter(page).fill('exception');
  await expect(list(page)).toHaveAccessibleName('1 frame');
  await list(page).getByRole('option').click();
  await expect(page).toHaveURL(/#log\?log=pasted&filter=exception&row=3$/);
  await page.reload();
  await expect(page.getByText(words.notKept('pasted'))).toBeVisible();
  await paste(page, log);
  await expect(list(page)).toHaveAccessibleName('1 frame');
  await expect(chosen(page)).toHaveCount(1);
  await expect(page.getByRole('list', { name: 'The frame' })).toBeVisible();
});
