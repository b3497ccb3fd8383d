import { AxeBuilder } from './axe.ts';
import { FrameForm } from './form.ts';
import { expect, test } from './page.ts';

const READ_40108 = '#pdu/request?functionCode=3&startAddress=40108&quantity=3';

test('a number of a manual in an address field: said, and repaired at one click', async ({ page }) => {
  await page.goto(`./${READ_40108}`);
  const form = new FrameForm(page);
  const field = form.field('startAddress');
  expect(await form.copied()).toBe('039CAC0003');
  await expect(page.getByText('As a number of five digits it is holding register 107 (40108).')).toBeVisible();

  await page.getByRole('button', { name: 'Use HR108, address 107 (0x006B)' }).click();
  await expect(field).toHaveValue('HR108');
  await expect(field).toHaveAccessibleDescription(/107, 0x006B, 40108/);
  expect(await form.copied()).toBe('03006B0003');
  expect(new URL(page.url()).hash).toContain('startAddress=HR108');
  await expect(page.getByRole('button', { name: /^Use / })).toHaveCount(0);
  await page.goBack();
  await expect(field).toHaveValue('40108');
  expect(await form.copied()).toBe('039CAC0003');

  // Another table, another function.
  await field.fill('3x9');
  await page.getByRole('button', { name: 'Use function 04 with IR9' }).click();
  expect(await form.copied()).toBe('0400080003');

  // Beyond the end.
  await field.fill('0xFFFE');
  await page.getByRole('button', { name: 'Ask for 2', exact: true }).click();
  await expect(form.field('quantity')).toHaveValue('2');

  // What is none keeps its text.
  await field.fill('HR');
  await expect(field).toHaveValue('HR');
  await expect(field).toHaveAccessibleDescription(/“HR” is not an address/);
  await expect(page.getByText('No frame', { exact: true })).toBeVisible();
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
  await expect(page.getByText('Functions that may use it: 03, 06, 10, 16, 17, 18.')).toBeVisible();

  await page.keyboard.press('Tab');
  const convention = page.getByLabel('Your manual’s convention');
  await expect(convention).toBeFocused();
  await convention.selectOption('Five or six digits');
  await expect(page.getByText('first holding register is printed as 40001 or 400001')).toBeVisible();

  // The frame follows while it is typed; the link says the same to who has another manual.
  await field.fill('40108');
  expect(await form.copied()).toBe('03006B0003');
  await expect(field).toHaveValue('40108');
  await field.blur();
  expect(new URL(page.url()).hash).toContain('startAddress=HR108');
  await page.setViewportSize({ width: 320, height: 640 });
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await new AxeBuilder(page).findings()).toEqual([]);

  // Remembered, as typed; what a link holds counts from 0 all the same, and the page says so.
  await page.reload();
  await expect(field).toHaveValue('40108');
  expect(await form.copied()).toBe('03006B0003');
  await page.evaluate((hash) => {
    location.hash = hash;
  }, READ_40108);
  await expect(page.getByText('In your manual 40108 is address 107 (0x006B).')).toBeVisible();
  expect(await form.copied()).toBe('039CAC0003');
});

test('function 17 has two addresses, each with its own ways', async ({ page }) => {
  await page.goto('./#pdu/request?functionCode=23&readStartAddress=4x4&writeStartAddress=40015&writeRegisters=255');
  const form = new FrameForm(page);
  await page.getByRole('button', { name: 'Use HR15, address 14 (0x000E)' }).click();
  await expect(form.field('writeStartAddress')).toHaveValue('HR15');
  // The written item is called by its address.
  await page.getByText('Edit one by one').click();
  await expect(page.getByLabel('Item 1, address 14 (0x000E)')).toHaveValue('255');
  expect(await form.copied()).toBe('17000300010' + '00E0001020' + '0FF');
});
