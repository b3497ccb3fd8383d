import { FrameForm } from '../browser/form.ts';
import { expect, test } from './page.ts';

const clipboard = (page: import('@playwright/test').Page) => page.evaluate(() => navigator.clipboard.readText());

test('the reply to a write is its echo, and becomes the current frame with its request', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  const reply = page.getByRole('tabpanel', { name: 'Reply' });
  await page.getByRole('tab', { name: 'Reply' }).click();
  await expect(reply).toContainText('Every byte follows from the request.');
  await expect(reply).toContainText('06 06 02 AB 10 00 F5 E5');
  await reply.getByRole('button', { name: 'Build the exception' }).click();
  // 86 02 from unit 6: CRC-16 0x6072.
  await form.expectBytes('06 86 02 72 60');
  await expect(reply).toContainText('06 06 02 AB 10 00 F5 E5');
  await page.goBack();
  await reply.getByRole('button', { name: 'Build this reply' }).click();
  await expect(page.getByRole('radio', { name: 'Reply' })).toBeChecked();
  await form.expectBytes('06 06 02 AB 10 00 F5 E5');
  await expect(reply).toContainText('This frame answers the request:');
});

test('the reply to a read has the length that was asked for', async ({ page }) => {
  await page.goto('./#rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3&v=3&tab=reply');
  const reply = page.getByRole('tabpanel', { name: 'Reply' });
  await expect(reply).toContainText('11 bytes, of which 6 bytes hold the values');
  await expect(reply).toContainText('11 03 06 00 00 00 00 00 00');
  await reply.getByRole('button', { name: 'Build this reply' }).click();
  await page.getByRole('tab', { name: 'Bytes' }).click();
  await expect(new FrameForm(page).explanation).toContainText('Register 40108 (address 107) = 0');
});

test('a broadcast and a device told to be silent answer nothing', async ({ page }) => {
  await page.goto('./#rtu/request?unitId=0&functionCode=6&address=1&value=3&v=3&tab=reply');
  const reply = page.getByRole('tabpanel', { name: 'Reply' });
  await expect(reply).toContainText('None: no device answers a broadcast');
  await page.goto('./#rtu/request?unitId=1&functionCode=8&subFunction=4&data=00 00&v=3&tab=reply');
  await expect(reply).toContainText('None: after this sub-function');
});

test('items of a list are changed, added, removed, moved and filled one by one', async ({ page }) => {
  await page.goto('./#rtu/request?unitId=1&functionCode=16&startAddress=107&registers=1 0x2 3');
  const list = new FrameForm(page).field('registers');
  await page.getByText('Edit one by one').click();
  await page.getByLabel('Item 3, address 109').fill('30');
  await expect(list).toHaveValue('1 0x2 30');
  await page.getByRole('button', { name: 'Move item 2 up' }).click();
  await expect(list).toHaveValue('0x2 1 30');
  await page.getByRole('button', { name: 'Remove item 2' }).click();
  await expect(list).toHaveValue('0x2 30');
  await page.getByRole('button', { name: 'Add an item' }).click();
  await expect(list).toHaveValue('0x2 30 0');
  await page.getByLabel('Number of items').fill('4');
  await page.getByLabel('First value').fill('100');
  await page.getByLabel('Step').fill('5');
  await page.getByRole('button', { name: 'Fill' }).click();
  await expect(list).toHaveValue('100 105 110 115');
  await page.goBack();
  await expect(list).toHaveValue('0x2 30 0');
});

test('a column copied from a spreadsheet is a list', async ({ page }) => {
  await page.goto('./#rtu/request?unitId=1&functionCode=16&startAddress=0&registers=1');
  const form = new FrameForm(page);
  await page.evaluate(() => navigator.clipboard.writeText('10\r\n258\r\n'));
  await form.field('registers').selectText();
  await form.field('registers').press('Control+V');
  await form.expectCopied(/^01100000000204000A0102/);
});

test('a long run of registers folds, and unfolds', async ({ page }) => {
  await page.goto(`./#rtu/request?unitId=1&functionCode=16&startAddress=0&registers=${'7 '.repeat(123)}`);
  const field = new FrameForm(page).strip.locator('[data-kind="registers"]');
  const bytes = field.locator('.byte[data-from]');
  await expect(field).toContainText('238 more');
  await expect(bytes).toHaveCount(9);
  await field.getByRole('button', { name: /238 more/ }).click();
  await expect(bytes).toHaveCount(246);
  await field.getByRole('button', { name: /^Fold / }).click();
  await expect(bytes).toHaveCount(9);
});

test('from the first load to a copied frame by the keyboard alone', async ({ page }) => {
  await page.goto('./');
  await expect(page.getByRole('combobox', { name: 'Function', exact: true })).toBeVisible();
  const press = async (key: string, until: import('@playwright/test').Locator) => {
    for (let n = 0; n < 40; n++) {
      if (await until.evaluate((element) => element === document.activeElement)) return;
      await page.keyboard.press(key);
    }
    throw new Error('the focus never comes there');
  };
  await press('Tab', page.getByRole('combobox', { name: 'Function', exact: true }));
  await page.keyboard.type('read holding');
  await page.keyboard.press('Enter');
  const form = new FrameForm(page);
  await press('Tab', form.field('unitId'));
  await page.keyboard.type('17');
  await press('Tab', form.field('startAddress'));
  await page.keyboard.type('107');
  await press('Tab', form.field('quantity'));
  await page.keyboard.type('3');
  await press('Shift+Tab', page.getByRole('button', { name: /^Copy / }));
  await page.keyboard.press('Enter');
  await expect.poll(() => clipboard(page)).toBe('11 03 00 6B 00 03 76 87');
});
