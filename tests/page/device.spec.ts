import type { Page } from '@playwright/test';
import { Device } from '../browser/device-panel.ts';
import { expect, test } from './page.ts';

const KEY = 'framewright.devices';

const stored = (page: Page) => page.evaluate((key) => localStorage.getItem(key), KEY);

test('with a device chosen its registers are found, taken into the form, and named in frames', async ({ page }) => {
  const device = new Device(page);
  await device.open();
  await device.choose('WEG drive');
  await expect(device.explanation).toContainText('P0683 speed reference = 4096 (30.0 Hz).');
  await expect(device.explanation).toContainText('P0683 speed reference. Address 683 (0x02AB) = register 40684.');
  await expect(device.rows).toHaveCount(4);

  // By the keyboard: search, then to the button of the row that is left.
  await page.getByLabel('Find a register').fill('0x2A9');
  await expect(device.rows).toHaveCount(1);
  await page.getByRole('button', { name: 'Read P0681 actual speed' }).press('Enter');
  await device.form.expectBytes('06 03 02 A9 00 01 54 25');
  await expect(page.getByRole('button', { name: /^Write P0681/ })).toHaveCount(0);
  await page.getByLabel('Find a register').fill('jog');
  await device.press('Write P0682 control word');
  await device.form.field('value').fill('3');
  await expect(device.explanation).toContainText('P0682 control word = 3 (run, general enable).');

  // A reply names what its request asked for, also after a reload.
  await page.goto('./#rtu/reply?unitId=6&functionCode=3&registers=4096&answering=060302A900015425');
  await page.reload();
  await expect(device.explanation).toContainText('P0681 actual speed = 4096 (30.0 Hz). Register 40682 (address 681)');
  await page.getByRole('heading', { name: 'Device', exact: true }).click();
  await device.choose('None');
  await expect(device.explanation).not.toContainText('P0681');
});

test('the other built-in devices: numbering both ways, byte count, values counted one each', async ({ page }) => {
  const device = new Device(page);
  await device.open('#rtu/request?unitId=1&functionCode=15&startAddress=0&bits=11111111');
  await device.choose('I-8xx7 controller');
  await expect(device.explanation).toContainText('This device wants 2, which is 1 + 8/8');
  await device.press('Give the frame this device’s byte count, 2');
  await device.form.expectBytes('01 0F 00 00 00 08 02 FF 00 A5 70');
  await expect(page.getByRole('button', { name: /byte count, 2/ })).toHaveCount(0);

  await device.choose('S7-200 with holding registers from VB800');
  await page.getByLabel('Find a register').fill('VW804');
  await device.press('Read VW804');
  await expect(device.form.field('startAddress')).toHaveValue('2');
  await expect(device.explanation).toContainText('VW804. Address 2 (0x0002) = register 40003.');

  await device.choose('Enron, Daniel (flow computers)');
  await page.goto('./#pdu/reply?functionCode=3&registers=0x447A 0x2000 0x489F 0x9060&answering=031B590002');
  await expect(device.explanation).toContainText('Float 7001 = 1000.5.');
  await expect(device.explanation).toContainText(
    'Float 7002 = 326787. Register 47003 (address 7002), sent as 2 registers.',
  );

  // Odd things are said with the device.
  await page.getByText('Wrong or odd in its source: 6 points').click();
  await expect(device.panel).toContainText('The register after 7001 is 7002, not 7003.');
});

test('an import keeps what can be read, and every change is undone', async ({ page }) => {
  const device = new Device(page);
  await device.open();
  await device.paste('name;table;address;type;factor;unit\nFlow;input;7;f32;0,5;m³\nOdd;holding;many\nFlow;input;7\n');
  const assistant = page.getByRole('region', { name: 'Import of Pasted map' });
  await expect(assistant).toContainText('Row 3: The address cannot be read.');
  await assistant.getByRole('button', { name: 'Import', exact: true }).click();
  await expect(device.said).toContainText('“Pasted map”: 2 registers imported.');
  await expect(assistant).toHaveCount(0);
  const csv = await device.download('Export as CSV');
  expect(csv.name).toBe('Pasted-map.csv');
  expect(csv.text).toContain('Flow,input-register,7,f32,ABCD,1,0.5,0,m³,,r,,');

  // A name that is taken by another content is not overwritten.
  await page.getByLabel('Or paste it here').fill('name,table,address\nLevel,hr,1\n');
  await device.press('Import what is pasted');
  await assistant.getByLabel('Add it beside the other').check();
  await assistant.getByRole('button', { name: 'Import', exact: true }).click();
  await expect(device.said).toContainText('“Pasted map” is taken, and stays: this one is kept as “Pasted map (2)”.');
  await device.press('Delete Pasted map (2)');
  await expect(page.getByLabel('Device profile')).toHaveValue('');
  await device.press('Undo: bring Pasted map (2) back');
  await expect(device.rows).toContainText('Level');

  // What holds for a whole device is changed too, and taken back.
  await page.getByRole('textbox', { name: 'Serial line' }).fill('9600 9N1');
  await page.getByRole('textbox', { name: 'Serial line' }).press('Tab');
  await expect(device.panel).toContainText('Write speed, data bits, parity');
  await page.getByRole('textbox', { name: 'Serial line' }).fill('19200 8E1, unit 7');
  await page.getByRole('textbox', { name: 'Serial line' }).press('Tab');
  await device.press('Read Level');
  await expect(device.form.field('unitId')).toHaveValue('7');
  await page.getByLabel('Its manual prints').selectOption('five-digit');
  await expect(device.rows).toContainText('40002');
  await device.press('Undo the last change');
  await expect(device.rows).not.toContainText('40002');
});

