import { FrameForm } from '../browser/form.ts';
import { expect, test } from './page.ts';

test('a function is found by its number, decimal first, and by words; Escape gives back what stood there', async ({
  page,
}) => {
  await page.goto('./');
  const form = new FrameForm(page);
  const field = page.getByRole('combobox', { name: 'Function', exact: true });
  await expect(field).toHaveValue('06 Write Single Register');
  await field.click();
  await expect(page.getByRole('listbox').getByRole('option')).toHaveCount(20);
  await field.fill('16');
  await expect(page.getByRole('listbox').getByRole('option')).toHaveText([
    '16 (0x10) Write Multiple Registers',
    '22 (0x16) Mask Write Register',
  ]);
  await field.press('Enter');
  await expect(field).toHaveValue('16 (0x10) Write Multiple Registers');
  await expect(form.field('registers')).toBeVisible();
  await field.fill('write');
  await field.press('ArrowDown');
  await field.press('Escape');
  await expect(field).toHaveValue('16 (0x10) Write Multiple Registers');
  // 43 begins with what people want of it.
  await field.fill('43');
  await field.press('Tab');
  await expect(field).toHaveValue('43/14 (0x2B/0x0E) Read Device Identification');
  await expect(form.field('meiType').locator('option').first()).toHaveText('14 (0x0E) Read Device Identification');
});

test('coils are turned over one by one by keyboard, and typed as bytes', async ({ page }) => {
  // The example of AP 6.11: ten coils from address 19 on, CD 01.
  await page.goto('./#pdu/request?functionCode=15&startAddress=19&bits=1100110100');
  const form = new FrameForm(page);
  await form.expectBytes('0F 00 13 00 0A 02 B3 00');
  const bytes = page.getByLabel('As bytes');
  await expect(bytes).toHaveValue('B3 00');
  // Key by key: on the way stands one byte, which leaves ten coils ten.
  await bytes.fill('');
  await bytes.pressSequentially('CD 01');
  await form.expectBytes('0F 00 13 00 0A 02 CD 01');
  await expect(form.field('bits')).toHaveValue('1 0 1 1 0 0 1 1 1 0');
  const first = page.getByRole('button', { name: 'Address 19 (0x0013)' });
  await first.focus();
  await page.keyboard.press('Space');
  await expect(first).toHaveAttribute('aria-pressed', 'false');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('button', { name: 'Address 28 (0x001C)' })).toBeFocused();
  await page.keyboard.press('Space');
  await form.expectBytes('0F 00 13 00 0A 02 CC 03');
  // On the way to 10 stands 1, which takes no bits away.
  await page.getByLabel('How many').press('Control+A');
  await page.getByLabel('How many').pressSequentially('10');
  await form.expectBytes('0F 00 13 00 0A 02 CC 03');
  await page.getByLabel('How many').fill('3');
  await form.expectBytes('0F 00 13 00 03 01 04');
});

test('a value in a unit that nothing knows: by what full scale is, or by a device, at the field', async ({ page }) => {
  await page.goto('./#pdu/request?functionCode=6&address=0x02AB&value=1');
  const form = new FrameForm(page);
  const value = form.field('value');
  await value.fill('45 bar');
  await expect(value).toHaveAccessibleDescription(/choose a device, or say what full scale is/);
  await page.getByRole('button', { name: 'Full scale…' }).click();
  await page.getByLabel('Full scale, in bar').fill('60');
  await page.getByLabel('Full scale, in bar').press('Enter');
  await form.expectBytes('06 02 AB 18 00');
  await expect(value).toHaveValue('45 bar');
  await value.fill('30 Hz');
  await page.getByRole('button', { name: 'Choose a device…' }).click();
  await page
    .getByRole('dialog')
    .getByRole('button', { name: /^WEG drive/ })
    .click();
  await form.expectBytes('06 02 AB 10 00');
  await expect(page.getByRole('form').getByRole('button', { name: 'Device: WEG drive' })).toBeVisible();
});

test('Enter takes a value as a step, Escape gives back what stood there and closes what opened', async ({ page }) => {
  await page.goto('./#pdu/request?functionCode=6&address=0x02AB&value=1');
  const form = new FrameForm(page);
  const value = form.field('value');
  await value.fill('7');
  await value.press('Enter');
  await expect(page).toHaveURL(/value=7/);
  await value.fill('70000');
  await value.press('Escape');
  await expect(value).toHaveValue('7');
  await page.goBack();
  await expect(value).toHaveValue('1');
  const ways = page.getByRole('button', { name: 'All ways to write it: Address' });
  await ways.click();
  await expect(page.getByRole('definition').filter({ hasText: '40684' })).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(page.getByRole('definition')).toHaveCount(0);
  await expect(ways).toBeFocused();
});
