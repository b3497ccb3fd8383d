import { gzipSync } from 'node:zlib';
import { languages } from '../../src/words/index.ts';
import { FrameForm } from '../browser/form.ts';
import { button, chosen, list, paste } from '../browser/log-view.ts';
import { expect, test } from './page.ts';

const words = await languages.en.trace();
const input = await languages.en.input();

const GOOD = ['06 03 02 A9 00 01 54 25', '06 03 02 10 00 00 44'] as const;
const OTHER = '01 03 00 6B 00 02 B5 D7';
/** 200 lines, a second for each exchange: three refusals, one reply with a bit changed, two requests that nothing answers. */
const LOG = Array.from({ length: 101 }, (_, n) => {
  const at = (milliseconds: number) =>
    `10:${String(10 + Math.floor(n / 60)).padStart(2, '0')}:${String(n % 60).padStart(2, '0')}.${String(milliseconds).padStart(3, '0')}`;
  const ask = `${at(0)} Tx ${n % 40 === 7 ? OTHER : GOOD[0]}`;
  if (n === 30 || n === 80) return [ask];
  if (n % 40 === 7) return [ask, `${at(210)} Rx 01 83 02 C0 F1`];
  return [ask, `${at(4)} Rx ${n === 60 ? '06 03 02 10 00 01 44' : GOOD[1]}`];
})
  .flat()
  .join('\n');

test('one paste and six keys find the six bad frames of a log of 200 lines, and the summary leads to them', async ({
  page,
}) => {
  await page.goto('./');
  await expect(page.getByRole('list', { name: 'The frame' })).toBeVisible();
  await paste(page, LOG);
  await expect(list(page)).toHaveAccessibleName('200 frames');
  await expect(button(page, '200 frames, 101 exchanges')).toBeVisible();
  const found: string[] = [];
  for (let key = 0; key < 6; key++) {
    await page.keyboard.press('F8');
    await expect(chosen(page)).toHaveCount(1);
    await expect.poll(() => chosen(page).getAttribute('data-index')).not.toBe(found.at(-1));
    found.push((await chosen(page).getAttribute('data-index')) ?? '');
  }
  expect(new Set(found).size).toBe(6);
  await expect(chosen(page)).toHaveAttribute('data-severity', 'warning');
  await button(page, '1 wrong CRC').click();
  await expect(list(page)).toHaveAccessibleName('1 frame');
  await list(page).getByRole('option').click();
  await expect(page.getByRole('main')).toContainText('Wrong CRC');
  await button(page, '1 wrong CRC').click();
  await button(page, '3 exceptions').click();
  await expect(list(page)).toHaveAccessibleName('3 frames');
  await expect(list(page).getByRole('option').first()).toContainText('210 ms');
  await page.goBack();
  await expect(list(page)).toHaveAccessibleName('200 frames');
  for (let back = 0; back < 3; back++) await page.goBack();
  await expect(page.getByRole('textbox', { name: input.label })).toHaveValue(/^10:10:00\.000 Tx 06 03 02 A9/);
});

/** A pcap (LINKTYPE_USER0, RTU) of a request and its reply, again and again, a millisecond apart. */
function pcap(times: number): Buffer {
  const head = Buffer.alloc(24);
  head.writeUInt32LE(0xa1b2c3d4, 0);
  head.writeUInt16LE(2, 4);
  head.writeUInt16LE(4, 6);
  head.writeUInt32LE(65_535, 16);
  head.writeUInt32LE(147, 20);
  const frames = GOOD.map((text) => Buffer.from(text.replaceAll(' ', ''), 'hex'));
  const packets = Array.from({ length: 2 * times }, (_, n) => {
    const frame = frames[n % 2] as Buffer;
    const own = Buffer.alloc(16);
    own.writeUInt32LE(1_700_000_000 + Math.floor(n / 1000), 0);
    own.writeUInt32LE((n % 1000) * 1000, 4);
    own.writeUInt32LE(frame.length, 8);
    own.writeUInt32LE(frame.length, 12);
    return Buffer.concat([own, frame]);
  });
  return Buffer.concat([head, ...packets]);
}

test('a capture, packed too, is opened from the Frame view and gone through by keys', async ({ page }) => {
  await page.goto('./');
  const file = { mimeType: 'application/octet-stream', buffer: gzipSync(pcap(30_000)) };
  await page.getByLabel(input.openFile).setInputFiles({ name: 'bus.pcap.gz', ...file });
  await expect(list(page)).toHaveAccessibleName('60,000 frames');
  await expect(page.getByText(words.source('bus.pcap.gz', 'pcap'))).toBeVisible();
  await list(page).focus();
  await page.keyboard.press('End');
  await expect(chosen(page)).toHaveAttribute('aria-posinset', '60000');
  await page.keyboard.press('PageUp');
  await page.keyboard.press('Home');
  await expect(chosen(page)).toHaveAttribute('aria-posinset', '1');
  await page.getByRole('radio', { name: words.unitNames.exchange }).check({ force: true });
  await expect(list(page)).toHaveAccessibleName('30,000 exchanges');
});

test('the frame of a row is the current one, with the other of its exchange, and the tabs say what they say in the Frame view', async ({
  page,
}) => {
  const form = new FrameForm(page);
  await page.goto('./#log?log=demo');
  await expect(list(page)).toHaveAccessibleName('200 frames');
  await page.keyboard.press('F8');
  await form.expectBytes('06 83 02 71 30');
  const frame = page.getByRole('region', { name: 'The frame' });
  await frame.getByRole('button', { name: 'Request', exact: true }).click();
  await form.expectBytes('06 03 03 E7 00 01 35 CE');
  await page.getByRole('tab', { name: 'Reply', exact: true }).click();
  await expect(page.getByRole('tabpanel', { name: 'Reply' })).toContainText('06 83 02 71 30');
  await page.keyboard.press('F8');
  await form.expectBytes('01 03 00 00 00 04 44 09');
  await expect(frame.getByRole('button', { name: 'Reply', exact: true })).toHaveCount(0);
  await page.keyboard.press('Shift+F8');
  await form.expectBytes('06 83 02 71 30');
  await page.getByRole('link', { name: 'Frame', exact: true }).click();
  await form.expectBytes('06 83 02 71 30');
});
