import { languages } from '#known';
import { AxeBuilder } from './axe.ts';
import { expect, test } from './page.ts';
import { SavedFrames } from './saved-frames.ts';

const words = await languages.en.input();

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

test('axe finds nothing in the examples and in the saved frames, light and dark, and 320 px are wide enough', async ({
  page,
}) => {
  await page.setViewportSize({ width: 320, height: 640 });
  await page.goto('./');
  const axe = new AxeBuilder(page);
  const expectNothing = async () => {
    await page.emulateMedia({ colorScheme: 'light' });
    expect(await axe.findings()).toEqual([]);
    await page.emulateMedia({ colorScheme: 'dark' });
    expect(await axe.findingsOfColours()).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
  };
  await page.getByRole('button', { name: words.drawer.open }).click();
  await page
    .getByRole('dialog', { name: words.drawer.title })
    .getByRole('button', { name: 'Set 30 Hz', exact: true })
    .click();
  await expectNothing();

  const saved = new SavedFrames(page);
  await saved.show();
  for (const name of ['Pump', 'W'.repeat(200), 'Fan', 'Valve']) await saved.save(name);
  await saved.button('Delete Fan').click();
  await saved.button('Rename Pump').click();
  await saved.panel.getByRole('checkbox', { name: 'Choose Valve', exact: true }).check();
  await saved.import('bad.json', '{');
  await expect(saved.said).toContainText('Nothing imported');
  await expectNothing();
});
