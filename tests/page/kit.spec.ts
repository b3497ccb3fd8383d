import type { Page } from '@playwright/test';
import { expect, test } from './page.ts';

/** Opens the page of controls. */
async function open(page: Page) {
  await page.goto('./kit.html');
  await expect(page.getByRole('heading', { name: 'Every control of the kit' })).toBeVisible();
}

test('a wrong text is said to be wrong, and its hint comes back', async ({ page }) => {
  await open(page);
  const field = page.getByLabel('Empty');
  await expect(field).toHaveAccessibleDescription('a number');
  await field.fill('many');
  await expect(field).toHaveAttribute('aria-invalid', 'true');
  await expect(field).toHaveAccessibleDescription('“many” is not a number');
  await field.fill('7');
  await expect(field).toHaveAttribute('aria-invalid', 'false');
  await expect(field).toHaveAccessibleDescription('a number');
});

test('a number is taken while it is typed, and the last one holds', async ({ page }) => {
  await open(page);
  const number = page.getByLabel('Number', { exact: true });
  await number.fill('1200');
  await expect(number).toHaveAccessibleDescription('1200 bits a second');
  await number.fill('fast');
  await expect(number).toHaveAccessibleDescription('not a whole number');
  await number.fill('19200');
  await expect(number).toHaveAccessibleDescription('19200 bits a second');
});

test('a value is chosen by name, and one of a few by keys', async ({ page }) => {
  await open(page);
  await page.getByLabel('Parity').selectOption('odd');
  await expect(page.getByLabel('Parity')).toHaveValue('odd');
  await page.getByRole('radio', { name: 'RTU' }).focus();
  await page.keyboard.press('ArrowRight');
  await expect(page.getByRole('radio', { name: 'ASCII' })).toBeChecked();
});

test('what a fold holds is made when it is opened, and stays only if it is kept', async ({ page }) => {
  await open(page);
  const inside = page.getByText('What is in it is made when it is opened.');
  await expect(inside).toHaveCount(0);
  await page.getByText('Folded', { exact: true }).click();
  await expect(inside).toBeVisible();
  await page.getByText('Folded', { exact: true }).click();
  await expect(inside).toHaveCount(0);
  await expect(page.locator('#there')).toHaveCount(1);

  const summary = page.locator('summary', { hasText: 'Kept' });
  await expect(page.locator('#kept')).toHaveCount(0);
  await summary.click();
  await page.locator('#kept').fill('typed');
  await summary.click();
  await expect(page.locator('#kept')).toBeHidden();
  await summary.click();
  await expect(page.locator('#kept')).toHaveValue('typed');
});

test('copying says what became of it', async ({ page }) => {
  await open(page);
  await page.evaluate(() => {
    navigator.clipboard.writeText = () => Promise.reject(new DOMException('refused'));
  });
  await page.getByRole('button', { name: 'Copy', exact: true }).click();
  await expect(page.getByText('Not copied: 01 03')).toBeVisible();
  await page.reload();
  await page.getByRole('button', { name: 'Copy', exact: true }).click();
  await expect(page.getByRole('button', { name: 'Copied.' })).toBeVisible();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe('01 03');
});

test('a file is saved, and the same one may be opened twice', async ({ page }) => {
  await open(page);
  const saved = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Download' }).click();
  expect((await saved).suggestedFilename()).toBe('frame.txt');
  const chooser = page.getByLabel('Open a file…');
  const file = { name: 'one.txt', mimeType: 'text/plain', buffer: Buffer.from('01 03') };
  await chooser.setInputFiles(file);
  await expect(page.getByText('one.txt')).toBeVisible();
  await expect(chooser).toHaveValue('');
  await expect(page.getByLabel('Open nothing…')).toBeDisabled();
});

test('of a long list only the lines in sight are drawn, wherever they are', async ({ page }) => {
  await open(page);
  const list = page.getByRole('listbox', { name: 'Ten thousand lines' });
  await expect(list.getByRole('option').first()).toBeVisible();
  expect(await list.getByRole('option').count()).toBeLessThan(40);
  await list.focus();
  await page.keyboard.press('End');
  await expect(list.getByRole('option', { selected: true })).toHaveText('Line 10000');
  expect(await list.getByRole('option').count()).toBeLessThan(40);
  await page.keyboard.press('Home');
  await expect(list.getByRole('option', { selected: true })).toHaveText('Line 1');
});

test('a number may wait until it is finished, and Escape gives it up', async ({ page }) => {
  await open(page);
  const number = page.getByLabel('Number taken when it is finished');
  const taken = (value: number) => expect(page.getByText(`The number is ${value}.`)).toBeVisible();
  await number.fill('1');
  await taken(247);
  await number.press('Enter');
  await taken(1);
  await number.fill('many');
  await expect(number).toHaveAccessibleDescription('');
  await number.blur();
  await expect(number).toHaveAccessibleDescription('not a whole number');
  await number.press('Escape');
  await expect(number).toHaveValue('1');
  await expect(number).toHaveAccessibleDescription('');
  await number.fill('12');
  await number.blur();
  await taken(12);
});

test('a table is copied in the format that was chosen', async ({ page }) => {
  await open(page);
  await page.getByLabel(/^as /).selectOption('CSV');
  await page.getByRole('button', { name: 'Copy the table' }).click();
  await expect(page.getByText('The table is copied.')).toBeVisible();
  expect((await page.evaluate(() => navigator.clipboard.readText())).split('\n')[1]).toBe('19200,52.083333333333336');
});

test('a dialog ends with Escape, and the focus goes back', async ({ page }) => {
  await open(page);
  const button = page.getByRole('button', { name: 'Ask' });
  const dialog = page.getByRole('dialog', { name: 'Is it to be sent?' });
  await button.focus();
  await page.keyboard.press('Enter');
  await expect(dialog).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(dialog).toHaveCount(0);
  await expect(button).toBeFocused();
  await button.click();
  await dialog.getByRole('button', { name: 'Yes' }).click();
  await expect(button).toBeFocused();
});

test('arrow keys open tabs, and a panel is drawn when it is first opened and then kept', async ({ page }) => {
  await open(page);
  const tab = (name: string) => page.getByRole('tab', { name });
  const shown = page.getByRole('tabpanel');
  await expect(page.locator('#tab-Waveform')).toHaveCount(0);
  await page.locator('#tab-Bytes').fill('01 03');
  await tab('Bytes').focus();
  await page.keyboard.press('ArrowRight');
  await expect(tab('Waveform')).toBeFocused();
  await expect(shown.getByLabel('Inside of Waveform')).toBeVisible();
  await expect(shown).toHaveCount(1);
  await page.keyboard.press('End');
  await expect(tab('Examples')).toHaveAttribute('aria-selected', 'true');
  await page.keyboard.press('ArrowRight');
  await expect(shown.getByLabel('Inside of Bytes')).toHaveValue('01 03');
});
