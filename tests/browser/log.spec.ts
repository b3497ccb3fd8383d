import type { Page } from '@playwright/test';
import { demoLog, languages } from '#known';
import { AxeBuilder } from './axe.ts';
import { builtFile } from './built-file.ts';
import { button, chosen, filter, list, openLog, openTab, saving } from './log-view.ts';
import { expect, test } from './page.ts';

const words = await languages.en.trace();
const { tabs } = words;

const width = (page: Page) => page.evaluate(() => document.documentElement.scrollWidth);

test('axe finds nothing beside a log, while it is filtered, and where it is saved, and at 320 px nothing is wider', async ({
  page,
}) => {
  await openLog(page, demoLog());
  await page.keyboard.press('F8');
  await expect(page.getByRole('list', { name: 'The frame' })).toBeVisible();
  expect(await new AxeBuilder(page).findings()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await new AxeBuilder(page).findingsOfColours()).toEqual([]);
  await page.setViewportSize({ width: 320, height: 640 });
  expect(await width(page)).toBeLessThanOrEqual(320);

  await filter(page).fill('fc:x ');
  await expect(page.getByRole('listbox', { name: words.completions })).toBeVisible();
  await page.keyboard.press('ArrowDown');
  expect(await new AxeBuilder(page).findings()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'light' });
  expect(await new AxeBuilder(page).findingsOfColours()).toEqual([]);
  expect(await width(page)).toBeLessThanOrEqual(320);

  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await expect(filter(page)).toHaveValue('');
  await button(page, words.export.open).click();
  await saving(page).getByRole('radio', { name: words.export.formats.csv }).check({ force: true });
  expect(await new AxeBuilder(page).findings()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await new AxeBuilder(page).findingsOfColours()).toEqual([]);
  expect(await width(page)).toBeLessThanOrEqual(320);
  expect((await saving(page).boundingBox())?.width).toBeLessThanOrEqual(320);
});

test('the frame of an address is in sight in the list, and one that F8 chose in another tab', async ({ page }) => {
  await page.goto('./#log?log=demo&row=149');
  await expect(chosen(page)).toBeInViewport();
  await expect(chosen(page)).toHaveAttribute('aria-posinset', '149');
  await openTab(page, tabs.names.statistics);
  await page.keyboard.press('Shift+F8');
  await page.keyboard.press('Shift+F8');
  await expect(page).toHaveURL(/&row=93&/);
  await openTab(page, tabs.names.rows);
  await expect(chosen(page)).toHaveAttribute('aria-posinset', '93');
  await expect(chosen(page)).toBeInViewport();
});

test('a drag over the picture shows a part of the time, a click goes to the row; axe finds nothing in each tab, which comes when it is opened, also at 320 px', async ({
  page,
}) => {
  await page.goto('./#log?log=demo');
  await expect(list(page)).toBeVisible();
  const loaded = (tab: string) =>
    page
      .evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name))
      .then((names) => names.some((name) => builtFile(`src/ui/trace/tabs/${tab}-tab.tsx`).test(name)));
  expect([await loaded('timeline'), await loaded('statistics'), await loaded('values')]).toEqual([false, false, false]);
  await openTab(page, tabs.names.timeline);
  const picture = page.getByRole('slider', { name: tabs.timeline.label });
  await expect(picture).toHaveAttribute('aria-valuemax', '101');
  expect([await loaded('timeline'), await loaded('statistics')]).toEqual([true, false]);
  const at = async (part: number) => {
    const { x, y, width, height } = (await picture.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
    return [x + part * width, y + height / 2] as const;
  };
  await page.mouse.move(...(await at(0.4)));
  await page.mouse.down();
  await page.mouse.move(...(await at(0.7)), { steps: 4 });
  await page.mouse.up();
  await expect(filter(page)).toHaveValue(/^from:\S+ to:\S+$/);
  await expect(picture).not.toHaveAttribute('aria-valuemax', '101');
  await page.goBack();
  await expect(picture).toHaveAttribute('aria-valuemax', '101');
  await page.mouse.click(...(await at(0.5)));
  await expect(list(page)).toBeFocused();
  await expect(chosen(page)).toBeInViewport();
  for (const tab of ['timeline', 'statistics', 'values'] as const) {
    await page.emulateMedia({ colorScheme: 'light' });
    await page.setViewportSize({ width: 1280, height: 720 });
    await openTab(page, tabs.names[tab]);
    await expect(page.getByRole('status').filter({ hasText: tabs.counting })).toHaveCount(0);
    expect(await new AxeBuilder(page).findings()).toEqual([]);
    await page.emulateMedia({ colorScheme: 'dark' });
    await page.setViewportSize({ width: 320, height: 640 });
    expect(await new AxeBuilder(page).findings()).toEqual([]);
    expect(await width(page)).toBeLessThanOrEqual(320);
  }
});
