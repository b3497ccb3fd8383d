import { AxeBuilder } from './axe.ts';
import { Device } from './device-panel.ts';
import { expect, test } from './page.ts';

test.use({ viewport: { width: 320, height: 800 }, colorScheme: 'dark' });

test('the first letters find a register, and a device is kept; all fits into 320 px and breaks no rule of axe', async ({
  page,
}) => {
  const device = new Device(page);
  const field = device.form.field('startAddress');
  await page.goto('./#pdu/request?functionCode=3&startAddress=P0683&quantity=1');
  await page.getByRole('button', { name: /^Choose WEG drive/ }).click();
  await page.getByLabel('Register of WEG drive').focus();
  await page.keyboard.type('P0682');
  await expect(field).toHaveValue('682');
  // Whatever the letters went through is one step back.
  await page.keyboard.press('Tab');
  await page.goBack();
  await expect(field).toHaveValue('P0683');

  const expectFits = async () => expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320);
  await device.form.chooseDevice('S7-200 with holding registers from VB800');
  await expect(page.getByLabel(/^Register of S7-200/)).toBeVisible();
  await expectFits();
  await page.getByRole('heading', { name: 'Device', exact: true }).click();
  await device.choose('WEG drive');
  await device.press('Edit P0685 direction');
  await device.press('Remove P0685 direction');
  await expect(page.getByLabel('Notes')).toBeVisible();
  await expect(page).toHaveURL(/device=weg-drive\+%282%29/);
  await page.reload();
  await page.getByRole('heading', { name: 'Device', exact: true }).click();
  await expect(device.rows).toHaveCount(3);
  await device.cell('P0683', 'address').focus();
  for (const key of ['Enter', '7', '0', '0', '0', '0', 'Enter']) await page.keyboard.press(key);
  await expect(device.panel).toContainText('Address 70000 is not a whole number from 0 to 65535.');
  const expectNoFault = async () => {
    await expectFits();
    expect((await new AxeBuilder(page).findings()).join('\n')).toBe('');
  };
  await expectNoFault();

  await device.choose('Modicon 984 references');
  await page.getByText('Import a register map').click();
  await page.getByText('Wrong or odd in its source').click();
  await expectNoFault();
});
