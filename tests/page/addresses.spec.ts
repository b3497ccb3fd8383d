import { FrameForm } from '../browser/form.ts';
import { expect, test } from './page.ts';

const READ_40108 = '#pdu/request?functionCode=3&startAddress=40108&quantity=3';

test('a number of a manual in an address field: both readings, the other one click away', async ({ page }) => {
  await page.goto('./#pdu/request?functionCode=3&startAddress=1&quantity=3');
  const form = new FrameForm(page);
  const field = form.field('startAddress');
  await field.fill('40108');
  await form.expectBytes('03 00 6B 00 03');
  await expect(page.getByRole('button', { name: 'register 40108 = address 107' })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
  await page.getByRole('button', { name: 'address 40108', exact: true }).click();
  await form.expectBytes('03 9C AC 00 03');
  await expect(page.getByRole('group', { name: /may be either/ })).toHaveCount(0);
  await page.goBack();
  await expect(field).toHaveValue('40108');
  await form.expectBytes('03 00 6B 00 03');

  // A range fills the quantity too.
  await field.fill('401000–401003');
  await form.expectBytes('03 03 E7 00 04');
  await expect(form.field('quantity')).toHaveValue('4');

  // Another table, another function.
  await field.fill('3x9');
  await page.getByRole('button', { name: 'Use function 04 with IR9' }).click();
  await form.expectBytes('04 00 08 00 04');

  // Beyond the end.
  await field.fill('0xFFFE');
  await page.getByRole('button', { name: 'Ask for 2', exact: true }).click();
  await expect(form.field('quantity')).toHaveValue('2');

  // What is none keeps its text.
  await field.fill('HR');
  await expect(field).toHaveValue('HR');
  await expect(field).toHaveAccessibleDescription(/“HR” is not an address/);
});

test('all ways to write an address, and the convention of a manual, by keyboard', async ({ page }) => {
  await page.goto('./#pdu/request?functionCode=3&startAddress=0x6B&quantity=3');
  const form = new FrameForm(page);
  const field = form.field('startAddress');
  await expect(page.getByText('All ways to write it')).toBeVisible();
  await field.focus();
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  for (const way of ['107', '0x006B', '108', '40108', '400108', '4x108', 'HR108', '%MW107', '40107']) {
    await expect(page.getByRole('definition').filter({ hasText: new RegExp(`^${way}$`) })).toBeVisible();
  }
  await expect(
    page.getByText('Functions that may use it: 03, 06, 16 (0x10), 22 (0x16), 23 (0x17), 24 (0x18).'),
  ).toBeVisible();

  await page.keyboard.press('Tab');
  const convention = page.getByLabel('Your manual’s convention');
  await expect(convention).toBeFocused();
  await convention.selectOption('Five or six digits');
  await expect(page.getByText('first holding register is printed as 40001 or 400001')).toBeVisible();

  // The frame follows while it is typed; the link says the same to who has another manual.
  await page.keyboard.press('Escape');
  await field.fill('40108');
  await form.expectBytes('03 00 6B 00 03');
  await expect(field).toHaveValue('40108');
  await field.blur();
  expect(new URL(page.url()).hash).toContain('startAddress=HR108');

  // Remembered, as typed; what a link holds counts from 0 all the same, and the page says so.
  await page.reload();
  await expect(field).toHaveValue('40108');
  await form.expectBytes('03 00 6B 00 03');
  await page.evaluate((hash) => {
    location.hash = hash;
  }, READ_40108);
  await expect(page.getByText('In your manual 40108 is address 107 (0x006B).')).toBeVisible();
  await form.expectBytes('03 9C AC 00 03');
});

test('function 17 has two addresses, each with its own ways', async ({ page }) => {
  await page.goto('./#pdu/request?functionCode=23&readStartAddress=4x4&writeStartAddress=40015&writeRegisters=255');
  const form = new FrameForm(page);
  await page.getByRole('button', { name: 'register 40015 = address 14' }).click();
  await expect(form.field('writeStartAddress')).toHaveValue('HR15');
  // The written item is called by its address.
  await page.getByText('Edit one by one').click();
  await expect(page.getByLabel('Item 1, address 14 (0x000E)')).toHaveValue('255');
  await form.expectBytes('17 00 03 00 01 00 0E 00 01 02 00 FF');
});
