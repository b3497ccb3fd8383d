import { diagnosticSubFunctions, exceptionCodes, functionCodes, meiTypes } from '../../src/modbus/index.ts';
import { languages } from '../../src/words/index.ts';
import { FrameForm } from '../browser/form.ts';
import { Reference } from '../browser/reference-view.ts';
import { expect, test } from './page.ts';

const words = await languages.en.reference();
const aboutWords = await languages.en.about();

const hex = (value: number, digits = 2) => value.toString(16).toUpperCase().padStart(digits, '0');

test('the header leads to the reference and back to the current frame', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  await form.field('value').fill('0x0800');
  const link = (name: string) => page.getByRole('banner').getByRole('link', { name, exact: true });
  await expect(link('Frame')).toHaveAttribute('aria-current', 'page');
  await expect(link('Reference')).not.toHaveAttribute('aria-current');

  await link('Reference').click();
  const reference = new Reference(page);
  await expect(reference.table('functions')).toBeVisible();
  await expect(page).toHaveURL(/#reference$/);
  await expect(page).toHaveTitle(words.title);
  await expect(link('Reference')).toHaveAttribute('aria-current', 'page');
  await expect(link('Frame')).not.toHaveAttribute('aria-current');
  await expect(page.getByRole('heading', { name: 'Build' })).toHaveCount(0);

  await link('Frame').click();
  await expect(form.field('value')).toHaveValue('0x0800');
  await expect(page).toHaveTitle('06 06 02AB … · Framewright');
  await page.goBack();
  await expect(reference.table('functions')).toBeVisible();
  await page.goBack();
  await expect(form.field('value')).toHaveValue('0x0800');
  await page.goForward();
  await expect(reference.table('functions')).toBeVisible();
});

test('a reload and a link open the reference, and Frame then leads to the first frame', async ({ page }) => {
  const reference = new Reference(page);
  await reference.open('#reference?search=gateway');
  await expect(reference.search).toHaveValue('gateway');
  await page.reload();
  await expect(reference.search).toHaveValue('gateway');
  await expect(reference.heads('exceptions')).toHaveText([/^0A/, /^0B/]);
  await page.getByRole('banner').getByRole('link', { name: 'Frame', exact: true }).click();
  await expect(new FrameForm(page).field('value')).toHaveValue('4096');
});

test('every function, sub-function, MEI type and exception has its row', async ({ page }) => {
  const reference = new Reference(page);
  await reference.open();
  await expect(reference.heads('functions')).toHaveText(functionCodes.map(({ code }) => words.code(code)));
  const rows = await reference.table('functions').locator('tbody').getByRole('row').allTextContents();
  for (const { code, name, section } of functionCodes) {
    const row = rows.find((text) => text.startsWith(words.code(code)));
    expect(row, name).toContain(name);
    expect(row, name).toContain(section.replace('AP ', '§'));
  }
  await expect(reference.heads('exceptions')).toHaveText(exceptionCodes.map(({ code }) => `${hex(code)}${code}`));
  await expect(reference.table('exceptions').getByRole('link')).toHaveText(exceptionCodes.map(({ name }) => name));
  await expect(reference.heads('subFunctions')).toHaveText(
    diagnosticSubFunctions.map(({ code }) => `${hex(code, 4)}${code}`),
  );
  await expect(reference.heads('meiTypes')).toHaveText(meiTypes.map(({ meiType }) => `${hex(meiType)}${meiType}`));
  await expect(reference.heads('open')).toHaveCount(Object.keys(words.openPoints).length);
  await expect(reference.heads('misprints')).toHaveCount(Object.keys(words.misprints).length);
});

test('fields, limits and sizes are those of the specification', async ({ page }) => {
  const reference = new Reference(page);
  await reference.open();
  const writing = reference.row('functions', 'Write Multiple Registers').filter({ hasText: /^16 \(0x10\)/ });
  await expect(writing).toContainText('holding registers');
  await expect(writing.getByRole('cell').nth(2)).toHaveText('yes');
  await expect(writing).toContainText('Quantity 21–123');
  await expect(reference.row('functions', 'Get Comm Event Log')).toContainText(words.serialOnly);
  await expect(reference.row('subFunctions', 'Force Listen Only Mode')).toContainText(`Reply${words.neverAnswered}`);
  const limit = (name: string) => reference.row('limits', name).filter({ hasText: 'Quantity' }).first();
  await expect(limit('Read Coils')).toContainText('1–2000');
  await expect(limit('Write Multiple Coils')).toContainText('0001–07B0');
  await expect(reference.table('sizes').getByRole('row')).toContainText([
    'At most',
    'PDU253 bytes',
    'RTU256 bytes',
    'ASCII513 characters',
    'TCP260 bytes',
  ]);
  await expect(reference.row('units', /^0 ?00Serial line/)).toContainText('05, 06, 15 (0x0F), 16 (0x10)');
  await expect(reference.row('numbering', 'holding registers')).toContainText('40001–49999');
  await expect(reference.row('numbering', 'holding registers')).toContainText('400001–465536');
  await expect(reference.row('ranges', 'UMAS')).toContainText('5A90reserved');
  await expect(reference.row('ranges', /^80–FF/)).toContainText('128–255');
});

