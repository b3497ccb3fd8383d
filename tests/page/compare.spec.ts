import type { Page } from '@playwright/test';
import { expect, test } from './page.ts';

/** Read 3 registers from 107 of unit 17: 11 03 00 6B 00 03 76 87. */
const READ = './#rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3&v=3&tab=compare';

async function compare(page: Page, text: string) {
  await page.getByLabel('What your device sent').fill(text);
}

const differences = (page: Page) => page.getByRole('list', { name: 'Differences' }).getByRole('listitem');
const lines = (page: Page) => page.getByRole('list', { name: 'Byte by byte' }).getByRole('listitem');

test('each difference stands under its bytes, with its cause and what to do', async ({ page }) => {
  await page.goto(READ);
  await compare(page, '11 03 9C AC 00 03 2A E9');
  await expect(page.getByText('2 differences')).toBeVisible();
  await expect(lines(page)).toHaveCount(5);
  await expect(lines(page).nth(2)).toHaveText(/^address\s*differs\s*Built\s*00\s*6B\s*Sent\s*9C\s*AC\s*$/);
  await expect(lines(page).nth(3)).not.toContainText('differs');
  await expect(differences(page).nth(0)).toContainText('Start address 00 6B → 9C AC (107 → 40108)');
  await expect(differences(page).nth(0)).toContainText('40108 is the number in the manual');
  await expect(differences(page).nth(0)).toContainText('Send 107 (0x006B).');
  await expect(differences(page).nth(1)).toContainText(
    'The two bytes of the CRC are the other way round. It should be E9 2A',
  );
});

test('a missing byte leaves the bytes after it under their own', async ({ page }) => {
  await page.goto('./#rtu/request?unitId=17&functionCode=16&startAddress=1&registers=0x000A%200x0102&v=3&tab=compare');
  await compare(page, '11 10 00 01 00 02 00 0A 01 02 24 C4');
  await expect(lines(page).nth(4)).toHaveText(/^byte count\s*missing\s*Built\s*04\s*Sent\s*––\s*$/);
  await expect(lines(page).nth(5)).toHaveText(/^registers\s*Built\s*00\s*0A\s*01\s*02\s*Sent\s*00\s*0A\s*01\s*02\s*$/);
});

test('equal frames are called identical, and what is typed stays while the frame changes', async ({ page }) => {
  await page.goto(READ);
  await compare(page, '110300 6B0003 7687');
  await expect(page.getByText('Identical', { exact: true })).toBeVisible();
  await expect(differences(page)).toHaveCount(0);

  const quantity = page.getByLabel('Quantity', { exact: true });
  await quantity.fill('2');
  await expect(page.getByText('2 differences')).toBeVisible();
  // The frame before stays, and is compared.
  await quantity.fill('none');
  await expect(page.getByText('2 differences')).toBeVisible();
  await quantity.fill('3');
  await expect(page.getByText('Identical', { exact: true })).toBeVisible();
  await expect(page.getByLabel('What your device sent')).toHaveValue('110300 6B0003 7687');

  await page.getByRole('link', { name: 'Reference' }).click();
  await page.goBack();
  await expect(page.getByLabel('What your device sent')).toHaveValue('110300 6B0003 7687');
  await expect(page.getByText('Identical', { exact: true })).toBeVisible();
});

test('a text that is no bytes is kept, with what would do, and no result of before stays', async ({ page }) => {
  await page.goto(READ);
  await compare(page, '11 03 00 6B 00 03 76 87');
  const sent = page.getByLabel('What your device sent');
  await sent.fill('nothing was received');
  await expect(sent).toHaveAttribute('aria-invalid', 'true');
  await expect(page.getByText('These are not bytes.')).toBeVisible();
  await expect(page.getByText('Identical', { exact: true })).toHaveCount(0);
  await expect(lines(page)).toHaveCount(0);
  await expect(sent).toHaveValue('nothing was received');
});

test('bytes of the frame are lit in the comparison and everywhere else', async ({ page }) => {
  await page.goto(READ);
  await compare(page, '11 03 00 6A 00 03 27 47');
  await differences(page).nth(0).hover();
  await expect(page.getByRole('list', { name: 'The frame' }).locator('.byte[data-lit]')).toHaveText([/^00/, /^6B/]);
  await expect(lines(page).locator('[data-lit]')).toHaveText([/00/, /6B/]);
});
