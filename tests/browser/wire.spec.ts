import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { languages } from '../../src/words/index.ts';
import { AxeBuilder } from './axe.ts';
import { FrameForm } from './form.ts';
import { expect, test } from './page.ts';

const words = await languages.en.wire();

const request = '#rtu/request?unitId=1&functionCode=3&startAddress=0x6B&quantity=3';

const panel = (page: Page) => page.getByRole('tabpanel', { name: 'On the wire' });
const picture = (page: Page) => panel(page).getByRole('img', { name: /^Waveform/ });
const button = (page: Page, name: string) => panel(page).getByRole('button', { name, exact: true });
const entry = (page: Page, label: string) => panel(page).getByLabel(label, { exact: true });
/** The pairs over the bytes in sight. */
const pairs = (page: Page) => picture(page).locator('.character .pair');

async function open(page: Page, hash: string): Promise<void> {
  await page.goto(`./${hash}&v=3&tab=wire`);
}

test('a frame on its line: zoom, scroll, light, bits as a table', async ({ page }) => {
  await open(page, request);
  await expect(picture(page)).toHaveAccessibleName(
    /19200 8E1: Request, 8 bytes, 4\.583 ms; Reply, 11 bytes, 6\.302 ms/,
  );
  await expect(pairs(page)).toHaveText(['01', '03', '00', '6B', '00', '03', '74', '17']);
  await button(page, words.zoomTo.all).click();
  await expect(pairs(page)).toHaveCount(19);

  // A byte anywhere lights here, and the other way round.
  await button(page, words.zoomTo.frame).click();
  const strip = new FrameForm(page).strip.locator('.byte');
  await strip.nth(3).hover();
  await expect(picture(page).locator('.character[data-lit] .pair')).toHaveText('6B');
  await picture(page).locator('.character').nth(6).hover();
  await expect(new FrameForm(page).strip.locator('.byte[data-lit]')).toHaveText([/^74/]);

  // By Ctrl and the wheel, at the pointer.
  await page.keyboard.down('Control');
  for (let step = 0; step < 6; step++) await page.mouse.wheel(0, -100);
  await page.keyboard.up('Control');
  await expect(pairs(page).filter({ hasText: '74' })).toHaveCount(1);
  await expect(pairs(page)).not.toHaveCount(8);

  // From the keyboard: to the end, where the line is idle, and out to all.
  await panel(page).getByRole('region', { name: words.view }).focus();
  await page.keyboard.press('End');
  await expect(pairs(page)).toHaveCount(0);
  await page.keyboard.press('0');
  await expect(pairs(page)).toHaveCount(19);
  await page.mouse.move(0, 0);

  // The table behind it, and from it to the byte.
  await panel(page).getByText(words.table).click();
  const rows = panel(page).getByRole('table').getByRole('row');
  await expect(rows).toHaveCount(9);
  // 6B = 0110 1011: five ones, so that the even parity bit is 1.
  await expect(rows.nth(4)).toHaveText(/^3 ?6B ?Start address ?0 11010110 1 1 ?1\.719 ms$/);
  await button(page, words.show('6B', 3)).click();
  await expect(picture(page).locator('.character[data-lit] .letter')).toHaveText([
    'start',
    '0',
    '1',
    '2',
    '3',
    '4',
    '5',
    '6',
    '7',
    'parity',
    'stop',
  ]);
});

test('another line and a gap in the frame, bad input beside them, and the line remembered', async ({ page }) => {
  await open(page, request);
  await entry(page, words.speed).fill('0x2580x');
  await expect(panel(page).getByText(words.notASpeed)).toBeVisible();
  await expect(entry(page, words.speed)).toHaveValue('0x2580x');
  await entry(page, words.speed).fill('0x2580');
  await expect(picture(page)).toHaveAccessibleName(/9600 8E1: Request, 8 bytes, 9\.167 ms/);
  await page.getByRole('radio', { name: words.levelKinds.rs232 }).check();
  await expect(panel(page)).toContainText(words.levelNotes.rs232);

  // t1.5 at 9600 baud 8E1 is 1.719 ms.
  await entry(page, words.gapAt).fill('8');
  await expect(panel(page).getByText(words.notAGapAt(7))).toBeVisible();
  await entry(page, words.gapAt).fill('3');
  await entry(page, words.gapTime).fill('1.7');
  await expect(panel(page)).toContainText(words.gap('1.7 ms', 'whole'));
  await entry(page, words.gapTime).fill('2');
  await expect(panel(page)).toContainText(words.gap('2 ms', 'discarded'));
  await expect(picture(page).locator('[data-measure="gap"]')).toContainText('gap 2 ms');
  // The line is remembered.
  await page.reload();
  await panel(page).scrollIntoViewIfNeeded();
  await expect(picture(page)).toHaveAccessibleName(/9600 8E1/);
  await expect(page.getByRole('radio', { name: words.levelKinds.rs232 })).toBeChecked();

  // Another device brings its own settings, until they are changed.
  await page.evaluate(() => localStorage.setItem('framewright.device', '"weg-drive"'));
  await page.reload();
  await panel(page).scrollIntoViewIfNeeded();
  await expect(picture(page)).toHaveAccessibleName(/9600 8N1/);
  await expect(panel(page)).toContainText(words.fromDevice('WEG drive'));
  await entry(page, words.format).selectOption('8E1');
  await expect(picture(page)).toHaveAccessibleName(/9600 8E1/);
  await expect(panel(page)).not.toContainText(words.fromDevice('WEG drive'));
});

