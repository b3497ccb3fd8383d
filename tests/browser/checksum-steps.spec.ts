import type { Locator } from '@playwright/test';
import { languages } from '#known';
import { AxeBuilder } from './axe.ts';
import { Steps } from './checksum-steps.ts';
import { expect, test } from './page.ts';

const words = await languages.en.checksumSteps();

test('the chosen step is in sight; at any width every column is there, each under its heading; axe finds nothing', async ({
  page,
}) => {
  const steps = new Steps(page);
  await steps.open(`bytes=${Array.from({ length: 256 }, (_, i) => i.toString(16).padStart(2, '0')).join('+')}`);
  const goTo = page.getByLabel(words.goTo);
  await goTo.fill('0xFF.7');
  await goTo.press('Enter');
  await expect(steps.chosen).toHaveText(/^shift 7/);
  await steps.list.scrollIntoViewIfNeeded();
  await expect(steps.chosen).toBeInViewport();

  await page.getByRole('textbox', { name: 'Bytes' }).fill('02 07');
  await expect(steps.chosen).toHaveText(/Byte 0 0x02/);
  await steps.list.focus();
  for (const [width, height] of [
    [320, 640],
    [390, 844],
    [640, 360],
    [1024, 768],
    [1400, 900],
  ] as const) {
    await page.setViewportSize({ width, height });
    await steps.press('Home');
    const left = (row: Locator) =>
      row.locator('th, td').evaluateAll((cells) =>
        cells.map((cell) => {
          const { left: at, width: wide } = cell.getBoundingClientRect();
          return wide > 0 ? Math.round(at) : undefined;
        }),
      );
    const heads = await left(steps.list.getByRole('row').first());
    expect(heads, `${width} px`).not.toContain(undefined);
    await expect
      .poll(() =>
        left(
          steps.list
            .getByRole('row')
            .filter({ hasText: words.shift(2) })
            .first(),
        ),
      )
      .toEqual(heads);
    const cut = await steps.list.evaluate((list) => list.scrollWidth - list.clientWidth);
    expect(cut, `${width} px`).toBeLessThanOrEqual(1);
  }

  for (const name of ['checksum-lrc-steps', 'checksum-printed-example']) {
    await page.locator(`details.${name} > summary`).click();
  }
  const axe = new AxeBuilder(page);
  expect(await axe.findings('.checksum-steps-body')).toEqual([]);
  // The 256 entries are all alike, and axe takes seconds for them.
  await page.locator('details.checksum-table > summary').click();
  await page.setViewportSize({ width: 320, height: 800 });
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320);
  await page.locator('details.checksum-table > summary').click();
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await axe.findingsOfColours()).toEqual([]);
});
