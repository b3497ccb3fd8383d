import type { Page } from '@playwright/test';
import { languages } from '../../src/words/index.ts';
import { AxeBuilder } from './axe.ts';
import { expect, test } from './page.ts';

const words = await languages.en.library();
const maps = await languages.en.registerMaps();

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
