import { resolve } from 'node:path';
import type { Page } from '@playwright/test';
import { build } from 'vite';
import { AxeBuilder } from './axe.ts';
import { expect, test } from './page.ts';

const root = resolve(import.meta.dirname, '../..');

// In one worker: each builds them.
test.describe.configure({ mode: 'default' });

/** The files of the page of controls, by their names. The built page has none of them, so that they are built here, in memory. */
let files: ReadonlyMap<string, string | Uint8Array>;

test.beforeAll(async () => {
  const built = await build({
    root,
    logLevel: 'error',
    build: { write: false, outDir: '.cache/kit', rolldownOptions: { input: resolve(root, 'kit.html') } },
  });
  if (!('output' in built)) throw new Error('The page of controls is built more than once.');
  files = new Map(built.output.map((file) => [file.fileName, file.type === 'chunk' ? file.code : file.source]));
});

const types = { html: 'text/html', js: 'text/javascript', css: 'text/css' } as const;

/** Opens the page of controls. */
async function open(page: Page) {
  await page.route('**/kit/**', (route) => {
    const name = new URL(route.request().url()).pathname.replace('/kit/', '');
    if (name === 'favicon.svg')
      return route.fulfill({ contentType: 'image/svg+xml', body: '<svg xmlns="http://www.w3.org/2000/svg"/>' });
    const file = files.get(name);
    if (file === undefined) return route.fulfill({ status: 404, body: '' });
    const contentType = types[name.split('.').at(-1) as keyof typeof types];
    return route.fulfill({ contentType, body: typeof file === 'string' ? file : Buffer.from(file) });
  });
  await page.goto('./kit/kit.html');
  await expect(page.getByRole('heading', { name: 'Every control of the kit' })).toBeVisible();
}

/** Elements that stand out of the page, or out of their panel, at the width that it has now. */
const tooWide = (page: Page) =>
  page.evaluate(() => {
    const most = document.documentElement.clientWidth;
    return [...document.querySelectorAll('main *')]
      .filter(
        (element) =>
          !element.closest('.virtual-list *, .table.scroll *, .unseen') &&
          element.getBoundingClientRect().right > most + 0.5,
      )
      .map((element) => element.outerHTML.slice(0, 120));
  });

