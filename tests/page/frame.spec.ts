import type { Page } from '@playwright/test';

import { FrameForm } from '../browser/form.ts';
import { expect, test } from './page.ts';

/** What the strip says while the form has no frame. */
const before = (page: Page) => page.getByText('The frame before', { exact: true });

test('the first frame is the speed reference of a drive, with every byte explained', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  await form.expectCopied('060602AB1000F5E5');
  await expect(form.strip.getByRole('listitem')).toHaveCount(5);
  await expect(form.explanation).toContainText('Unit 6 is addressed; every other device on the line stays silent.');
  await expect(form.explanation).toContainText('Address 683 (0x02AB) = register 40684.');
  await expect(form.explanation).toContainText('CRC-16/MODBUS of bytes 0–5 is 0xE5F5, sent low byte first. It holds.');
});

test('what is typed shows at once', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  await form.field('value').fill('0x0800');
  await expect(form.strip).toContainText('08');
  await form.expectBytes('06 06 02 AB 08 00 FF E5');
});

test('a register value that has no bytes: the frame before stays, and so does the text, with the reason', async ({
  page,
}) => {
  await page.goto('./');
  const form = new FrameForm(page);
  for (const [text, said] of [
    ['70000', '70000 does not fit: whole numbers from 0 to 65535 (0x0000 to 0xFFFF).'],
    ['abc', '“abc” is not a number.'],
    ['', 'Type a value.'],
  ] as const) {
    const value = form.field('value');
    await value.fill(text);
    await expect(before(page)).toBeVisible();
    await form.expectBytes('06 06 02 AB 10 00 F5 E5');
    await expect(value).toHaveValue(text);
    await expect(value).toHaveAttribute('aria-invalid', 'true');
    await expect(value).toHaveAccessibleDescription(
      new RegExp(`^${said.replace(/[().]/g, '\\$&')}${text === 'abc' ? '(?!.*§)' : '.*§6\\.6'}`),
    );

    await value.fill('4096');
    await expect(before(page)).toHaveCount(0);
  }
});

test('what has no bytes is said at its field', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  for (const [name, code, field, text, said] of [
    ['unit', 3, 'unitId', '256', /256 does not fit: whole numbers from 0 to 255 .*Serial Line §2\.2/],
    ['register list', 16, 'registers', '1, 2, 65536', /^Item 3: 65536 does not fit.*§6\.12/],
    ['register list with a word', 16, 'registers', '1 two 3', /^Item 2: “two” is not a number(?!.*§)/],
    ['bit list', 15, 'bits', '1 0 2', /^Item 3: “2” is not a bit(?!.*§)/],
    ['raw data', 8, 'data', '0', /“0” is neither hexadecimal pairs(?!.*§)/],
  ] as const) {
    await form.chooseFunction(code);
    await form.field(field).fill(text);
    await expect(form.field(field), name).toHaveAccessibleDescription(said);
    await expect(form.field(field)).toHaveValue(text);
    await expect(before(page)).toBeVisible();
  }
});

test('128 registers have no byte count: said, and forcing the count gives the frame', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  await form.chooseFunction(16);
  await form.field('registers').fill('7 '.repeat(128));
  await expect(before(page)).toBeVisible();
  await expect(page.getByText('256 does not fit: whole numbers from 0 to 255 (0x00 to 0xFF).')).toBeVisible();
  await page.getByRole('button', { name: 'Force Byte count' }).click();
  await expect(before(page)).toHaveCount(0);
  await expect(page.getByText('The quantity is 128. Legal are 1 to 123.').first()).toBeVisible();
});

test('a frame that breaks a rule is built, and the problem stands on its byte, at its field and with its section', async ({
  page,
}) => {
  await page.goto('./');
  const form = new FrameForm(page);
  await form.chooseFunction(3);
  await form.field('unitId').fill('1');
  await form.field('startAddress').fill('0');
  await form.field('quantity').fill('126');
  const said = 'The quantity is 126. Legal are 1 to 125.';
  await expect(page.getByText('Invalid request', { exact: true })).toBeVisible();
  await expect(form.explanation.getByRole('row').filter({ hasText: 'Quantity.' })).toContainText(said);
  await expect(form.field('quantity')).toHaveAccessibleDescription(new RegExp(`${said} §6\\.3`));
  await form.expectBytes('01 03 00 00 00 7E C5 EA');
});