test('a cell is edited where it stands, keeps what is wrong with the reason, and is in a copy of a built-in device', async ({
  page,
}) => {
  const device = new Device(page);
  await device.open();
  await device.choose('WEG drive');
  // By keys alone: from the name of the first row down to the third, to its address, and into it.
  await device.cell('P0681', 'name').focus();
  for (const key of ['ArrowDown', 'ArrowDown', 'ArrowRight', 'ArrowRight', 'ArrowRight'])
    await page.keyboard.press(key);
  await expect(device.cell('P0683', 'address')).toBeFocused();
  await page.keyboard.press('F2');
  const address = page.getByRole('textbox', { name: 'Address of P0683 speed reference' });
  await expect(address).toBeFocused();
  await expect(address).toHaveValue('683');
  await page.keyboard.type('70000');
  await page.keyboard.press('Enter');
  await expect(address).toHaveValue('70000');
  await expect(address).toHaveAccessibleDescription(/^Address 70000 is not a whole number from 0 to 65535\./);
  await expect(address).toHaveAttribute('aria-invalid', 'true');
  await page.keyboard.press('Escape');
  await expect(device.cell('P0683', 'address')).toContainText('683');
  await expect(device.cell('P0683', 'address')).toBeFocused();
  await page.keyboard.press('Enter');
  await address.fill('0x2B0');
  await page.keyboard.press('Enter');
  await expect(device.said).toContainText('“WEG drive” is built in and stays as it is.');
  await expect(device.cell('P0683', 'address')).toContainText('688');
  await expect(device.cell('P0685', 'address')).toBeFocused();

  // By the mouse; Tab keeps the text and goes on. Each edit is taken back by itself.
  await device.cell('P0685', 'name').dblclick();
  await page.getByRole('textbox', { name: 'Name of P0685 direction' }).fill('Sense');
  await page.keyboard.press('Tab');
  await expect(device.cell('Sense', 'address')).toBeFocused();
  await device.press('Undo the last change');
  await expect(device.rows).toContainText(['P0681', 'P0682', 'P0683', 'P0685']);
  await expect(device.cell('P0683', 'address')).toContainText('688');

  // What has no column stands below the row, and is edited in the same way.
  await device.press('Edit P0685 direction');
  const more = page.getByRole('group', { name: 'More of P0685 direction' });
  await more.getByRole('button', { name: /^Count of P0685 direction/ }).click();
  await page.getByRole('textbox', { name: 'Count of P0685 direction' }).fill('many');
  await page.keyboard.press('Tab');
  await expect(more).toContainText('Count “many” is not a number.');
  await page.keyboard.press('Escape');
  await expect(more.getByRole('button', { name: /^Count of P0685 direction/ })).toBeFocused();
  await more.getByRole('button', { name: 'Remove P0685 direction' }).click();
  await expect(device.rows).toHaveCount(3);

  await device.press('Add a register');
  await expect(page.getByRole('textbox', { name: 'Name of New register' })).toBeFocused();
  await page.keyboard.type('Level');
  await page.keyboard.press('Enter');
  await expect(device.cell('Level', 'address')).toContainText('689');
  await device.press('Edit Level');
  await device.press('Remove Level');
  await expect(device.rows).toHaveCount(3);
  await page.reload();
  await page.getByRole('heading', { name: 'Device', exact: true }).click();
  await expect(device.rows).toHaveCount(3);
  const json = await device.download('Export as JSON');
  expect(JSON.parse(json.text)).toMatchObject({ format: 'framewright-devices', profiles: [{ name: 'WEG drive (2)' }] });
});

test('storage that refuses, is full or is unreadable says so, and what is changed lasts until the page is closed', async ({
  page,
}) => {
  const device = new Device(page);
  await page.addInitScript((key) => localStorage.setItem(key, 'not ours'), KEY);
  await device.open();
  await expect(device.panel).toContainText('It is not JSON');
  await device.press('New device');
  expect(await stored(page)).toBe('not ours');
  await device.press('Set it aside');
  await expect(device.said).toContainText('framewright.devices.unreadable-1');
  await page.evaluate(() => {
    IDBObjectStore.prototype.put = () => {
      throw new DOMException('', 'QuotaExceededError');
    };
  });
  await device.press('New device');
  await expect(device.panel).toContainText('is full');
  await expect(page.getByLabel('Device profile')).toHaveValue('own (2)');

  await page.addInitScript(() => {
    Object.defineProperty(globalThis, 'indexedDB', {
      get() {
        throw new DOMException('', 'SecurityError');
      },
    });
  });
  await page.reload();
  await page.getByRole('heading', { name: 'Device', exact: true }).click();
  await expect(device.panel).toContainText('allows this page no storage');
  await device.press('New device');
  await expect(page.getByLabel('Device profile')).toHaveValue('own');
});
