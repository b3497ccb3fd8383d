import { FrameForm } from '../browser/form.ts';
import { expect, test } from './page.ts';

type Page = import('@playwright/test').Page;

const clipboard = (page: Page) => page.evaluate(() => navigator.clipboard.readText());
const strip = (page: Page) => page.getByRole('region', { name: 'The frame' });
const WRONG = './#rtu/request?unitId=6&functionCode=6&address=0x02AB&value=4096&force.checksum=0xA1E6';

test('an entry of the list copies at once, and the format is remembered but not a missing checksum', async ({
  page,
}) => {
  await page.goto('./');
  const list = strip(page).getByRole('button', { name: 'Other formats' });
  for (const [format, text] of [
    ['C', 'const uint8_t write_683_4096[8] = { 0x06, 0x06, 0x02, 0xAB, 0x10, 0x00, 0xF5, 0xE5 };'],
    [
      'Structured Text',
      'Write683_4096 : ARRAY[0..7] OF BYTE := [16#06, 16#06, 16#02, 16#AB, 16#10, 16#00, 16#F5, 16#E5];',
    ],
    // 06 + 06 + 02 + AB + 10 + 00 = C9, whose two's complement is 37.
    ['ASCII line', ':060602AB100037'],
    ['Hexadecimal pairs', '06 06 02 AB 10 00 F5 E5'],
    ['Python', 'write_683_4096 = bytes([0x06, 0x06, 0x02, 0xAB, 0x10, 0x00, 0xF5, 0xE5])'],
  ] as const) {
    await list.click();
    await page
      .getByRole('menuitem', { name: new RegExp(`^${format}`) })
      .first()
      .click();
    await expect.poll(() => clipboard(page)).toBe(text);
    await expect(list).toBeFocused();
  }
  const copy = strip(page).getByRole('button', { name: /^Copy / });
  await expect(copy).toHaveText(/^Copy Python/);
  await list.press('Enter');
  await expect(page.getByRole('menuitem').first()).toBeFocused();
  await page.keyboard.press('End');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Escape');
  await expect(list).toBeFocused();
  await expect(copy).toContainText('no checksum');
  await copy.click();
  await expect.poll(() => clipboard(page)).toBe('write_683_4096 = bytes([0x06, 0x06, 0x02, 0xAB, 0x10, 0x00])');
  await page.reload();
  await expect(copy).toHaveText(/^Copy Python/);
  await expect(copy).not.toContainText('no checksum');
});

test('a wrong frame says why beside its verdict, offers the right one first, and copies with a warning', async ({
  page,
}) => {
  await page.goto(WRONG);
  await expect(strip(page)).toContainText('Wrong CRC');
  await expect(strip(page)).toContainText(
    'The WEG guide prints E6 A1 for this frame; that is a misprint. The CRC is F5 E5.',
  );
  await expect(strip(page).getByRole('listitem').last()).toContainText('should be F5 E5');
  await strip(page).getByRole('button', { name: 'Copy the wrong frame' }).click();
  await expect.poll(() => clipboard(page)).toBe('06 06 02 AB 10 00 E6 A1');
  await strip(page).getByRole('button', { name: /^Why/ }).click();
  const why = page.getByRole('dialog', { name: /^Why/ });
  await expect(why).toContainText('Serial Line §2.5.1.2');
  await expect(why.getByRole('heading', { level: 3 })).toHaveText(/^A known misprint/);
  await page.keyboard.press('Escape');
  await expect(why).toBeHidden();
  await strip(page).getByRole('button', { name: 'Use F5 E5' }).click();
  await expect(strip(page)).toContainText('Valid request');
  await new FrameForm(page).expectCopied('060602AB1000F5E5');
  await page.goBack();
  await expect(strip(page)).toContainText('Wrong CRC');
});

test('every byte is reached by arrow keys and typed in its place', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  const byte = (at: number) => form.strip.getByRole('button', { name: new RegExp(`^byte ${at},`) });
  await byte(0).focus();
  for (let at = 1; at < 8; at++) {
    await page.keyboard.press('ArrowRight');
    await expect(byte(at)).toBeFocused();
  }
  await expect(form.explanation.getByRole('row').filter({ hasText: 'Checksum.' })).toHaveAttribute('data-lit');
  // One stop for the Tab key.
  expect(await form.strip.locator('button.byte[tabindex="0"]').count()).toBe(1);
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowDown');
  await expect(byte(1)).toBeFocused();
  // Escape gives the byte back; digits are no commands of the page.
  await byte(4).focus();
  await page.keyboard.type('2');
  await page.keyboard.press('Escape');
  await expect(byte(4)).toHaveText(/^10/);
  await expect(byte(4)).toBeFocused();
  await page.keyboard.type('08');
  await page.keyboard.press('Enter');
  await expect(byte(4)).toBeFocused();
  await expect(form.field('value')).toHaveValue('2048');
  await form.expectCopied('060602AB0800FFE5');
  // A wrong checksum is taken as typed.
  await byte(7).click();
  await byte(7).click();
  await expect(form.strip.getByRole('textbox')).toBeFocused();
  await page.keyboard.type('A1');
  await page.keyboard.press('Tab');
  await expect(strip(page)).toContainText('Wrong CRC');
  await page.goBack();
  await expect(strip(page)).toContainText('Valid request');
});

test('the frame before stays, dimmed, where a field has no value', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  await form.field('value').fill('70000');
  await expect(strip(page)).toContainText('The frame before');
  await expect(strip(page)).toContainText('“Value” has no value that can be sent.');
  await expect(form.strip).toContainText('F5');
  await expect(strip(page).getByRole('button', { name: 'Copy the frame before' })).toBeVisible();
});

test('the explanation is copied as Markdown and as a table', async ({ page }) => {
  await page.goto('./');
  const choose = async (name: RegExp) => {
    await strip(page).getByRole('button', { name: 'Copies the explanation' }).click();
    await page.getByRole('menuitem', { name }).first().click();
  };
  await choose(/^Markdown/);
  await expect.poll(() => clipboard(page)).toMatch(/^\| byte \| hex \| dec\. \| bits \| means \| section \|/);
  await choose(/^Table/);
  await expect.poll(() => clipboard(page)).toContain('2–3\t02 AB\t683\t\tAddress. ');
});
