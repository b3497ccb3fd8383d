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

test('axe finds nothing in any control, light and dark, also when they are used', async ({ page }) => {
  await open(page);
  const axe = new AxeBuilder(page);
  expect(await axe.findings()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await axe.findingsOfColours()).toEqual([]);
  await use(page);
  await expect(page.getByText('not a whole number').first()).toBeVisible();
  expect(await axe.findingsOfColours()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'light' });
  expect(await axe.findings()).toEqual([]);
  await page.getByRole('button', { name: 'Ask' }).click();
  await expect(page.getByRole('dialog', { name: 'Is it to be sent?' })).toBeVisible();
  expect(await axe.findings()).toEqual([]);
});

test('the keys reach the last of a million lines, and the wheel passes none over; every control stands inside the window, and printed on the sheet; a table that has no room names the column of each cell', async ({
  page,
}) => {
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

  await use(page);
  // The second is 1280 px at 200 %.
  for (const width of [320, 640]) {
    await page.setViewportSize({ width, height: 640 });
    await expect.poll(() => tooWide(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  }

  // A4 at 96 dots an inch.
  await page.setViewportSize({ width: 794, height: 1123 });
  await page.emulateMedia({ media: 'print' });
  await expect.poll(() => tooWide(page)).toEqual([]);
  expect(await new AxeBuilder(page).findings()).toEqual([]);
});
