import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { languages } from '../../src/words/index.ts';
import { AxeBuilder } from './axe.ts';
import { builtFile } from './built-file.ts';
import { allCame, expect, test } from './page.ts';

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

const open = (page: Page, name: string) => page.getByRole('tab', { name, exact: true }).click();

test('a log over time, counted, and as what became known: each leads to its rows', async ({ page }) => {
  await page.goto('./#log');
  await expect(page.getByRole('main')).toBeVisible();
  await allCame(page);
  await page.evaluate((content) => navigator.clipboard.writeText(content), LOG);
  await page.keyboard.press('Control+V');
  const list = page.getByRole('listbox', { name: /(frame|exchange)s?$/ });
  await expect(list).toHaveAccessibleName('79 frames');

  const loaded = (tab: string) =>
    page
      .evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name))
      .then((names) => names.some((name) => builtFile(`src/ui/trace/tabs/${tab}-tab.tsx`).test(name)));
  expect([await loaded('timeline'), await loaded('statistics'), await loaded('values')]).toEqual([false, false, false]);
  await open(page, words.names.timeline);
  const picture = page.getByRole('slider', { name: words.timeline.label });
  await picture.focus();
  expect([await loaded('timeline'), await loaded('statistics')]).toEqual([true, false]);
  await page.keyboard.press('End');
  await page.keyboard.press('Shift+ArrowLeft');
  await page.keyboard.press('Enter');
  await expect(picture).toHaveAttribute('aria-valuemax', '2');
  await page.getByRole('button', { name: words.timeline.showAll }).click();
  await expect(picture).toHaveAttribute('aria-valuemax', '40');
  expect(await new AxeBuilder(page).findings()).toEqual([]);

  await open(page, words.names.statistics);
  const seventeen = page.getByRole('row', { name: /^17/ });
  await expect(seventeen).toContainText('1 without a reply');
  await page.getByRole('button', { name: words.statistics.columns.maximum }).click();
  expect(await new AxeBuilder(page).findings()).toEqual([]);
  await seventeen.getByRole('button').click();
  await expect(list).toHaveAccessibleName('1 frame');
  await expect(list).toBeFocused();

  await open(page, words.names.values);
  const values = page.getByRole('listbox', { name: '4 values' });
  await expect(values.getByRole('option', { name: /40108/ })).toContainText('555');
  expect(await new AxeBuilder(page).findings()).toEqual([]);
  const saved = page.waitForEvent('download');
  await page.getByRole('button', { name: words.values.save }).click();
  const [, row] = readFileSync(await (await saved).path(), 'utf8').split('\r\n');
  expect(row).toBe('1,holding register,1,40002,,3,,10:31:10.090000,0,1,0');
  await page.getByRole('button', { name: words.values.makeDevice(1) }).click();
  await expect(page.getByRole('status').filter({ hasText: words.values.deviceMade('Unit 1') })).toBeVisible();
  await page.getByRole('link', { name: words.values.editDevice }).click();
  await expect(page.getByRole('main')).toContainText('40108');
});

test('a drag over the picture shows a part of the time, a click goes to the row; it is drawn in the dark and at 320 px', async ({
  page,
}) => {
  await page.goto('./#log?log=demo&tab=timeline');
  const picture = page.getByRole('slider', { name: words.timeline.label });
  await expect(picture).toHaveAttribute('aria-valuemax', '101');
  const at = async (part: number) => {
    const { x, y, width, height } = (await picture.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
    return [x + part * width, y + height / 2] as const;
  };
  await page.mouse.move(...(await at(0.4)));
  await page.mouse.down();
  await page.mouse.move(...(await at(0.7)), { steps: 4 });
  await page.mouse.up();
  await expect(page.getByRole('combobox', { name: 'Filter' })).toHaveValue(/^from:\S+ to:\S+$/);
  await expect(picture).not.toHaveAttribute('aria-valuemax', '101');
  await page.goBack();
  await expect(picture).toHaveAttribute('aria-valuemax', '101');
  await page.mouse.click(...(await at(0.5)));
  const list = page.getByRole('listbox', { name: /(frame|exchange)s?$/ });
  await expect(list).toBeFocused();
  await expect(list.getByRole('option', { selected: true })).toBeInViewport();
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.setViewportSize({ width: 320, height: 640 });
  for (const tab of ['timeline', 'statistics', 'values'] as const) {
    await page.getByRole('tablist', { name: words.label }).getByRole('tab', { name: words.names[tab] }).click();
    await expect(page.getByRole('status').filter({ hasText: words.counting })).toHaveCount(0);
    expect(await new AxeBuilder(page).findings()).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
  }
  for (const by of Object.values(words.statistics.byNames)) {
    await open(page, words.names.statistics);
    await page.getByRole('radio', { name: by, exact: true }).check({ force: true });
    const rows = page.getByRole('table', { name: by, exact: true }).getByRole('row');
    await rows.nth(1).getByRole('button').click();
    await expect(list).toBeFocused();
  }
});
