import { mkdtemp, open, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { languages } from '#known';
import { AxeBuilder } from './axe.ts';
import { ChecksumView } from './checksum-view.ts';
import { expect, test } from './page.ts';

const words = await languages.en.checksum();
const card = await languages.en.checksumCard();

test('dark, at 320 px, nothing is wider than the page and axe finds nothing; a file of 40 MB is read in pieces', async ({
  page,
}) => {
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.setViewportSize({ width: 320, height: 640 });
  const view = new ChecksumView(page);
  await view.open('?bytes=02+07&algorithm=CRC-32/ISO-HDLC&width=16&poly=x');
  // What the address fills is open.
  await expect(page.getByText(words.ownFault({ code: 'not-a-number', text: 'x' }))).toBeVisible();
  for (const title of [words.which, words.card]) await view.unfold(title);
  await page.getByLabel(words.claim).fill('41 12');
  await expect(page.getByRole('list', { name: words.matches }).getByRole('listitem').first()).toBeVisible();
  await expect(page.getByRole('table', { name: card.known })).toBeVisible();
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
  const axe = new AxeBuilder(page);
  expect(await axe.findings()).toEqual([]);
  await page.setViewportSize({ width: 1280, height: 720 });
  await page.emulateMedia({ colorScheme: 'light' });
  expect(await axe.findingsOfColours()).toEqual([]);

  const folder = await mkdtemp(join(tmpdir(), 'framewright-file-'));
  try {
    const path = join(folder, 'forty-megabytes');
    const file = await open(path, 'w');
    const block = Buffer.alloc(2 ** 20);
    for (let n = 0; n < 40; n++) {
      block.fill(n + 1);
      await file.write(block);
    }
    await file.close();
    const chooser = page.locator('.checksum-input input[type=file]');
    await chooser.setInputFiles(path);
    // No value of what was typed before stands beside the file.
    await expect(page.getByText(words.size(40 * 2 ** 20))).toBeVisible();
    await expect(view.results).not.toContainText('0xE5F5');
    await expect(page.getByText(/^Read and computed at \d+ MB\/s/)).toBeVisible();
    // By zlib.crc32 and binascii.crc_hqx of Python, and for CRC-16/MODBUS its register's matrix to the power of 2^20.
    await expect(view.results).toContainText('CRC-16/MODBUSNumber0x5492');
    await expect(view.results).toContainText('CRC-32/ISO-HDLCNumber0x63FC4154');
    await expect(view.results).toContainText('LRCNumber0x00');
    // Another algorithm is worked out when it is chosen.
    await expect(view.row('CRC-16/XMODEM').getByRole('cell').first()).toHaveText(words.chooseIt);
    await view.row('CRC-16/XMODEM').getByRole('radio').check();
    await expect(view.results).toContainText('CRC-16/XMODEMNumber0xF32E');
    await expect(view.row('CRC-32/ISO-HDLC').getByRole('cell').first()).toContainText('0x63FC4154');
  } finally {
    await rm(folder, { recursive: true });
  }
});
