import { languages } from '../../src/words/index.ts';
import { MAP, RegisterMaps } from '../browser/register-maps.ts';
import { expect, test } from './page.ts';

const words = await languages.en.library();
const questions = await languages.en.registerMaps();
const devices = await languages.en.devices();
const bus = await languages.en.bus();

test('a maker’s table is read, what it does not say is asked, and its registers name what is in frames', async ({
  page,
}) => {
  const maps = new RegisterMaps(page);
  await page.goto('./#devices');
  await maps.choose('WP 12.csv', MAP);
  const getByLabel = (label: string) => maps.assistant.getByLabel(label);
  await expect(maps.assistant).toContainText('2 registers read');
  await expect(getByLabel(words.column(1, 'Adresse'))).toHaveValue('address');
  await expect(getByLabel(words.column(2, 'Bezeichnung'))).toHaveValue('name');
  await expect(maps.assistant).toContainText('Row 6: The address cannot be read.');
  const counting = getByLabel(questions.question({ code: 'counting', options: [], assumed: '' }));
  await counting.selectOption({ label: 'From 1' });
  await expect(maps.assistant.getByRole('row', { name: /Vorlauftemperatur input-register 1099/ })).toBeVisible();
  await counting.selectOption({ label: 'As they are sent, from 0' });
  await maps.keep();
  await expect(page.getByText('“WP 12”: 2 registers imported.')).toBeVisible();
  await expect(maps.library.getByRole('button', { name: /^WP 12/ })).toHaveAttribute('aria-pressed', 'true');

  // 490 in register 1100 of unit 1: 49.0 °C.
  await page.goto('./#rtu/reply?unitId=1&functionCode=4&registers=490&answering=0104044C0001F12D');
  await expect(page.getByRole('main')).toContainText('Vorlauftemperatur');
});

test('the same map again updates the one that is there, with its answers, or stands beside it', async ({ page }) => {
  const maps = new RegisterMaps(page);
  await page.goto('./#devices');
  await maps.choose('WP 12.csv', MAP);
  const table = questions.question({ code: 'counting', options: [], assumed: '' });
  await maps.assistant.getByLabel(table).selectOption({ label: 'From 1' });
  await maps.keep();
  await maps.choose('WP 12.csv', MAP.replace('Betriebsart', 'Modus'));
  await expect(maps.assistant.getByLabel(table)).toHaveValue('one');
  await maps.assistant.getByLabel(words.ways.update).check();
  await maps.keep();
  await expect(maps.library.getByRole('button', { name: /^WP 12/ })).toHaveCount(1);
  await expect(page.getByRole('region', { name: words.map('WP 12') })).toContainText('Modus');
});

test('a search goes through all devices, and two maps are compared', async ({ page }) => {
  const maps = new RegisterMaps(page);
  await page.goto('./#devices');
  await page.getByRole('searchbox', { name: words.search }).fill('683');
  await expect(maps.library).toContainText('P0683 speed reference');
  await maps.openDevice(/^WEG drive/);
  await page.getByRole('combobox', { name: words.compare }).selectOption({ index: 1 });
  await expect(page.getByRole('region', { name: words.compare })).toContainText(/\d+ differences/);
  await page.reload();
  await expect(page.getByRole('searchbox', { name: words.search })).toHaveValue('683');
});

test('the map is in the order of any column, and narrowed to a model and a group', async ({ page }) => {
  const maps = new RegisterMaps(page);
  await page.goto('./#devices');
  await maps.choose(
    'Zones.csv',
    `name,table,address,type,unit,access,group,models
Zone 10,holding-register,3,u16,V,r,Heating,X1
Zone 9,holding-register,20,f32,A,rw,Heating,X2
Ready,coil,7,,,rw,Status,
`,
  );
  await maps.keep();
  const table = maps.registers.getByRole('grid');
  const press = (column: string | RegExp) =>
    table.getByRole('columnheader', { name: column }).getByRole('button').click();
  await press(/^Name/);
  await expect(table.getByRole('columnheader', { name: /^Name/ })).toHaveAttribute('aria-sort', 'ascending');
  await expect.poll(() => maps.names()).toEqual(['Ready', 'Zone 9', 'Zone 10']);
  await press(/^Name/);
  await expect.poll(() => maps.names()).toEqual(['Zone 10', 'Zone 9', 'Ready']);
  for (const [column, order] of [
    ['Number', ['Zone 10', 'Ready', 'Zone 9']],
    ['Type', ['Ready', 'Zone 9', 'Zone 10']],
    ['Unit', ['Zone 9', 'Zone 10', 'Ready']],
    ['Access', ['Zone 10', 'Zone 9', 'Ready']],
  ] as const) {
    await press(column);
    await expect.poll(() => maps.names(), column).toEqual(order);
  }

  await maps.registers.getByRole('combobox', { name: 'Model', exact: true }).selectOption('X1');
  await expect.poll(() => maps.names()).toEqual(['Zone 10', 'Ready']);
  await maps.registers.getByRole('combobox', { name: 'Group', exact: true }).selectOption('Status');
  await expect.poll(() => maps.names()).toEqual(['Ready']);
  await expect(maps.registers).toContainText('1 register');

  // Another device names neither, and keeps the order.
  await maps.openDevice(/^WEG drive/);
  await expect(table.getByRole('row')).toHaveCount(5);
  await expect(maps.registers.getByRole('combobox', { name: 'Model', exact: true })).toHaveCount(0);
  await expect(maps.registers.getByRole('combobox', { name: 'Group', exact: true })).toHaveCount(0);
});

test('the map is read over the connection that is open, and what the device does not have says why', async ({
  page,
}) => {
  const maps = new RegisterMaps(page);
  await page.goto('./#devices');
  await maps.openDevice(/^WEG drive/);
  await expect(maps.registers).toContainText(devices.connectFirst);
  await maps.registers.getByRole('link', { name: words.toBus }).click();
  await expect(page.getByRole('heading', { name: bus.heading })).toBeVisible();
  await page.getByRole('navigation').getByRole('link', { name: 'Devices' }).click();
  await maps.registers.getByRole('button', { name: words.toVirtual }).click();
  await expect(maps.registers).not.toContainText(devices.connectFirst);
  const row = (name: string) => maps.registers.locator('tbody tr').filter({ hasText: name });
  const value = (name: string) => row(name).locator('[data-column="value"]');

  // A single register, then all of them: 684 is not there, so that the device refuses 681 to 685.
  await maps.registers.getByRole('button', { name: 'Read P0685 direction' }).click();
  await expect(value('P0685')).toContainText('0 (forward)');
  await expect(value('P0681')).toHaveText('');
  await maps.registers.getByRole('button', { name: words.readAll(4) }).click();
  await expect(maps.registers.getByRole('status')).toContainText('4 of 4 values read.');
  await expect(value('P0681')).toContainText('0.0 Hz');

  // Edited, a register is another one, and was not read yet; those that were stay as they were read.
  await row('P0685').locator('[data-column="address"]').dblclick();
  await page.getByRole('textbox', { name: 'Address of P0685 direction' }).fill('700');
  await page.keyboard.press('Enter');
  await expect(value('P0681')).toContainText('0.0 Hz');
  await expect(value('P0685')).toHaveText('');
  await maps.registers.getByRole('button', { name: words.readAll(4) }).click();
  await expect(maps.registers.getByRole('status')).toContainText('3 of 4 values read. 1 was not; the rows say why.');
  await expect(value('P0685')).toContainText('Exception 02, ILLEGAL DATA ADDRESS');
  await expect(value('P0681')).toContainText('0.0 Hz');
});
