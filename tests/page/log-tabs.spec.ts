import { readFileSync } from 'node:fs';
import { languages } from '../../src/words/index.ts';
import { button, list, openTab, paste } from '../browser/log-view.ts';
import { expect, test } from './page.ts';

const { tabs: words } = await languages.en.trace();

/** AP 6.3 and AP 6.6: unit 1 is read each second and refuses once; unit 17 is silent. */
const LOG = Array.from({ length: 40 }, (_, n) => {
  const at = (milliseconds: number) => `10:31:${String(n).padStart(2, '0')}.${String(milliseconds).padStart(3, '0')}`;
  if (n === 20) return [`${at(0)} Tx 11 03 00 6B 00 03 76 87`];
  if (n === 10) return [`${at(0)} Tx 01 06 00 01 00 03 98 0B`, `${at(90)} Rx 01 06 00 01 00 03 98 0B`];
  const ask = `${at(0)} Tx 01 03 00 6B 00 03 74 17`;
  return [ask, `${at(5 + n)} Rx ${n === 30 ? '01 83 02 C0 F1' : '01 03 06 02 2B 00 00 00 64 05 7A'}`];
})
  .flat()
  .join('\n');

test('a log over time, counted, and as what became known: each leads to its rows', async ({ page }) => {
  await page.goto('./#log');
  await expect(page.getByRole('main')).toBeVisible();
  await paste(page, LOG);
  await expect(list(page)).toHaveAccessibleName('79 frames');

  await openTab(page, words.names.timeline);
  const picture = page.getByRole('slider', { name: words.timeline.label });
  await picture.focus();
  await page.keyboard.press('End');
  await page.keyboard.press('Shift+ArrowLeft');
  await page.keyboard.press('Enter');
  await expect(picture).toHaveAttribute('aria-valuemax', '2');
  await button(page, words.timeline.showAll).click();
  await expect(picture).toHaveAttribute('aria-valuemax', '40');

  await openTab(page, words.names.statistics);
  const seventeen = page.getByRole('row', { name: /^17/ });
  await expect(seventeen).toContainText('1 without a reply');
  await button(page, words.statistics.columns.maximum).click();
  await seventeen.getByRole('button').click();
  await expect(list(page)).toHaveAccessibleName('1 frame');
  await expect(list(page)).toBeFocused();

  await openTab(page, words.names.values);
  const values = page.getByRole('listbox', { name: '4 values' });
  await expect(values.getByRole('option', { name: /40108/ })).toContainText('555');
  const saved = page.waitForEvent('download');
  await button(page, words.values.save).click();
  const [, row] = readFileSync(await (await saved).path(), 'utf8').split('\r\n');
  expect(row).toBe('1,holding register,1,40002,,3,,10:31:10.090000,0,1,0');
  await button(page, words.values.makeDevice(1)).click();
  await expect(page.getByRole('status').filter({ hasText: words.values.deviceMade('Unit 1') })).toBeVisible();
  await page.getByRole('link', { name: words.values.editDevice }).click();
  await expect(page.getByRole('main')).toContainText('40108');
});

test('each way of counting leads from its first line to the rows', async ({ page }) => {
  await page.goto('./#log?log=demo');
  for (const by of Object.values(words.statistics.byNames)) {
    await openTab(page, words.names.statistics);
    await page.getByRole('radio', { name: by, exact: true }).check({ force: true });
    const rows = page.getByRole('table', { name: by, exact: true }).getByRole('row');
    await rows.nth(1).getByRole('button').click();
    await expect(list(page)).toBeFocused();
  }
});