test('what receivers set otherwise read', async ({ page }) => {
  await open(page, request);
  const receiver = entry(page, words.receiver);
  await receiver.selectOption(words.receivers.parity);
  await expect(panel(page)).toContainText('8 bytes sent, 8 read, 8 of them with an error.');
  await receiver.selectOption(words.receivers['no-parity']);
  await panel(page).getByText(words.received).click();
  await expect(panel(page).getByRole('table').getByRole('row').nth(3)).toHaveText(/^2 ?00.*break/);
  await receiver.selectOption(words.receivers.own);
  await entry(page, words.receiverSpeed).fill('9600');
  await expect(panel(page)).toContainText(words.receiverIs(9600, '8E1'));
  await expect(picture(page).locator('.received[data-error]')).not.toHaveCount(0);
  // A byte alone has all kinds of parts that the whole has, and is checked sooner.
  await button(page, words.zoomTo.byte).click();
  expect(await new AxeBuilder(page).findings()).toEqual([]);
});

test('the picture is saved as an SVG that stands alone, and as a PNG of twice its size', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'dark' });
  await open(page, request);
  await expect(pairs(page)).toHaveCount(8);
  const saved = async (name: string) => {
    const download = page.waitForEvent('download');
    await button(page, name).click();
    return readFile(await (await download).path());
  };
  const svg = (await saved(words.saveSvg)).toString();
  await expect(panel(page)).toContainText(words.saved('framewright-rtu.svg'));
  const alone = await page.context().newPage();
  await alone.goto(`data:image/svg+xml;base64,${Buffer.from(svg).toString('base64')}`);
  const said = await alone.evaluate(() => {
    const texts = [...document.querySelectorAll('text')];
    return {
      root: document.documentElement.tagName,
      width: document.documentElement.getAttribute('width'),
      pairs: texts.filter((each) => each.getAttribute('class') === 'pair').map((each) => each.textContent),
      fills: [...new Set(texts.map((each) => each.getAttribute('fill')))],
      waves: [...document.querySelectorAll('path.wave')].map((each) => each.getAttribute('stroke')),
      sizes: [...new Set(texts.map((each) => each.getAttribute('font-size')))].every((size) =>
        /^\d+px$/.test(size ?? ''),
      ),
    };
  });
  expect(said.root).toBe('svg');
  expect(said.width).toBe('1200');
  expect(said.pairs).toEqual(['01', '03', '00', '6B', '00', '03', '74', '17']);
  // Dark ink on white paper, whatever the page has, and no variables of the page.
  expect(new Set(said.waves)).toEqual(new Set(['rgb(27, 29, 31)']));
  expect(said.fills.every((fill) => /^rgb\(/.test(fill ?? ''))).toBe(true);
  expect(said.sizes).toBe(true);
  expect(svg).not.toContain('var(');

  const png = await saved(words.savePng);
  expect(png.subarray(1, 4).toString()).toBe('PNG');
  expect(png.readUInt32BE(16)).toBe(2400);
});

test('characters of ASCII, and the segment of TCP', async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 700 });
  await open(page, '#ascii/request?unitId=1&functionCode=3&startAddress=0x6B&quantity=3');
  await expect(picture(page)).toHaveAccessibleName(/19200 8E1: Request, 17 bytes, 9\.74 ms/);
  await expect(pairs(page).first()).toHaveText(':');
  await expect(panel(page)).toContainText(words.noSilences);
  await panel(page).getByText(words.table).click();
  // ":" = 3A = 0011 1010: four ones.
  await expect(panel(page).getByRole('row').nth(1)).toContainText('0 01011100 0 1');

  await new FrameForm(page).choose('Transport', 'TCP');
  const packet = panel(page).getByRole('img', { name: words.packet.picture(12) });
  await expect(packet).toContainText(words.packet.mbap(7));
  await expect(packet.locator('.cell .pair')).toHaveText([
    '00',
    '01',
    '00',
    '00',
    '00',
    '06',
    '01',
    '03',
    '00',
    '6B',
    '00',
    '03',
  ]);
  await packet.locator('.cell').nth(6).hover();
  await expect(new FrameForm(page).strip.locator('.byte[data-lit]')).toHaveText([/^01/]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
  expect(await new AxeBuilder(page).findings()).toEqual([]);
});
