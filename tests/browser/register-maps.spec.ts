import type { Page } from '@playwright/test';
import { languages } from '../../src/words/index.ts';
import { AxeBuilder } from './axe.ts';
import { expect, test } from './page.ts';

const words = await languages.en.library();
const maps = await languages.en.registerMaps();
const devices = await languages.en.devices();
const bus = await languages.en.bus();

/** A maker's table: a title, German headers, decimal commas, function codes, a row that is no register. */
const TABLE = `Wärmepumpe WP 12;;;;;
;;;;;
Adresse;Bezeichnung;Funktion;Datentyp;Einheit;Faktor
1100;Vorlauftemperatur;4;int16;°C;0,1
1102;Betriebsart;3;uint16;;
abc;Reserve;3;uint16;;
`;

const assistant = (page: Page) => page.getByRole('region', { name: /^Import of / });
const library = (page: Page) => page.getByRole('region', { name: words.profiles });

async function choose(page: Page, name: string, text: string): Promise<void> {
  await page.getByLabel(words.chooseFile).setInputFiles({ name, mimeType: 'text/csv', buffer: Buffer.from(text) });
  await expect(assistant(page)).toBeVisible();
}

test('a maker’s table is read, what it does not say is asked, and its registers name what is in frames', async ({
  page,
}) => {
  await page.goto('./#devices');
  await choose(page, 'WP 12.csv', TABLE);
  const { getByLabel } = { getByLabel: (label: string) => assistant(page).getByLabel(label) };
  await expect(assistant(page)).toContainText('2 registers read');
  await expect(getByLabel(words.column(1, 'Adresse'))).toHaveValue('address');
  await expect(getByLabel(words.column(2, 'Bezeichnung'))).toHaveValue('name');
  await expect(assistant(page)).toContainText('Row 6: The address cannot be read.');
  const counting = getByLabel(maps.question({ code: 'counting', options: [], assumed: '' }));
  await counting.selectOption({ label: 'From 1' });
  await expect(assistant(page).getByRole('row', { name: /Vorlauftemperatur input-register 1099/ })).toBeVisible();
  await counting.selectOption({ label: 'As they are sent, from 0' });
  expect(await new AxeBuilder(page).findings()).toEqual([]);
  await assistant(page).getByRole('button', { name: words.keep, exact: true }).click();
  await expect(page.getByText('“WP 12”: 2 registers imported.')).toBeVisible();
  await expect(library(page).getByRole('button', { name: /^WP 12/ })).toHaveAttribute('aria-pressed', 'true');

  // 490 in register 1100 of unit 1: 49.0 °C.
  await page.goto('./#rtu/reply?unitId=1&functionCode=4&registers=490&answering=0104044C0001F12D');
  await expect(page.getByRole('main')).toContainText('Vorlauftemperatur');
});

test('the same map again updates the one that is there, with its answers, or stands beside it', async ({ page }) => {
  await page.goto('./#devices');
  await choose(page, 'WP 12.csv', TABLE);
  const table = maps.question({ code: 'counting', options: [], assumed: '' });
  await assistant(page).getByLabel(table).selectOption({ label: 'From 1' });
  await assistant(page).getByRole('button', { name: words.keep, exact: true }).click();
  await choose(page, 'WP 12.csv', TABLE.replace('Betriebsart', 'Modus'));
  await expect(assistant(page).getByLabel(table)).toHaveValue('one');
  await assistant(page).getByLabel(words.ways.update).check();
  await assistant(page).getByRole('button', { name: words.keep, exact: true }).click();
  await expect(library(page).getByRole('button', { name: /^WP 12/ })).toHaveCount(1);
  await expect(page.getByRole('region', { name: words.map('WP 12') })).toContainText('Modus');
});

test('a search goes through all devices, and two maps are compared', async ({ page }) => {
  await page.goto('./#devices');
  await page.getByRole('searchbox', { name: words.search }).fill('683');
  await expect(library(page)).toContainText('P0683 speed reference');
  await library(page)
    .getByRole('button', { name: /^WEG drive/ })
    .click();
  await page.getByRole('combobox', { name: words.compare }).selectOption({ index: 1 });
  await expect(page.getByRole('region', { name: words.compare })).toContainText(/\d+ differences/);
  await page.reload();
  await expect(page.getByRole('searchbox', { name: words.search })).toHaveValue('683');
});

