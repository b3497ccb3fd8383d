import { expect, test } from './page.ts';

const LOG = 'TX 11 03 00 6B 00 03 76 87\nRX 11 03 06 02 2B 00 00 00 64 C8 BA\nTX 11 03 00 6B 00 03 76 88\n';

test('a log that is opened as a file in the Frame view has the name of the file', async ({ page }) => {
  await page.goto('./');
  const file = { name: 'pump.log', mimeType: 'text/plain', buffer: Buffer.from(LOG) };
  await page.getByLabel('Open file…').setInputFiles(file);
  await expect(page.getByRole('status').filter({ hasText: 'pump.log, a text' })).toBeVisible();
  await expect(page.getByRole('listbox')).toHaveAccessibleName('3 frames');
});
