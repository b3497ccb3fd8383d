import type { Page } from '@playwright/test';
import { languages } from '../../src/words/index.ts';
import { demoLog } from '../../src/workbench/index.ts';
import { filter, list, openLog } from '../browser/log-view.ts';
import { expect, test } from './page.ts';

const words = await languages.en.trace();

const offered = (page: Page) => page.getByRole('listbox', { name: words.completions });
const marked = (page: Page) => offered(page).getByRole('option', { selected: true });

test('a filter is completed by keys, with the terms, and the values and names that occur', async ({ page }) => {
  await openLog(page, demoLog());
  await filter(page).focus();
  await expect(offered(page)).toBeHidden();
  await page.keyboard.type('exc');
  await expect(filter(page)).toHaveAttribute('aria-expanded', 'true');
  await expect(marked(page)).toHaveCount(0);
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  await expect(marked(page)).toContainText('exception:');
  const active = await filter(page).getAttribute('aria-activedescendant');
  expect(await marked(page).getAttribute('id')).toBe(active);
  await page.keyboard.press('Enter');
  await expect(filter(page)).toHaveValue('exception:');
  await expect(offered(page).getByRole('option')).toHaveText([
    /^02.*illegal data address.*2×$/i,
    /^06.*server device busy.*1×$/i,
  ]);
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await expect(filter(page)).toHaveValue('exception:02');
  await expect(offered(page)).toBeHidden();
  await expect(list(page)).toHaveAccessibleName('2 frames');
  // Escape empties the text once no list is open.
  await page.keyboard.press('Escape');
  await expect(filter(page)).toHaveValue('');
  await expect(list(page)).toHaveAccessibleName('200 frames');
  await page.keyboard.type('ille');
  await offered(page)
    .getByRole('option', { name: /^exception:02/ })
    .click();
  await expect(filter(page)).toHaveValue('exception:02');
  await expect(filter(page)).toBeFocused();
  await page.keyboard.type(' ');
  await expect(offered(page)).toBeVisible();
  await page.keyboard.press('Tab');
  await expect(offered(page)).toBeHidden();
  await expect(filter(page)).toHaveValue('exception:02 ');
});

test('a mistake is said of its word, and the rows are said to be those of before', async ({ page }) => {
  await openLog(page, demoLog());
  await filter(page).fill('exception');
  await expect(list(page)).toHaveAccessibleName('3 frames');
  await filter(page).fill('exception unti:3 fc:x');
  await expect(filter(page)).toHaveAttribute('aria-invalid', 'true');
  await expect(filter(page)).toHaveAccessibleDescription(
    /The filter knows no “unti”\. Do you mean “unit”\?.*“x” is not a number/,
  );
  await expect(page.getByText(words.keptFilter('exception'))).toBeVisible();
  await expect(list(page)).toHaveAccessibleName('3 frames');
  await expect(page.locator('.wrong-places mark')).toHaveText(['unti:3', 'fc:x']);
  // A word that is still being typed is not wrong yet.
  await filter(page).fill('exception unit:');
  await expect(filter(page)).toHaveAttribute('aria-invalid', 'false');
  await expect(page.getByText(words.keptFilter('exception'))).toBeVisible();
  await filter(page).blur();
  await expect(filter(page)).toHaveAttribute('aria-invalid', 'true');
  await filter(page).fill('exception unit:99');
  await expect(page.getByText(words.nothingMatches)).toBeVisible();
});

test.describe('in a time zone', () => {
  test.use({ timezoneId: 'Europe/Zurich' });

  test('the clock of the filter is the one that the rows show, and whose it is is said', async ({ page }) => {
    await openLog(page, demoLog());
    await expect(page.getByText(words.clockOf('text', 'day', ''))).toBeVisible();
    // In summer, two hours ahead of UTC, whatever the season is now.
    const begin = Date.UTC(2026, 6, 1, 8, 30) * 1000;
    const records = [0, 60, 120].map((at) => ({ time: begin + at * 1e6, bytes: '060302A900015425' }));
    const buffer = Buffer.from(JSON.stringify({ format: 'framewright trace', version: 1, records }));
    await page.getByLabel(words.openFile).setInputFiles({ name: 'log.json', mimeType: 'application/json', buffer });
    await expect(list(page)).toHaveAccessibleName('3 frames');
    await expect(page.getByText(words.clockOf('json', undefined, 'Europe/Zurich'))).toBeVisible();
    await filter(page).fill('from:10:31');
    await expect(list(page)).toHaveAccessibleName('2 frames');
    await expect(list(page).getByRole('option').first()).toContainText('10:31:00.000');
  });
});
