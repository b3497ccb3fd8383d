import { languages } from '../../src/words/index.ts';
import { Steps } from '../browser/checksum-steps.ts';
import { expect, test } from './page.ts';

const words = await languages.en.checksumSteps();

test('the example of the specification, from the keyboard', async ({ page }) => {
  const steps = new Steps(page);
  await steps.open('bytes=02+07');
  await expect(steps.list.getByRole('row')).toHaveCount(19);
  await steps.list.focus();
  await expect(steps.chosen).toHaveText(/Byte 0 0x02\s*0xFFFF.*xor 0x02 = 0xFFFD\s*0x813E/);
  await steps.press('ArrowDown');
  await expect(steps.chosen).toHaveText(/shift 1\s*0xFFFD 1111 1111 1111 1101\s*1\s*xor 0xA001\s*0xDFFF/);
  await steps.press('ArrowDown', 'ArrowDown');
  await expect(steps.chosen).toHaveText(/shift 3\s*0xCFFE.*0\s*no xor\s*0x67FF/);
  await expect(page.getByText('Shift 3 of byte 0: a 0 leaves. The register is 0x67FF.')).toBeVisible();

  // The table beside it says the same of the byte.
  const byTable = page.getByRole('table', { name: words.table.one(0) }).first();
  await expect(byTable.getByRole('row', { name: words.table.entry })).toContainText('0x81C1');
  await expect(page.getByRole('row', { name: '8 0x813E 0x81C1 0x00FF' })).toBeVisible();

  await steps.press('End');
  await expect(steps.chosen).toHaveText(/shift 8\s*0x2482.*0x1241/);
  await expect(steps.button(words.forward)).toHaveAttribute('aria-disabled', 'true');
  await steps.press('ArrowLeft');
  await expect(steps.chosen).toHaveText(/Byte 1/);
  await steps.press('ArrowLeft');
  await expect(steps.chosen).toHaveAttribute('aria-expanded', 'false');
  await expect(steps.list.getByRole('row')).toHaveCount(11);
  await steps.list
    .getByRole('row', { name: /^Byte 0/ })
    .locator('.mark')
    .click();
  await expect(steps.list.getByRole('row')).toHaveCount(3);
  await expect(steps.chosen).toHaveText(/Byte 0/);
  await steps.press('Shift+ArrowRight');
  await expect(steps.list.getByRole('row')).toHaveCount(19);
  await steps.press('Shift+ArrowLeft');
  await expect(steps.list.getByRole('row')).toHaveCount(3);
  await steps.press('PageUp', 'ArrowRight', 'ArrowRight');
  await expect(steps.chosen).toHaveText(/shift 1/);
  await steps.press('Home', 'g');
  await expect(page.getByLabel(words.goTo)).toBeFocused();

  // What is left at the receiver.
  const receiver = page.getByRole('row', { name: /^Byte 3 0x12/ });
  await expect(receiver).toHaveText(/0x0012\s*0x00\s*0x0000/);
  await expect(page.getByText(words.receiver.swapped('12 41', '0xCD7C'))).toBeVisible();

  // All folded is remembered.
  await page.reload();
  await expect(steps.list.getByRole('row')).toHaveCount(3);
});

test('a byte is gone to, bad input keeps its text, and it plays to the end', async ({ page }) => {
  const steps = new Steps(page);
  // A frame of 256 bytes has 2048 shifts; those in sight are drawn.
  await steps.open(`bytes=${Array.from({ length: 256 }, (_, i) => i.toString(16).padStart(2, '0')).join('+')}`);
  await expect(steps.list).toHaveAttribute('aria-rowcount', '2305');
  await expect(steps.list.getByRole('row').first()).toBeVisible();
  expect(await steps.list.getByRole('row').count()).toBeLessThan(60);
  const goTo = page.getByLabel(words.goTo);
  await goTo.fill('256');
  await goTo.press('Enter');
  await expect(page.getByText(words.noSuchByte(255))).toBeVisible();
  await expect(goTo).toHaveValue('256');
  await goTo.fill('0xFF.7');
  await goTo.press('Enter');
  await expect(page.getByText(words.noSuchByte(255))).toBeHidden();
  await expect(steps.chosen).toHaveText(/^shift 7/);

  await page.getByLabel(words.speed).selectOption({ label: words.perSecond(30) });
  await steps.list.focus();
  await steps.press('Space');
  await expect(steps.chosen).toHaveText(/^shift 8/);
  // It stops by itself.
  await expect(steps.button(words.play)).toBeVisible();

  // Other bytes begin anew.
  await page.getByRole('textbox', { name: 'Bytes' }).fill('06 06 02 AB 10 00');
  await expect(steps.chosen).toHaveText(/Byte 0 0x06\s*0xFFFF.*0x423F/);
  await expect(page.getByText(words.noSuchByte(255))).toBeHidden();
});