const registers = (page: Page) => page.getByRole('group', { name: 'Registers of this device' });
const names = (page: Page) => registers(page).locator('tbody th').allInnerTexts();

test('the map is in the order of any column, and narrowed to a model and a group', async ({ page }) => {
  await page.goto('./#devices');
  await choose(
    page,
    'Zones.csv',
    `name,table,address,type,unit,access,group,models
Zone 10,holding-register,3,u16,V,r,Heating,X1
Zone 9,holding-register,20,f32,A,rw,Heating,X2
Ready,coil,7,,,rw,Status,
`,
  );
  await assistant(page).getByRole('button', { name: words.keep, exact: true }).click();
  const table = registers(page).getByRole('grid');
  const press = (column: string) => table.getByRole('columnheader', { name: column }).getByRole('button').click();
  await press('Name');
  await expect(table.getByRole('columnheader', { name: 'Name' })).toHaveAttribute('aria-sort', 'ascending');
  await expect.poll(() => names(page)).toEqual(['Ready', 'Zone 9', 'Zone 10']);
  await press('Name');
  await expect.poll(() => names(page)).toEqual(['Zone 10', 'Zone 9', 'Ready']);
  for (const [column, order] of [
    ['Number', ['Zone 10', 'Ready', 'Zone 9']],
    ['Type', ['Ready', 'Zone 9', 'Zone 10']],
    ['Unit', ['Zone 9', 'Zone 10', 'Ready']],
    ['Access', ['Zone 10', 'Zone 9', 'Ready']],
  ] as const) {
    await press(column);
    await expect.poll(() => names(page), column).toEqual(order);
  }

  await registers(page).getByRole('combobox', { name: 'Model', exact: true }).selectOption('X1');
  await expect.poll(() => names(page)).toEqual(['Zone 10', 'Ready']);
  await registers(page).getByRole('combobox', { name: 'Group', exact: true }).selectOption('Status');
  await expect.poll(() => names(page)).toEqual(['Ready']);
  await expect(registers(page)).toContainText('1 register');
  expect(await new AxeBuilder(page).findings()).toEqual([]);

  // Another device names neither, and keeps the order.
  await library(page)
    .getByRole('button', { name: /^WEG drive/ })
    .click();
  await expect(table.getByRole('row')).toHaveCount(5);
  await expect(registers(page).getByRole('combobox', { name: 'Model', exact: true })).toHaveCount(0);
  await expect(registers(page).getByRole('combobox', { name: 'Group', exact: true })).toHaveCount(0);
});

test('the map is read over the connection that is open, and what the device does not have says why', async ({
  page,
}) => {
  await page.goto('./#devices');
  await library(page)
    .getByRole('button', { name: /^WEG drive/ })
    .click();
  await expect(registers(page)).toContainText(devices.connectFirst);
  await registers(page).getByRole('link', { name: words.toBus }).click();
  await expect(page.getByRole('heading', { name: bus.heading })).toBeVisible();
  await page.getByRole('navigation').getByRole('link', { name: 'Devices' }).click();
  await registers(page).getByRole('button', { name: words.toVirtual }).click();
  await expect(registers(page)).not.toContainText(devices.connectFirst);
  const row = (name: string) => registers(page).locator('tbody tr').filter({ hasText: name });
  const value = (name: string) => row(name).locator('[data-column="value"]');

  // A single register, then all of them: 684 is not there, so that the device refuses 681 to 685.
  await registers(page).getByRole('button', { name: 'Read P0685 direction' }).click();
  await expect(value('P0685')).toContainText('0 (forward)');
  await expect(value('P0681')).toHaveText('');
  await registers(page)
    .getByRole('button', { name: words.readAll(4) })
    .click();
  await expect(registers(page).getByRole('status')).toContainText('4 of 4 values read.');
  await expect(value('P0681')).toContainText('0.0 Hz');
  expect(await new AxeBuilder(page).findings()).toEqual([]);

  // Edited, a register is another one, and was not read yet; those that were stay as they were read.
  await row('P0685').locator('[data-column="address"]').dblclick();
  await page.getByRole('textbox', { name: 'Address of P0685 direction' }).fill('700');
  await page.keyboard.press('Enter');
  await expect(value('P0681')).toContainText('0.0 Hz');
  await expect(value('P0685')).toHaveText('');
  await registers(page)
    .getByRole('button', { name: words.readAll(4) })
    .click();
  await expect(registers(page).getByRole('status')).toContainText('3 of 4 values read. 1 was not; the rows say why.');
  await expect(value('P0685')).toContainText('Exception 02, ILLEGAL DATA ADDRESS');
  await expect(value('P0681')).toContainText('0.0 Hz');
});