test('a forced checksum is sent as forced, plainly marked, and one click back', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  await page.getByRole('button', { name: 'Force Checksum' }).click();
  await page.getByLabel('Checksum (forced)').fill('0xA1E6');
  await form.expectBytes('06 06 02 AB 10 00 E6 A1');
  await expect(
    page.getByText('The CRC does not hold: the bytes before it give 0xE5F5, sent F5 E5; the frame has E6 A1.').first(),
  ).toBeVisible();
  await page.getByRole('button', { name: 'Calculate again: Checksum' }).click();
  await form.expectBytes('06 06 02 AB 10 00 F5 E5');
});

test('the reply to a read shows the addresses and the bits that its request asked for', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  await form.choose('Kind of frame', 'Reply');
  await form.chooseFunction(1, 'Reply');
  await form.field('unitId').fill('17');
  await form.field('bits').fill('1011 0011 1101 0110 0100 1101 0111 0000 1101 1');
  await form.answer('11 01 00 13 00 25 0E 84');
  await form.expectBytes('11 01 05 CD 6B B2 0E 1B 45 E6');
  await expect(form.explanation).toContainText('37 coils, 21 of them ON.');
  await expect(form.explanation).toContainText('coil 19 (00020) ON, 20 (00021) off');
});

test('the address holds the frame, Back and Forward undo and redo, and a reload brings it back', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  await form.field('value').fill('1');
  await form.field('unitId').fill('2');
  await form.field('unitId').blur();
  await expect(page).toHaveURL(/#rtu\/request\?unitId=2&functionCode=6&address=0x02AB&value=1$/);
  await page.goBack();
  await expect(form.field('unitId')).toHaveValue('6');
  await expect(form.field('value')).toHaveValue('1');
  await page.goBack();
  await expect(form.field('value')).toHaveValue('4096');
  await page.goForward();
  await page.goForward();
  await expect(form.field('unitId')).toHaveValue('2');
  await page.reload();
  await expect(form.field('value')).toHaveValue('1');
  await form.expectBytes('02 06 02 AB 00 01 38 61');
});

test('an invalid draft is in the address too', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  await form.field('value').fill('70000');
  await expect(page).toHaveURL(/value=70000$/);
  await page.reload();
  await expect(form.field('value')).toHaveValue('70000');
});

test('a link with parts that mean nothing says which, and keeps its text', async ({ page }) => {
  await page.goto('./#rtu/question?unitId=9&functionCode=3&%25=1');
  await expect(page.getByRole('alert')).toContainText('“rtu/question” is not known');
  await expect(page.getByRole('alert')).toContainText('#rtu/question?unitId=9');
  await expect(new FrameForm(page).field('unitId')).toHaveValue('9');
});

test('every byte of a register has a line once it is unfolded', async ({ page }) => {
  const form = new FrameForm(page);
  await page.goto('./#rtu/request?unitId=17&functionCode=16&startAddress=107&registers=1000 2');
  const lines = form.explanation.getByRole('row').filter({ hasText: /^\d+[0-9A-F]{2}/ });
  await expect(lines).toHaveCount(3);
  await page.getByRole('button', { name: 'The single bytes of 7–8' }).click();
  await expect(lines).toHaveCount(5);
  await page.getByRole('button', { name: 'Unfold all bytes' }).click();
  await expect(lines).toHaveCount(13);
  await expect(lines.nth(7)).toHaveText('703' + '0000 0011 High byte: 3 × 256 = 768.');
});

test('a byte under the pointer lights its field in the strip, the explanation and the form', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  await form.strip.getByText('AB').hover();
  await expect(form.explanation.getByRole('row').filter({ hasText: 'Address.' })).toHaveAttribute('data-lit');
  await form.field('value').focus();
  await expect(form.explanation.getByRole('row').filter({ hasText: 'Value.' })).toHaveAttribute('data-lit');
  await expect(form.explanation.getByRole('row').filter({ hasText: 'Address.' })).not.toHaveAttribute('data-lit');
});
