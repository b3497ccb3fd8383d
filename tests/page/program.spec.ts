import { readFile } from 'node:fs/promises';
import { unzipSync } from 'fflate';
import { expect, test } from './page.ts';

/** Set 30 Hz of unit 6: 06 06 02 AB 10 00 F5 E5. */
const WRITE = './#rtu/request?v=5&unitId=6&functionCode=6&address=683&value=4096&tab=program&program=c.build';

const saved = async (download: Promise<{ suggestedFilename(): string; path(): Promise<string> }>) => {
  const file = await download;
  return { name: file.suggestedFilename(), bytes: new Uint8Array(await readFile(await file.path())) };
};

test('a target and a part are chosen, kept in the link and remembered, and the text is highlighted', async ({
  page,
}) => {
  await page.goto('./');
  await page.getByRole('tab', { name: 'Program' }).click();
  await page.getByLabel('Program for').selectOption('Arduino');
  await page.getByLabel('Part', { exact: true }).selectOption('What builds the frame');
  const code = page.getByRole('region', { name: /^The program / });
  await expect(code).toContainText('#include <Arduino.h>');
  await expect(code.locator('[data-token="keyword"]').first()).toBeVisible();
  await expect(page).toHaveURL(/tab=program&program=arduino\.build$/);
  await expect(page.getByText(/^Compiled with g\+\+ /)).toBeVisible();

  await page.goto('./#tcp/request?unitId=1&functionCode=3&startAddress=0&quantity=2&tab=program');
  await page.reload();
  await expect(page.getByLabel('Program for')).toHaveValue('arduino');
  await page.getByText('Options', { exact: true }).click();
  await page.getByLabel('Address of the server').fill('10.0.0.7');
  await page.getByLabel('Part', { exact: true }).selectOption('The whole exchange');
  await expect(code).toContainText(/10, 0, 0, 7|10\.0\.0\.7/);
});

test('a byte lights the lines that make it, and a line its bytes', async ({ page }) => {
  await page.goto(WRITE);
  const lines = page.locator('.code-line[data-lit]');
  const bytes = page.getByRole('list', { name: 'The frame' }).locator('.byte[data-lit]');
  await page.getByRole('list', { name: 'The frame' }).locator('.byte').nth(2).hover();
  await expect(lines).toHaveText([/frame\[length\+\+\] = \(uint8_t\)\(address >> 8\)/, /= \(uint8_t\)address;/]);
  await page.locator('.code-line', { hasText: '(uint8_t)(checksum >> 8)' }).hover();
  await expect(bytes).toHaveText([/^F5/, /^E5/]);
});

test('a program is saved under its name, and all targets as one zip', async ({ page }) => {
  await page.goto(WRITE);
  const one = page.waitForEvent('download');
  await page.getByRole('button', { name: /^Save .*\.c$/ }).click();
  const file = await saved(one);
  expect(file.name).toMatch(/\.c$/);
  expect(new TextDecoder().decode(file.bytes)).toContain('0xA001');
  const all = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save all targets as a zip' }).click();
  const zip = await saved(all);
  expect(zip.name).toBe('modbus-programs.zip');
  const files = Object.keys(unzipSync(zip.bytes));
  expect(files).toContain(`c/${file.name}`);
  expect(files.some((path) => path.startsWith('structured-text/'))).toBe(true);
});

test('what cannot be written is said, and what a note says', async ({ page }) => {
  await page.goto('./#rtu/reply?unitId=6&functionCode=3&registers=1&tab=program&program=cobol.build&v=5');
  await expect(page.getByText('A program sends a request.')).toBeVisible();
  await expect(page.getByText('The link asks for “cobol.build”')).toBeVisible();
  await expect(page.getByRole('region', { name: /^The program / })).toHaveCount(0);
  await page.goto(WRITE);
  await page.getByText('Options', { exact: true }).click();
  await page.getByLabel('Names of your own').fill('value = int');
  await expect(page.getByText('“int” cannot be a name here')).toBeVisible();
  await page.getByLabel('Value', { exact: true }).fill('many');
  await expect(page.locator('.frame-tabs')).toHaveAttribute('data-stale', '');
  await expect(page.getByRole('region', { name: /^The program / })).toContainText('0xA001');
});

test('saved frames and a sequence have programs, too', async ({ page }) => {
  await page.goto(WRITE);
  await page.getByRole('button', { name: 'All examples and saved frames' }).click();
  await page.getByRole('tab', { name: /^Saved/ }).click();
  for (const name of ['set 30 Hz', 'once more']) {
    await page.getByLabel('Name of this frame', { exact: true }).fill(name);
    await page.getByRole('button', { name: 'Save this frame' }).click();
  }
  await page.getByRole('button', { name: 'Program of all 2' }).click();
  const dialog = page.getByRole('dialog', { name: 'Program: set 30 Hz, once more' });
  await dialog.getByLabel('Part', { exact: true }).selectOption('The bytes');
  await expect(dialog.getByRole('region')).toContainText(/set_30_hz/i);
  await expect(dialog.getByRole('region')).toContainText(/once_more/i);
  await dialog.getByRole('button', { name: 'Close' }).click();

  await page.goto('./#bus?tab=sequence');
  await page.getByRole('button', { name: 'Program', exact: true }).click();
  await expect(page.getByRole('dialog', { name: /^Program: / }).getByRole('region')).toContainText('int main(');
});