test('of a map of thousands of registers the rows in sight are drawn, and a cell far down is edited', async ({
  page,
}) => {
  await page.goto('./#devices');
  const rows = Array.from({ length: 5000 }, (_, at) => `Register ${at},holding-register,${at},u16,V`);
  await choose(page, 'Long.csv', `name,table,address,type,unit\n${rows.join('\n')}\n`);
  await assistant(page).getByRole('button', { name: words.keep, exact: true }).click();
  const drawn = registers(page).locator('tbody tr');
  await expect(drawn.first()).toContainText('Register 0');
  expect(await drawn.count()).toBeLessThan(60);
  await drawn.first().locator('[data-column="unit"]').focus();
  await page.keyboard.press('Control+End');
  const last = drawn.filter({ hasText: 'Register 4999' }).locator('[data-column="unit"]');
  await expect(last).toBeFocused();
  await expect(last).toBeInViewport();
  await page.keyboard.press('Enter');
  await page.keyboard.type('kV');
  await page.keyboard.press('Enter');
  await expect(last).toHaveText('kV');
  // A text that is wrong stays, though its row is scrolled away and comes back.
  await drawn.filter({ hasText: 'Register 4990' }).locator('[data-column="name"]').dblclick();
  const name = page.getByRole('textbox', { name: 'Name of Register 4990' });
  await name.fill(' ');
  await page.keyboard.press('Enter');
  await expect(name).toHaveAccessibleDescription('Name is missing.');
  await drawn.filter({ hasText: 'Register 4991' }).locator('[data-column="unit"]').focus();
  await page.keyboard.press('Control+Home');
  await expect(drawn.filter({ hasText: /^Register 0/ }).locator('[data-column="unit"]')).toBeFocused();
  await page.keyboard.press('Control+End');
  await expect(name).toHaveValue(' ');
  await expect(name).toBeInViewport();
});

for (const width of [390, 320]) {
  test(`at ${width} px the requests of each register are in sight`, async ({ page }) => {
    await page.setViewportSize({ width, height: 844 });
    await page.goto('./#devices');
    await library(page)
      .getByRole('button', { name: /^WEG drive/ })
      .click();
    const buttons = registers(page).getByRole('button');
    await expect(registers(page).getByRole('button', { name: 'Read P0683 speed reference' })).toBeVisible();
    await expect(buttons).toHaveCount(12);
    for (const box of await Promise.all((await buttons.all()).map((each) => each.boundingBox()))) {
      expect(box?.x).toBeGreaterThanOrEqual(0);
      expect((box?.x ?? width) + (box?.width ?? 0)).toBeLessThanOrEqual(width);
    }
    const sideways = await registers(page).evaluate(
      (group) =>
        [group, ...group.querySelectorAll('div, table'), document.documentElement].filter(
          ({ scrollWidth, clientWidth }) => scrollWidth > clientWidth,
        ).length,
    );
    expect(sideways).toBe(0);
    const [read, write] = await Promise.all(
      ['Read', 'Write'].map((act) =>
        registers(page)
          .getByRole('button', { name: `${act} P0683` })
          .boundingBox(),
      ),
    );
    expect(read?.y).toBe(write?.y);
    await registers(page).getByLabel('In the order of').selectOption({ label: 'Unit' });
    await expect
      .poll(() => names(page))
      .toEqual(['P0681 actual speed', 'P0683 speed reference', 'P0682 control word', 'P0685 direction']);
    expect(await new AxeBuilder(page).findings()).toEqual([]);
  });
}
