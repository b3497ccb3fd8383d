import { AxeBuilder } from './axe.ts';
import { expect, test } from './page.ts';

/** Set 30 Hz of unit 6: 06 06 02 AB 10 00 F5 E5. */
const WRITE = './#rtu/request?v=5&unitId=6&functionCode=6&address=683&value=4096&tab=program&program=c.build';

test('the guide’s listing is explained, nothing is inaccessible, and 320 px are enough', async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 800 });
  await page.goto(WRITE.replace('c.build', 'structured-text.check'));
  await expect(page.locator('.code [data-token="keyword"]').first()).toBeVisible();
  expect(await new AxeBuilder(page).findings()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await new AxeBuilder(page).findingsOfColours()).toEqual([]);
  await page.getByRole('button', { name: 'Why the guide’s listing does not compile' }).click();
  const guide = page.getByRole('region', { name: 'As the guide prints it' });
  await expect(guide).toContainText('UINT_TO_BYTE(Register >> 8)');
  await expect(guide).toContainText('SHR(value, 8) shifts');
  await expect(page.getByRole('region', { name: 'As it is written here' })).toContainText('SHR(Address, 8)');
  expect(await new AxeBuilder(page).findings()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'light' });
  expect(await new AxeBuilder(page).findingsOfColours()).toEqual([]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320);
});
