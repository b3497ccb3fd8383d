import { allCame, expect, test } from './page.ts';

test('keys open views, list themselves, and can be turned off where they are characters', async ({ page }) => {
  await page.goto('./');
  await expect(page.getByRole('textbox', { name: 'A frame, a log or code' })).toBeFocused();
  await allCame(page);
  await page.keyboard.press('Escape');
  await page.keyboard.press('2');
  await expect(page.getByRole('link', { name: 'Log', exact: true })).toHaveAttribute('aria-current', 'page');
  await page.goBack();
  await expect(page.getByRole('link', { name: 'Frame', exact: true })).toHaveAttribute('aria-current', 'page');

  await page.keyboard.press('?');
  const keys = page.getByRole('dialog', { name: 'Keys' });
  await expect(keys).toContainText('Ctrl+Enter');
  await keys.getByRole('checkbox').uncheck();
  await page.keyboard.press('Escape');
  await expect(keys).toHaveCount(0);
  await page.keyboard.press('2');
  await page.keyboard.press('Control+/');
  await expect(keys).toBeVisible();
  await keys.getByRole('checkbox').check();
  await keys.getByRole('button', { name: 'Close' }).click();
  await expect(page.getByRole('link', { name: 'Frame', exact: true })).toHaveAttribute('aria-current', 'page');
});

test('Ctrl+K goes to the input, F8 to its next fault, and Escape leaves it', async ({ page }) => {
  await page.goto('./');
  await expect(page.getByRole('button', { name: /^Copy / }).first()).toBeVisible();
  await allCame(page);
  const text = page.getByRole('textbox', { name: 'A frame, a log or code' });
  await page.keyboard.press('Control+k');
  await expect(text).toBeFocused();
  await text.fill(
    'TX 11 03 00 6B 00 03 76 87\nRX 11 83 02 C1 34\nRX 11 03 06 02 2B 00 00 00 64 C8 BB\nRX 11 83 02 C1 35',
  );
  const chosen = page.getByRole('listbox').getByRole('option', { selected: true });
  await expect(page.getByRole('button', { name: 'Open in the Log view' })).toBeVisible();
  await page.keyboard.press('F8');
  await expect(page.getByRole('listbox')).toBeVisible();
  await page.keyboard.press('F8');
  await expect(chosen).toHaveAttribute('data-index', '1');
  await page.goBack();
  await text.focus();
  await page.keyboard.press('Escape');
  await expect(text).not.toBeFocused();
});

test('c copies the frame, and is typed in a field', async ({ page }) => {
  await page.goto('./#rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3');
  await expect(page.getByRole('button', { name: /^Copy / }).first()).toHaveAttribute('aria-keyshortcuts', 'c');
  await allCame(page);
  await page.keyboard.press('c');
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toBe('11 03 00 6B 00 03 76 87');
  await page.getByLabel('Quantity', { exact: true }).press('c');
  await expect(page.getByLabel('Quantity', { exact: true })).toHaveValue(/c/);
});
