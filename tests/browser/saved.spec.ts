import { AxeBuilder } from './axe.ts';
import { expect, test } from './page.ts';
import { SavedFrames } from './saved-frames.ts';

test('what another tab saves, renames or deletes appears here', async ({ page, context }) => {
  const saved = new SavedFrames(page);
  await saved.open();
  await saved.save('Pump');
  const other = new SavedFrames(await context.newPage());
  await other.open('#rtu/request?unitId=17&functionCode=3&startAddress=0x6B&quantity=3');
  await other.save('Fan');
  await expect(saved.names).toHaveText(['Pump', 'Fan']);
  await other.button('Delete Pump').click();
  await expect(saved.names).toHaveText(['Fan']);
});

test('axe finds nothing in the saved frames, light and dark, and 320 px are wide enough', async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 640 });
  const saved = new SavedFrames(page);
  await saved.open();
  for (const name of ['Pump', 'W'.repeat(200), 'Fan']) await saved.save(name);
  await saved.button('Delete Fan').click();
  await saved.button('Rename Pump').click();
  await saved.import('bad.json', '{');
  await expect(saved.said).toContainText('Nothing imported');
  await saved.panel.getByRole('checkbox', { name: 'Choose Pump', exact: true }).check();
  expect(await new AxeBuilder(page).findings()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await new AxeBuilder(page).findingsOfColours()).toEqual([]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
});