/** Brings the controls into the states that only using them makes. */
async function use(page: Page) {
  await page.getByLabel('Empty').fill('many');
  await page.getByLabel('Number', { exact: true }).fill('fast');
  await page.getByText('Folded', { exact: true }).click();
  await page.getByText('A fold inside').click();
  await page.getByText('Kept', { exact: true }).click();
  await page.getByRole('button', { name: 'Copy', exact: true }).click();
  await page.getByRole('button', { name: 'Copy the table' }).click();
  await page.getByLabel('Number taken when it is finished').fill('fast');
  await page.getByRole('tab', { name: 'Values' }).click();
}

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing in any control, ${colorScheme}, also when they are used`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await open(page);
    const axe = new AxeBuilder(page);
    expect(await axe.findings()).toEqual([]);
    await use(page);
    await expect(page.getByText('not a whole number').first()).toBeVisible();
    expect(await axe.findings()).toEqual([]);
  });
}

for (const [what, width] of [
  ['320 px', 320],
  ['1280 px at 200 %', 640],
] as const) {
  test(`every control stands inside a window of ${what}`, async ({ page }) => {
    await page.setViewportSize({ width, height: 640 });
    await open(page);
    await use(page);
    await expect.poll(() => tooWide(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  });
}

test('printed, every control stands on the sheet and can be read', async ({ page }) => {
  // A4 at 96 dots an inch.
  await page.setViewportSize({ width: 794, height: 1123 });
  await page.emulateMedia({ media: 'print' });
  await open(page);
  await use(page);
  await expect.poll(() => tooWide(page)).toEqual([]);
  expect(await new AxeBuilder(page).findings()).toEqual([]);
});

test('a wrong text is said to be wrong, and its hint comes back', async ({ page }) => {
  await open(page);
  const field = page.getByLabel('Empty');
  await expect(field).toHaveAccessibleDescription('a number');
  await field.fill('many');
  await expect(field).toHaveAttribute('aria-invalid', 'true');
  await expect(field).toHaveAccessibleDescription('“many” is not a number');
  await field.fill('7');
  await expect(field).toHaveAttribute('aria-invalid', 'false');
  await expect(field).toHaveAccessibleDescription('a number');
});

test('a number is taken while it is typed, and the last one holds', async ({ page }) => {
  await open(page);
  const number = page.getByLabel('Number', { exact: true });
  await number.fill('1200');
  await expect(number).toHaveAccessibleDescription('1200 bits a second');
  await number.fill('fast');
  await expect(number).toHaveAccessibleDescription('not a whole number');
  await number.fill('19200');
  await expect(number).toHaveAccessibleDescription('19200 bits a second');
});

test('a value is chosen by name, and one of a few by keys', async ({ page }) => {
  await open(page);
  await page.getByLabel('Parity').selectOption('odd');
  await expect(page.getByLabel('Parity')).toHaveValue('odd');
  await page.getByRole('radio', { name: 'RTU' }).focus();
  await page.keyboard.press('ArrowRight');
  await expect(page.getByRole('radio', { name: 'ASCII' })).toBeChecked();
});

test('what a fold holds is made when it is opened, and stays only if it is kept', async ({ page }) => {
  await open(page);
  const inside = page.getByText('What is in it is made when it is opened.');
  await expect(inside).toHaveCount(0);
  await page.getByText('Folded', { exact: true }).click();
  await expect(inside).toBeVisible();
  await page.getByText('Folded', { exact: true }).click();
  await expect(inside).toHaveCount(0);
  await expect(page.locator('#there')).toHaveCount(1);

  const summary = page.locator('summary', { hasText: 'Kept' });
  await expect(page.locator('#kept')).toHaveCount(0);
  await summary.click();
  await page.locator('#kept').fill('typed');
  await summary.click();
  await expect(page.locator('#kept')).toBeHidden();
  await summary.click();
  await expect(page.locator('#kept')).toHaveValue('typed');
});

test('copying says what became of it', async ({ page, context }) => {
  await open(page);
  await page.evaluate(() => {
    navigator.clipboard.writeText = () => Promise.reject(new DOMException('refused'));
  });
  await page.getByRole('button', { name: 'Copy', exact: true }).click();
  await expect(page.getByText('Not copied: 01 03')).toBeVisible();
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.reload();
  await page.getByRole('button', { name: 'Copy', exact: true }).click();
  await expect(page.getByRole('button', { name: 'Copied.' })).toBeVisible();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe('01 03');
});

test('a file is saved, and the same one may be opened twice', async ({ page }) => {
  await open(page);
  const saved = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Download' }).click();
  expect((await saved).suggestedFilename()).toBe('frame.txt');
  const chooser = page.getByLabel('Open a file…');
  const file = { name: 'one.txt', mimeType: 'text/plain', buffer: Buffer.from('01 03') };
  await chooser.setInputFiles(file);
  await expect(page.getByText('one.txt')).toBeVisible();
  await expect(chooser).toHaveValue('');
  await expect(page.getByLabel('Open nothing…')).toBeDisabled();
});

test('of a long list only the lines in sight are drawn, wherever they are', async ({ page }) => {
  await open(page);
  const list = page.getByRole('listbox', { name: 'Ten thousand lines' });
  expect(await list.getByRole('option').count()).toBeLessThan(40);
  await list.focus();
  await page.keyboard.press('End');
  await expect(list.getByRole('option', { selected: true })).toHaveText('Line 10000');
  expect(await list.getByRole('option').count()).toBeLessThan(40);
  await page.keyboard.press('Home');
  await expect(list.getByRole('option', { selected: true })).toHaveText('Line 1');
});

test('the keys reach the last of a million lines', async ({ page }) => {
  await open(page);
  const list = page.getByRole('listbox', { name: 'A million lines' });
  const chosen = list.getByRole('option', { selected: true });
  await list.focus();
  for (const [key, line] of [
    ['End', '1000000'],
    ['ArrowUp', '999999'],
    ['PageUp', '999988'],
    ['Home', '1'],
    ['ArrowDown', '2'],
  ] as const) {
    await page.keyboard.press(key);
    await expect(chosen).toHaveText(`Line ${line}`);
    // Of a line that stands at half a pixel, a browser sees half a pixel less.
    await expect(chosen).toBeInViewport({ ratio: 0.98 });
  }
});

test('the wheel passes no line of a million over', async ({ page }) => {
  await open(page);
  const list = page.getByRole('listbox', { name: 'A million lines' });
  await list.evaluate((element) => {
    element.scrollTop = 3_000_000;
  });
  const inSight = async () => {
    const box = await list.boundingBox();
    const lines = await list
      .getByRole('option')
      .evaluateAll((options) =>
        options.map((option) => [Number(option.textContent?.slice(5)), option.getBoundingClientRect().top] as const),
      );
    return lines.filter(([, top]) => top >= box!.y - 32 && top < box!.y + box!.height).map(([line]) => line);
  };
  await expect.poll(async () => (await inSight())[0]).toBeGreaterThan(100_000);
  const before = await inSight();
  await list.hover();
  await page.mouse.wheel(0, 100);
  await expect.poll(async () => (await inSight())[0]).not.toBe(before[0]);
  expect(before).toContain((await inSight())[0]);
});

test('a number may wait until it is finished, and Escape gives it up', async ({ page }) => {
  await open(page);
  const number = page.getByLabel('Number taken when it is finished');
  const taken = (value: number) => expect(page.getByText(`The number is ${value}.`)).toBeVisible();
  await number.fill('1');
  await taken(247);
  await number.press('Enter');
  await taken(1);
  await number.fill('many');
  await expect(number).toHaveAccessibleDescription('');
  await number.blur();
  await expect(number).toHaveAccessibleDescription('not a whole number');
  await number.press('Escape');
  await expect(number).toHaveValue('1');
  await expect(number).toHaveAccessibleDescription('');
  await number.fill('12');
  await number.blur();
  await taken(12);
});

test('a table that has no room names the column of each cell, and one with many columns scrolls inside itself', async ({
  page,
}) => {
  await open(page);
  const table = page.getByRole('table', { name: 'Rows that become cards' });
  const names = () =>
    table.locator('td').evaluateAll((cells) => cells.map((cell) => getComputedStyle(cell, '::before').content));
  expect(new Set(await names())).toEqual(new Set(['none']));
  await page.setViewportSize({ width: 320, height: 640 });
  expect((await names())[0]).toBe('"A bit"');
  const scroller = page.getByRole('group', { name: 'Many columns' });
  await scroller.focus();
  await page.keyboard.press('ArrowRight');
  await expect.poll(() => scroller.evaluate(({ scrollLeft }) => scrollLeft)).toBeGreaterThan(0);
});

test('a table is copied in the format that was chosen', async ({ page }) => {
  await open(page);
  await page.getByLabel(/^as /).selectOption('CSV');
  await page.getByRole('button', { name: 'Copy the table' }).click();
  await expect(page.getByText('The table is copied.')).toBeVisible();
  expect((await page.evaluate(() => navigator.clipboard.readText())).split('\n')[1]).toBe('19200,52.083333333333336');
});

test('a dialog ends with Escape, and the focus goes back', async ({ page }) => {
  await open(page);
  const button = page.getByRole('button', { name: 'Ask' });
  const dialog = page.getByRole('dialog', { name: 'Is it to be sent?' });
  await button.focus();
  await page.keyboard.press('Enter');
  await expect(dialog).toBeVisible();
  expect(await new AxeBuilder(page).findings()).toEqual([]);
  await page.keyboard.press('Escape');
  await expect(dialog).toHaveCount(0);
  await expect(button).toBeFocused();
  await button.click();
  await dialog.getByRole('button', { name: 'Yes' }).click();
  await expect(button).toBeFocused();
});

test('arrow keys open tabs, and a panel is drawn when it is first opened and then kept', async ({ page }) => {
  await open(page);
  const tab = (name: string) => page.getByRole('tab', { name });
  const shown = page.getByRole('tabpanel');
  await expect(page.locator('#tab-Waveform')).toHaveCount(0);
  await page.locator('#tab-Bytes').fill('01 03');
  await tab('Bytes').focus();
  await page.keyboard.press('ArrowRight');
  await expect(tab('Waveform')).toBeFocused();
  await expect(shown.getByLabel('Inside of Waveform')).toBeVisible();
  await expect(shown).toHaveCount(1);
  await page.keyboard.press('End');
  await expect(tab('Examples')).toHaveAttribute('aria-selected', 'true');
  await page.keyboard.press('ArrowRight');
  await expect(shown.getByLabel('Inside of Bytes')).toHaveValue('01 03');
});
