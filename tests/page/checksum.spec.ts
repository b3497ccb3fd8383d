import { languages } from '../../src/words/index.ts';
import { ChecksumView } from '../browser/checksum-view.ts';
import { FrameForm } from '../browser/form.ts';
import { expect, test } from './page.ts';

const words = await languages.en.checksum();
const card = await languages.en.checksumCard();

// Each opens the view once and goes through much of it.

test('the current frame, then anything typed, in every algorithm', async ({ page }) => {
  const view = new ChecksumView(page);
  await page.goto('./#rtu/request?unitId=2&functionCode=7');
  await expect(new FrameForm(page).strip).toBeVisible();
  await page.getByRole('banner').getByRole('link', { name: 'Checksum' }).click();
  await expect(view.input).toHaveValue('02 07');
  await view.unfoldAll();
  await expect(view.results).toContainText('0x1241');
  await expect(view.results).toContainText(`${words.wire}41 12`);
  await page.getByRole('button', { name: words.whole }).click();
  await expect(view.input).toHaveValue('02 07 41 12');
  await expect(view.results).toContainText(words.endsWithCrc);

  await view.input.fill('33, 3, 3, 231, 0, 4');
  await expect(page.getByText('6 bytes. Read as decimal.')).toBeVisible();
  for (const [name, value] of [
    ['CRC-16/MODBUS', '0x1AF3'],
    ['CRC-16/KERMIT', '0x7ACA7A CA · CA 7A'],
  ] as const) {
    await expect(view.row(name).getByRole('cell').first(), name).toContainText(value);
  }
  await view.row('CRC-16/MODBUS').getByRole('button', { name: 'Copy 0x1AF3' }).click();
  await expect(page.getByText(words.copied('0x1AF3'))).toBeVisible();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe('0x1AF3');

  // By its value, its polynomial, another name; the chosen one from the keyboard.
  await view.search.fill('0xCA7A');
  await expect(view.table.getByRole('radio')).toHaveCount(1);
  await page.keyboard.press('Tab');
  await view.row('CRC-16/KERMIT').getByRole('radio').focus();
  await page.keyboard.press('Space');
  await expect(view.results).toContainText(`CRC-16/KERMIT${words.number}0x7ACA`);
  await view.search.fill('nothing at all');
  await page.getByRole('button', { name: words.clearSearch }).click();
  await expect(view.search).toBeFocused();
  await page.getByRole('button', { name: words.columns.value }).press('Enter');
  await expect(view.table.getByRole('columnheader', { name: words.columns.value })).toHaveAttribute(
    'aria-sort',
    'ascending',
  );
  await view.search.fill('ccitt');
  await expect(page).toHaveURL(/algorithm=CRC-16%2FKERMIT&search=ccitt&sort=value/);
  await page.reload();
  await expect(view.input).toHaveValue('33, 3, 3, 231, 0, 4');
  await expect(view.row('CRC-16/KERMIT').getByRole('radio')).toBeChecked();

  // Bad input keeps its text, with what is wrong beside it; the same characters are a text.
  await view.input.fill('1, 3, 300');
  await expect(view.input).toHaveAttribute('aria-invalid', 'true');
  await expect(page.getByText('300 does not fit into a byte.', { exact: false })).toBeVisible();
  await view.input.fill('123456789');
  await page.getByRole('radio', { name: words.kinds.text }).check({ force: true });
  await expect(view.results).toContainText('0x4B37');
});

test('own parameters, a claimed value, and the test card', async ({ page }) => {
  const view = new ChecksumView(page);
  await view.open('?bytes=21+03+03+E7+00+04');
  await view.unfold(words.ownTitle);
  const field = (name: keyof typeof words.parameters) => page.getByLabel(words.parameters[name], { exact: true });
  await field('width').fill('40');
  await expect(page.getByText(words.ownFault({ code: 'out-of-range', least: 1, most: 32 }))).toBeVisible();
  await expect(page.getByRole('button', { name: words.useOwn })).toBeDisabled();
  await field('width').fill('16');
  await field('poly').fill('0xA001');
  await page.getByLabel(words.polyAs).selectOption('reversed');
  await field('init').fill('65535');
  await field('refin').check();
  await field('refout').check();
  await page.getByRole('button', { name: words.useOwn }).click();
  await expect(page.getByText('x^16 + x^15 + x^2 + 1')).toBeVisible();
  await expect(view.results).toContainText(`${words.own}${words.number}0x1AF3`);
  await expect(view.row(words.own)).toContainText('0x8005');
  await expect(view.row(words.own)).toContainText('0x4B37');

  await view.unfold(words.which);
  await page.getByLabel(words.claim).fill('C2 78');
  const matches = page.getByRole('list', { name: words.matches });
  await expect(matches.getByRole('listitem').first()).toContainText('CRC-16/DNP of all bytes, low byte first.');
  await page.getByRole('button', { name: words.chooseNamed('CRC-16/DNP') }).click();
  await expect(view.results).toContainText('CRC-16/DNP');
  await page.getByLabel(words.claim).fill('12 34 56');
  await expect(page.getByText(words.notAClaim('12 34 56'))).toBeVisible();
  await page.getByLabel(words.claim).fill('');
  await expect(page.getByText(words.noneAtEnd)).toBeVisible();

  await view.unfold(words.card);
  const known = page.getByRole('table', { name: card.known });
  await expect(known.getByRole('row', { name: /^0A 01 04 A1 00 01/ })).toContainText('0x4F0x4Fright');
  await expect(known.getByRole('row').filter({ hasText: 'E6 A1' })).toContainText(/F5 E5\s*wrong/);
  await known.getByRole('button', { name: card.useNamed('0A 01 04 A1 00 01') }).click();
  await expect(view.results).toContainText('0x4F');
  await expect(view.input).toBeFocused();
  await expect(page).toHaveURL(/bytes=0A\+01/);
});

test('a file in all algorithms, closed again; one dropped', async ({ page }) => {
  const view = new ChecksumView(page);
  await view.open();
  const chooser = page.locator('.checksum-input input[type=file]');
  await chooser.setInputFiles({ name: 'nine', mimeType: 'text/plain', buffer: Buffer.from('123456789') });
  await expect(view.row('CRC-16/KERMIT').getByRole('cell').first()).toContainText('0x2189');
  await page.getByRole('button', { name: words.closeFile }).click();
  await expect(view.input).toHaveValue('06 06 02 AB 10 00');
  await page.evaluate(() => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([Uint8Array.of(2, 7)], 'dropped'));
    document
      .querySelector('main')!
      .dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  });
  await expect(view.results).toContainText('0x1241');
  await expect(page).toHaveURL(/#checksum/);
});

test('long input is worked out in the background', async ({ page }) => {
  const view = new ChecksumView(page);
  await view.open();
  // 30,000 bytes of A5 from a text that is too long to be read while typing.
  await view.input.fill('A5 '.repeat(30_000));
  await expect(page.getByText('30,000 bytes. Read as hexadecimal.')).toBeVisible();
  await expect(view.row('CRC-16/XMODEM').getByRole('cell').first()).toContainText('0xA19B');
  await expect(page).not.toHaveURL(/bytes=/);
});