test('codes are found as people write them, and words by each of theirs', async ({ page }) => {
  const reference = new Reference(page);
  await reference.open();
  for (const [search, codes] of [
    ['16', ['16 (0x10)', '22 (0x16)']],
    ['WRITE coil', ['05', '15 (0x0F)']],
  ] as const) {
    await reference.search.fill(search);
    await expect(reference.heads('functions'), search).toHaveText([...codes]);
    const shown = await page.getByRole('rowheader').count();
    await expect(reference.shown).toHaveText(new RegExp(`^${shown} of \\d+ rows$`));
    await expect(page).toHaveURL(`./#reference?${new URLSearchParams({ search })}`);
  }
});

test('a search that finds nothing says so, and one click shows everything', async ({ page }) => {
  const reference = new Reference(page);
  await reference.open();
  await expect(reference.shown).toHaveText(/\d+ rows/);
  const all = await reference.shown.textContent();
  await reference.search.fill('profibus');
  await expect(page.getByText(words.nothing('profibus'))).toBeVisible();
  await expect(page.getByRole('table')).toHaveCount(0);
  await expect(reference.shown).toHaveText(/^0 of/);
  await page.getByRole('button', { name: words.clear }).click();
  await expect(reference.shown).toHaveText(all!);
  await expect(reference.search).toBeFocused();
  await expect(reference.table('functions')).toBeVisible();
  await expect(page).toHaveURL(/#reference$/);
});

test('a search for signs that mean something elsewhere takes them as they are', async ({ page }) => {
  const reference = new Reference(page);
  await reference.open();
  for (const search of ['(', '[a', '*', '\\', '%', '&=#?']) {
    await reference.search.fill(search);
    await expect(reference.shown).toHaveText(/ of /);
  }
  await reference.search.blur();
  await page.reload();
  await expect(reference.search).toHaveValue('&=#?');
});

test('a row of each table opens its frame, and Back finds the search again', async ({ page }) => {
  const reference = new Reference(page);
  const { search } = reference;
  for (const [subject, row, link, hash, text] of [
    ['functions', 'Read Holding Registers', 'Read Holding Registers', '#rtu/request?functionCode=3', 'Valid request'],
    ['functions', 'Read Coils', 'Reply of 01 Read Coils', '#rtu/reply?functionCode=1', 'Valid reply'],
    [
      'exceptions',
      'ILLEGAL DATA ADDRESS',
      /ILLEGAL/,
      '#rtu/exception?functionCode=3&exceptionCode=2',
      'Valid exception',
    ],
    ['units', /^0 ?00Serial/, /^Serial/, '#rtu/request?unitId=0&functionCode=5', 'Valid request'],
    ['numbering', 'holding', /holding/, '#rtu/request?functionCode=3&startAddress=107', '40108'],
    ['ranges', 'UMAS', /^reserved/, '#rtu/request?functionCode=90', 'Doubtful request'],
    ['open', 'Mask Write', /Mask/, '#rtu/request?functionCode=22&andMask=0x00F2&orMask=0x0025', 'Valid request'],
  ] as const) {
    await reference.open();
    await search.fill(typeof row === 'string' ? row : '');
    await reference.row(subject, row).first().getByRole('link', { name: link }).first().click();
    await expect(page).toHaveURL(`./${hash}`);
    await expect(page.getByRole('heading', { name: 'Build' })).toBeVisible();
    await expect(page.getByRole('main')).toContainText(text);
    await page.goBack();
    await expect(search).toHaveValue(typeof row === 'string' ? row : '');
    await expect(reference.row(subject, row).first()).toBeVisible();
  }
});

test('the list of tables leads to each with the keyboard, and leaves the address alone', async ({ page }) => {
  const reference = new Reference(page);
  await reference.open();
  const tables = page.getByRole('navigation', { name: words.tables });
  await tables.getByRole('button', { name: words.subjects.units }).focus();
  await page.keyboard.press('Enter');
  const heading = page.getByRole('heading', { name: words.subjects.units });
  await expect(heading).toBeFocused();
  await page.keyboard.press('Tab');
  await expect(reference.row('units', /^0 ?00Serial/).getByRole('link')).toBeFocused();
  await expect(page).toHaveURL(/#reference$/);
  await reference.search.fill('gateway');
  await expect(tables.getByRole('button', { name: words.subjects.meiTypes })).toBeDisabled();
});

test('says what it is, and under which licences the packages in it stand', async ({ page }) => {
  const reference = new Reference(page);
  await reference.open();
  const about = page.getByRole('region', { name: aboutWords.title });
  await page.getByRole('button', { name: aboutWords.title }).click();
  await expect(about.getByRole('heading')).toBeFocused();
  await expect(about.getByRole('group').first()).toBeVisible();
  const folds = await about.getByRole('group').all();
  const said = await Promise.all(folds.map((fold) => fold.textContent()));
  for (const name of ['framewright', 'preact', '@preact/signals-core', 'fflate', 'uplot', 'highlight.js'])
    expect(said.some((text) => text?.startsWith(`${name} `))).toBe(true);
  for (const fold of folds) {
    await fold.locator('summary').click();
    await expect(fold).toContainText(/Copyright/i);
  }
});
