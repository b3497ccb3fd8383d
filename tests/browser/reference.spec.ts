import { languages } from '#known';
import { AxeBuilder } from './axe.ts';
import { expect, test } from './page.ts';
import { Reference } from './reference-view.ts';

const words = await languages.en.reference();

test('the list of tables leads to the place of each, and Back to the place that was left; axe finds nothing, with everything, something and nothing shown; at no width is anything wider than the page', async ({
  page,
}) => {
  const reference = new Reference(page);
  await reference.open();
  await page
    .getByRole('navigation', { name: words.tables })
    .getByRole('button', { name: words.subjects.units })
    .press('Enter');
  const heading = page.getByRole('heading', { name: words.subjects.units });
  await expect(heading).toBeFocused();
  await expect(heading).toBeInViewport();

  const row = reference.row('ranges', 'UMAS');
  await row.scrollIntoViewIfNeeded();
  const before = await page.evaluate(() => scrollY);
  expect(before).toBeGreaterThan(500);
  await row.getByRole('link').click();
  await expect(page.getByRole('heading', { name: 'Build' })).toBeVisible();
  await expect.poll(() => page.evaluate(() => scrollY), 'the frame begins at its top').toBe(0);
  await page.goBack();
  await expect(row).toBeInViewport();

  const axe = new AxeBuilder(page);
  expect(await axe.findings()).toEqual([]);
  for (const width of [320, 768, 1000, 1240]) {
    await page.setViewportSize({ width, height: 640 });
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
    const cut = await page.evaluate(() =>
      Array.from(document.querySelectorAll('td, tbody th'))
        .filter((cell) => cell.scrollWidth > cell.clientWidth + 1)
        .map((cell) => cell.textContent),
    );
    expect(cut).toEqual([]);
  }
  await reference.search.fill('nothing-at-all');
  await expect(reference.shown).toHaveText(/^0 of/);
  expect(await axe.findings()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'dark' });
  await reference.search.fill('16');
  await expect(reference.table('functions')).toBeVisible();
  expect(await axe.findingsOfColours()).toEqual([]);
});
