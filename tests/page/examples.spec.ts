import type { Page } from '@playwright/test';
import { languages } from '../../src/words/index.ts';
import { exampleSources } from '../../src/workbench/index.ts';
import { FrameForm } from '../browser/form.ts';
import { expect, test } from './page.ts';

const words = await languages.en.input();

/** One of each source and transport: the name on its button, and its bytes. */
const EXAMPLES = [
  ['A guide for a WEG drive', 'Set 30 Hz', '06 06 02 AB 10 00 F5 E5'],
  ['An article on an S7-200', 'Write 2 registers from 5', '01 10 00 05 00 02 04 00 01 00 02 E3 91'],
  ['The I-8xx7 manual', 'TCP reply: 8 bits', '03 29 00 00 00 04 07 01 01 49'],
  ['A Chinese introduction', 'Reply: 401000–401003', '21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18'],
] as const;

const opener = (page: Page) => page.getByRole('button', { name: words.drawer.open });
const drawer = (page: Page) => page.getByRole('dialog', { name: words.drawer.title });
const example = (page: Page, name: string) => drawer(page).getByRole('button', { name, exact: true });

async function openExamples(page: Page): Promise<void> {
  await opener(page).click();
  await expect(example(page, 'Set 30 Hz')).toBeVisible();
}

test('an example gives its bytes at one click, and the drawer stays open for the next', async ({ page }) => {
  await page.goto('./');
  await openExamples(page);
  const form = new FrameForm(page);
  for (const [source, name, bytes] of EXAMPLES) {
    const button = page.getByRole('region', { name: source }).getByRole('button', { name, exact: true });
    await expect(button).toHaveAccessibleDescription(new RegExp(`^${bytes} `));
    await button.click();
    await expect(button).toBeFocused();
    await form.expectCopied(bytes.replaceAll(' ', ''), name);
    await expect(page.getByText(/^Valid /)).toBeVisible();
  }
  // Each has a button that opens it and one that copies it, each source one that copies all, and one the listing of a program.
  await expect(drawer(page).getByRole('tabpanel').getByRole('button')).toHaveCount(
    2 * exampleSources.flatMap(({ examples }) => examples).length + exampleSources.length + 1,
  );
});

test('arrows go from example to example, Copy copies one, and Escape closes the drawer', async ({ page }) => {
  await page.goto('./');
  await opener(page).focus();
  await page.keyboard.press('Enter');
  await expect(drawer(page)).toBeFocused();
  await expect(example(page, 'Set 30 Hz')).toBeVisible();
  await page.keyboard.press('ArrowDown');
  await expect(example(page, 'Set 30 Hz')).toBeFocused();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await expect(example(page, 'Run')).toBeFocused();
  await expect(new FrameForm(page).field('value')).toHaveValue('1');
  await page.keyboard.press('End');
  await expect(example(page, 'Reply: 401000–401003')).toBeFocused();
  await example(page, words.drawer.copyOf('Stop')).click();
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toBe('06 06 02 AA 00 00 A9 E5');
  await page.keyboard.press('Escape');
  await expect(drawer(page)).toHaveCount(0);
  await expect(opener(page)).toBeFocused();
});

test('what a source prints, and what is wrong with it, stands in its row', async ({ page }) => {
  await page.goto('./');
  await openExamples(page);
  for (const [name, said] of [
    ['Set 30 Hz', 'The source prints 06 06 02 AB 10 00 E6 A1 (wrong).'],
    ['Read 40108–40110', 'The source prints 11 03 00 0B (wrong) 00 03.'],
    ['Write 2 registers from 5', 'It prints no bytes for this frame'],
    ['Reply: the speed', 'It leaves the checksum out, 2 bytes.'],
  ] as const) {
    await expect(example(page, name)).toHaveAccessibleDescription(new RegExp(said.replace(/[()]/g, '\\$&')));
  }
  for (const [name, why] of [
    [
      'Set 30 Hz',
      'Bytes 6 and 7 are wrong: the CRC of the bytes before is 0xE5F5, sent low byte first as F5 E5. A device drops the frame as printed and does not answer. Its worked steps go astray',
    ],
    ['Read 40108–40110', 'Byte 3 is wrong: register 40108 is address 107'],
  ] as const) {
    const row = drawer(page)
      .getByRole('listitem')
      .filter({ has: page.getByRole('button', { name, exact: true }) });
    await row.getByText('Why', { exact: true }).click();
    await expect(row.getByText(why)).toBeVisible();
  }
  await expect(example(page, 'Write a bit')).not.toHaveAccessibleDescription(/print|leaves/);
});

test('an example is one step: Back returns to the frame before, Forward to the example', async ({ page }) => {
  await page.goto('./#rtu/request?unitId=17&functionCode=3&startAddress=5&quantity=70000');
  await openExamples(page);
  const form = new FrameForm(page);
  await example(page, 'Reply: 15 bits').click();
  await form.expectBytes('01 01 02 00 12 39 F1');
  await page.goBack();
  await expect(form.field('quantity')).toHaveValue('70000');
  await expect(form.field('unitId')).toHaveValue('17');
  await page.goForward();
  await form.expectCopied('010102001239F1');
});