test('the table for a program, the LRC, and the guide that is wrong', async ({ page }) => {
  const copied = () => page.evaluate(() => navigator.clipboard.readText());
  const steps = new Steps(page);
  await steps.open('bytes=0A+01+04+A1+00+01');
  const part = (name: string) => page.locator(`details.${name}`);
  for (const name of ['checksum-table', 'checksum-lrc-steps', 'checksum-printed-example']) {
    await part(name).locator('summary').click();
  }
  // 0xF5 is the low byte of FFFF xor 0A.
  await expect(part('checksum-table').locator('td[aria-current]')).toHaveText('0x47C0');
  await part('checksum-table').getByRole('radio', { name: words.entries.languages.st }).check();
  await part('checksum-table').getByRole('radio', { name: words.entries.kinds.two }).check();
  await steps.button(words.entries.copy).click();
  await expect(part('checksum-table').getByRole('status')).toHaveText(words.copied);
  expect(await copied()).toMatch(/^auchCRCHi : ARRAY\[0\.\.255\] OF BYTE := \[\n {2}16#00, 16#C1, 16#81, 16#40, /);
  await steps.button(words.copySteps).click();
  await expect.poll(copied).toMatch(/^Step\tRegister before\t.*\nByte 0 0x0A\t0xFFFF\t1111 1111 1111 1111\t/);

  await expect(part('checksum-lrc-steps')).toContainText(
    'The sum is 0xB1. All bits turned over it is 0x4E; plus 1, 0x4F.',
  );
  const example = part('checksum-printed-example');
  await expect(example.getByRole('row', { name: /^Bit 0/ })).toHaveText(
    /1 leaves, 0xD7FC\s*0xDFFD\s*1 leaves, 0xDFFD\s*wrong/,
  );
  await expect(example.getByRole('row', { name: /^Sent as/ })).toHaveText(/E6 A1\s*F5 E5/);
  await example.getByRole('link', { name: words.example.open }).click();
  await expect(steps.chosen).toHaveText(/Byte 0 0x06/);
});

test('the receiver: what is left of each kind of CRC, why, and of bytes that end in their own', async ({ page }) => {
  const steps = new Steps(page);
  const receiver = page.locator('section.step-section', {
    has: page.getByRole('heading', { name: words.receiver.title }),
  });
  const { left, whyZero, whyConstant, whyTitle, whyTitleHigh, why, ends, notBytes } = words.receiver;
  const shown = async (query: string, said: readonly string[], not: readonly string[]) => {
    await page.evaluate((hash) => {
      location.hash = hash;
    }, `#checksum?${query}`);
    for (const text of said) await expect(receiver, query).toContainText(text);
    for (const text of not) await expect(receiver, query).not.toContainText(text);
  };
  await steps.open('bytes=02+07');
  // SL 6.2.2: 02 07 is sent with 41 12; the residues are those of the catalogue of CRCs.
  await shown('bytes=02+07', [left('0x0000'), whyZero, whyTitle, why.low], [whyConstant, whyTitleHigh, ends(2)]);
  await shown('bytes=02+07+41+12', [left('0x0000'), ends(2)], []);
  await shown('bytes=02+07&algorithm=CRC-16/IBM-SDLC', [left('0xF0B8'), whyConstant, whyTitle], [whyZero]);
  await shown('bytes=02+07&algorithm=CRC-16/XMODEM', [left('0x0000'), whyZero, whyTitleHigh, why.high], [whyTitle]);
  await shown('bytes=02+07&algorithm=own&width=12&poly=0x80F', [notBytes], [whyZero, whyConstant]);
});
