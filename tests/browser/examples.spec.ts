import type { Page } from '@playwright/test';
import { exampleSources } from '../../src/workbench/index.ts';
import { AxeBuilder } from './axe.ts';
import { FrameForm } from './form.ts';
import { expect, test } from './page.ts';

/** One of each source and transport: the name on its button, and its bytes. */
const EXAMPLES = [
  ['A guide for a WEG drive', 'Set 30 Hz', '06 06 02 AB 10 00 F5 E5'],
  ['An article on an S7-200', 'Write 2 registers from 5', '01 10 00 05 00 02 04 00 01 00 02 E3 91'],
  ['The I-8xx7 manual', 'TCP reply: 8 bits', '03 29 00 00 00 04 07 01 01 49'],
  ['A Chinese introduction', 'Reply: 401000–401003', '21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18'],
] as const;

async function openExamples(page: Page): Promise<void> {
  await page.getByRole('heading', { name: 'Examples', exact: true }).click();
}

const example = (page: Page, source: string, name: string) =>
  page.getByRole('region', { name: source }).getByRole('button', { name, exact: true });

const note = (page: Page) =>
  page.getByRole('region', { name: 'The frame' }).getByRole('status').filter({ hasText: 'prints' });

test('an example gives its bytes at one click, and shows them beside it', async ({ page }) => {
  test.setTimeout(60_000);
  await page.goto('./');
  await openExamples(page);
  const form = new FrameForm(page);
  for (const [source, name, bytes] of EXAMPLES) {
    await test.step(name, async () => {
      const button = example(page, source, name);
      await expect(button).toHaveAccessibleDescription(new RegExp(`^${bytes} `));
      await button.click();
      expect(await form.copied(), name).toBe(bytes.replaceAll(' ', ''));
      await expect(page.getByText(/^Valid /)).toBeVisible();
    });
  }
  await expect(page.getByRole('region', { name: /guide|article|manual|introduction/ }).getByRole('button')).toHaveCount(
    exampleSources.flatMap(({ examples }) => examples).length,
  );
});

test('what a source prints wrong stands beside what is right, in the list and at the frame', async ({ page }) => {
  test.setTimeout(60000);
  for (const [name, printed, why] of [
    [
      'Set 30 Hz',
      '06 06 02 AB 10 00 E6 A1 (wrong)',
      'the CRC of the bytes before is 0xE5F5, sent low byte first as F5 E5',
    ],
    ['Read 40108–40110', '11 03 00 0B (wrong) 00 03', 'Byte 3 is wrong: register 40108 is address 107, 0x006B'],
  ] as const) {
    await page.goto('./');
    await openExamples(page);
    const button = page.getByRole('button', { name, exact: true });
    await expect(button).toHaveAccessibleDescription(
      new RegExp(`The source prints ${printed.replace(/[()]/g, '\\$&')}`),
    );
    await expect(button).toHaveAccessibleDescription(new RegExp(why));
    await expect(note(page)).toHaveCount(0);

    await button.click();
    await expect(note(page)).toContainText(`prints ${printed}`);
    await expect(note(page)).toContainText(why);
    await expect(note(page)).toBeInViewport();

    await new FrameForm(page).field('unitId').fill('9');
    await expect(note(page)).toHaveCount(0);
  }
});

test('a frame whose source prints no bytes, or not all, says so', async ({ page }) => {
  await page.goto('./');
  await openExamples(page);
  const status = page.getByRole('region', { name: 'The frame' }).getByRole('status');
  await page.getByRole('button', { name: 'Write 2 registers from 5' }).click();
  await expect(status.filter({ hasText: 'An article on an S7-200. It prints no bytes for this frame' })).toBeVisible();
  await page.getByRole('button', { name: 'Reply: the speed' }).click();
  await expect(status.filter({ hasText: 'prints 06 03 02 10 00. It leaves the checksum out, 2 bytes.' })).toBeVisible();
  await page.getByRole('button', { name: 'Write a bit', exact: true }).click();
  await expect(status.filter({ hasText: 'prints' })).toHaveCount(0);
});

test('an example is one step: Back returns to the frame before, Forward to the example and its note', async ({
  page,
}) => {
  await page.goto('./#rtu/request?unitId=17&functionCode=3&startAddress=5&quantity=70000');
  await openExamples(page);
  const form = new FrameForm(page);
  await page.getByRole('button', { name: 'Run', exact: true }).click();
  expect(await form.copied()).toBe('060602AA00016825');
  await page.goBack();
  await expect(form.field('quantity')).toHaveValue('70000');
  await expect(form.field('unitId')).toHaveValue('17');
  await expect(note(page)).toHaveCount(0);
  await page.goForward();
  expect(await form.copied()).toBe('060602AA00016825');
  await expect(note(page)).toContainText('F5 27 (wrong)');
});

test('a reply carries the request that it answers', async ({ page }) => {
  await page.goto('./');
  await openExamples(page);
  await page.getByRole('button', { name: 'Reply: 15 bits' }).click();
  await expect(page.getByLabel('Answers the request')).toHaveValue('01 01 10 20 00 0F 79 04');
  await expect(new FrameForm(page).explanation).toContainText(
    'coil 4136 (04137) off, 4137 (04138) ON, 4138 (04139) off',
  );
});

test('the examples work from the keyboard', async ({ page }) => {
  await page.goto('./');
  await page.locator('summary', { hasText: 'Examples' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('button', { name: 'Set 30 Hz' })).toBeVisible();
  await page.keyboard.press('Tab');
  await expect(page.getByRole('button', { name: 'Set 30 Hz' })).toBeFocused();
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  expect(await new FrameForm(page).copied()).toBe('060602AA00016825');
});

test('axe finds nothing in the open examples, light and dark, and 320 px are wide enough', async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 640 });
  await page.goto('./');
  await openExamples(page);
  await page.getByRole('button', { name: 'Set 30 Hz' }).click();
  await expect(note(page)).toBeVisible();
  expect(await new AxeBuilder(page).findings()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await new AxeBuilder(page).findingsOfColours()).toEqual([]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
});
