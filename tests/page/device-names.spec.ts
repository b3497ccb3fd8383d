import { readFileSync } from 'node:fs';
import { FrameForm } from '../browser/form.ts';
import { expect, test } from './page.ts';

test('a device’s name in an address field: read once its device is chosen, the same link for everybody', async ({
  page,
}) => {
  await page.goto('./#pdu/request?functionCode=3&startAddress=P0683&quantity=1');
  const form = new FrameForm(page);
  const field = form.field('startAddress');

  // A link means the same to everybody: the name is not read behind one's back, and it is one click away.
  await expect(field).toHaveValue('P0683');
  await expect(field).toHaveAccessibleDescription(/“P0683” is not an address/);
  await expect(page.getByText('“P0683” is P0683 speed reference in WEG drive.')).toBeVisible();
  await page.getByRole('button', { name: 'Choose WEG drive and use HR684, address 683 (0x02AB)' }).click();
  await form.expectBytes('03 02 AB 00 01');
  await expect(field).toHaveValue('P0683');
  expect(new URL(page.url()).hash).toContain('startAddress=HR684');

  // With the device chosen a name is read as it is typed.
  await field.fill('p 0681');
  await form.expectBytes('03 02 A9 00 01');
  await field.press('Tab');
  expect(new URL(page.url()).hash).toContain('startAddress=HR682');
  const register = page.getByLabel('Register of WEG drive');
  await expect(register).toBeFocused();
  const chosen = () =>
    register.evaluate((field) => {
      const { options, selectedIndex } = field as HTMLSelectElement;
      return options[selectedIndex]?.text;
    });
  await expect.poll(chosen).toBe('P0681 actual speed');
  await page.getByText('All ways to write it').click();
  await expect(page.getByRole('definition').filter({ hasText: 'P0681 actual speed' })).toBeVisible();
  await field.fill('P0999');
  await expect(field).toHaveValue('P0999');
  await expect(field).toHaveAccessibleDescription(/“P0999” is not an address/);
});

test('the registers of the chosen device, and a line of several requests', async ({ page }) => {
  await page.goto('./#pdu/request?functionCode=3&startAddress=9&quantity=1');
  const form = new FrameForm(page);
  const field = form.field('startAddress');
  await form.chooseDevice('WEG drive');

  const register = page.getByLabel('Register of WEG drive');
  await register.focus();
  await register.selectOption('P0682 control word');
  await expect(field).toHaveValue('682');
  await form.expectBytes('03 02 AA 00 01');
  await page.keyboard.press('Tab');
  await page.goBack();
  await expect(field).toHaveValue('9');

  // A register that can only be read takes the function along.
  await form.chooseFunction(6);
  await register.selectOption('P0681 actual speed');
  await form.expectBytes('03 02 A9 00 01');

  // A line of 1000 registers takes 8 requests.
  await form.chooseDevice('S7-200 with holding registers from VB800');
  await page.getByLabel(/^Register of S7-200/).selectOption('VW800 … VW2798');
  await form.expectBytes('03 00 00 00 7D');
  const parts = page.getByLabel('The whole line takes 8 requests');
  await parts.selectOption('3 of 8: address 250 to 374');
  await form.expectBytes('03 00 FA 00 7D');
  await field.fill('VW 804');
  await form.expectBytes('03 00 02 00 7D');
  await expect(parts).toHaveCount(0);
});

test('what a device does its own way is said where the frame breaks a rule', async ({ page }) => {
  await page.goto('./#rtu/reply?unitId=1&functionCode=3&registers=0x447A 0x2000&answering=01031B590001532D');
  await expect(page.getByText('The byte count is 4, but the request asked for 2.').first()).toBeVisible();
  await expect(page.getByText('it is right', { exact: false })).toHaveCount(0);
  await new FrameForm(page).chooseDevice('Enron, Daniel (flow computers)');
  const right = 'For Enron, Daniel (flow computers) it is right: there a value of 32 bits is counted as one';
  await expect(page.getByText(right).first()).toBeVisible();
});

test('what is known of a device as a whole is edited, exported and imported', async ({ page }) => {
  await page.goto('./');
  await page.getByRole('heading', { name: 'Device', exact: true }).click();
  await page.getByRole('button', { name: 'New device', exact: true }).click();
  await page.getByLabel('Source', { exact: true }).fill('Manual 7, “rev. B”');
  await page.getByLabel('Source', { exact: true }).press('Tab');
  await page.getByLabel('05 sets a coil with any first byte but 0.').check();
  await page.getByRole('textbox', { name: 'Serial line' }).fill('19200 7E1, unit 0x11');
  await page.getByLabel('Notes').fill('Its CRC is printed swapped; look out.\n\n  Counts from 1, says page 3.  ');
  await page.getByLabel('Notes').press('Tab');
  await page.getByText('Wrong or odd in its source: 2 points').click();
  await expect(page.getByText('Counts from 1, says page 3.').first()).toBeVisible();
  for (const kind of ['CSV', 'JSON']) {
    const [file] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: `Export as ${kind}` }).click(),
    ]);
    const text = readFileSync(await file.path(), 'utf8');
    await page.getByRole('button', { name: /^Delete My device/ }).click();
    await expect(page.getByLabel('Notes')).toHaveCount(0);
    if (kind === 'CSV') await page.getByText('Import a register map').click();
    await page.getByLabel('Or paste it here').fill(text);
    await page.getByRole('button', { name: 'Import what is pasted' }).click();
    await expect(page.getByLabel('Source', { exact: true })).toHaveValue('Manual 7, “rev. B”');
    await expect(page.getByLabel('05 sets a coil with any first byte but 0.')).toBeChecked();
    await expect(page.getByRole('textbox', { name: 'Serial line' })).toHaveValue('19200 7E1, unit 17');
    await expect(page.getByLabel('Notes')).toHaveValue(
      'Its CRC is printed swapped; look out.\nCounts from 1, says page 3.',
    );
  }
});
