import type { Page } from '@playwright/test';
import { languages } from '#known';
import { AxeBuilder } from './axe.ts';
import { FrameForm } from './form.ts';
import { expect, test } from './page.ts';
import { reply, ValuesTab } from './values-tab.ts';

const words = await languages.en.values();
const { writeValues } = (await languages.en.page()).page;

/** The numbers of the tables that stand in more than one line; bits have two, and no number none. */
const brokenNumbers = (page: Page) =>
  page.locator('table[data-width] td').evaluateAll((cells) =>
    cells
      .filter((cell) => cell.children.length === 0)
      .filter((cell) => {
        const range = document.createRange();
        range.selectNodeContents(cell);
        return new Set(Array.from(range.getClientRects(), ({ top }) => Math.round(top))).size !== 1;
      })
      .map((cell) => cell.textContent),
  );

test('no number is broken, nothing is wider than the page, and axe finds nothing, wide and in the dark at 320 px', async ({
  page,
}) => {
  const values = new ValuesTab(page);
  await page.setViewportSize({ width: 1240, height: 900 });
  await page.goto(`./${reply}`);
  await values.panel.scrollIntoViewIfNeeded();
  await expect(values.table(4)).toBeVisible();
  expect(await brokenNumbers(page)).toEqual([]);
  await values.openScale();
  await page.getByLabel(words.scaleLabels.factor, { exact: true }).fill('60/8192');
  await values.table(1).getByRole('row', { name: /^AB/ }).hover();
  await expect(new FrameForm(page).strip.locator('.byte[data-lit]')).toHaveCount(2);
  const axe = new AxeBuilder(page);
  expect(await axe.findings(), 'while bytes are lit').toEqual([]);

  await page.emulateMedia({ colorScheme: 'dark' });
  await page.setViewportSize({ width: 320, height: 700 });
  await page.getByRole('button', { name: writeValues }).click();
  await values.typed.fill('flaot 1\nf32 16777217');
  await expect(page.getByText(words.fault({ code: 'name-unknown', name: 'flaot' }))).toBeVisible();
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320);
  expect(await brokenNumbers(page)).toEqual([]);
  await page.keyboard.press('Escape');
  await new FrameForm(page).field('registers').hover();
  expect(await axe.findings()).toEqual([]);

  await page.goto('./#rtu/request?functionCode=22&referenceAddress=4&andMask=0x00F2&orMask=0x0025&v=3&tab=values');
  await page.getByLabel(words.current, { exact: true }).fill('0x0010');
  await expect(page.getByRole('table', { name: words.truth })).toBeVisible();
  expect(await axe.findings('[role=tabpanel]:not([hidden])')).toEqual([]);
});
