import { expect, test } from './page.ts';

const LOG = 'TX 11 03 00 6B 00 03 76 87\nRX 11 03 06 02 2B 00 00 00 64 C8 BA\nTX 11 03 00 6B 00 03 76 88\n';

test('a log that is opened as a file in the Frame view has the name of the file', async ({ page }) => {
  await page.goto('./');
  const file = { name: 'pump.log', mimeType: 'text/plain', buffer: Buffer.from(LOG) };
  await page.getByLabel('Open file…').setInputFiles(file);
  await expect(page.getByRole('status').filter({ hasText: 'pump.log, a text' })).toBeVisible();
  await expect(page.getByRole('listbox')).toHaveAccessibleName('3 frames');
});

test('a file that is empty, or cannot be read, is left to the Log view, which says so', async ({ page }) => {
  const open = (name: string, text: string) =>
    page.getByLabel('Open file…').setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
  await page.goto('./');
  await open('empty.log', '');
  await expect(page.getByText('No frames were found.')).toBeVisible();
  await page.getByRole('link', { name: 'Frame', exact: true }).click();
  // Its reader here finds the file all the same.
  await page.evaluate(() => {
    File.prototype.text = () => Promise.reject(new DOMException('It could not be found.', 'NotFoundError'));
  });
  await open('gone.log', LOG);
  await expect(page.getByRole('status').filter({ hasText: 'gone.log, a text' })).toBeVisible();
});
