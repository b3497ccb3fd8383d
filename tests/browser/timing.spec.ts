import { AxeBuilder } from './axe.ts';
import { expect, test } from './page.ts';
import { Timing } from './timing-view.ts';

test('axe finds nothing, and at no width is anything wider than the page', async ({ page }) => {
  const timing = new Timing(page);
  for (const [colorScheme, hash] of [
    ['light', '#timing?baud=abc&format=9X9&gap=x'],
    ['dark', '#timing?baud=115200&format=8N1&gap=1'],
  ] as const) {
    await page.emulateMedia({ colorScheme });
    await timing.open(hash);
    expect(await new AxeBuilder(page).findings()).toEqual([]);
    for (const width of [320, 768, 1240]) {
      await page.setViewportSize({ width, height: 640 });
      expect(await page.evaluate(() => document.documentElement.scrollWidth), hash).toBeLessThanOrEqual(width);
      const cut = await page.evaluate(() =>
        Array.from(document.querySelectorAll('td, tbody th, output, p'))
          .filter((cell) => cell.scrollWidth > cell.clientWidth + 1)
          .map((cell) => cell.textContent),
      );
      expect(cut).toEqual([]);
    }
  }
});
