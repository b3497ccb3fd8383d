import { languages } from '../../src/words/index.ts';
import { FrameForm } from '../browser/form.ts';
import { request, WireTab } from '../browser/wire-tab.ts';
import { expect, test } from './page.ts';

const words = await languages.en.wire();

test('a frame on its line: zoom, light, bits as a table', async ({ page }) => {
  const wire = new WireTab(page);
  await wire.open(request);
  await expect(wire.picture).toHaveAccessibleName(/19200 8E1: Request, 8 bytes, 4\.583 ms; Reply, 11 bytes, 6\.302 ms/);
  await expect(wire.pairs).toHaveText(['01', '03', '00', '6B', '00', '03', '74', '17']);
  await wire.button(words.zoomTo.all).click();
  await expect(wire.pairs).toHaveCount(19);

  // A byte anywhere lights here, and the other way round.
  await wire.button(words.zoomTo.frame).click();
  const strip = new FrameForm(page).strip.locator('.byte');
  await strip.nth(3).hover();
  await expect(wire.picture.locator('.character[data-lit] .pair')).toHaveText('6B');
  await wire.picture.locator('.character').nth(6).hover();
  await expect(new FrameForm(page).strip.locator('.byte[data-lit]')).toHaveText([/^74/]);

  await wire.button(words.zoomTo.byte).click();
  // From the keyboard: to the end, where the line is idle, and out to all.
  await wire.panel.getByRole('region', { name: words.view }).focus();
  await page.keyboard.press('End');
  await expect(wire.pairs).toHaveCount(0);
  await page.keyboard.press('0');
  await expect(wire.pairs).toHaveCount(19);

  // The table behind it, and from it to the byte.
  await wire.panel.getByText(words.table).click();
  const rows = wire.panel.getByRole('table').getByRole('row');
  await expect(rows).toHaveCount(9);
  // 6B = 0110 1011: five ones, so that the even parity bit is 1.
  await expect(rows.nth(4)).toHaveText(/^3 ?6B ?Start address ?0 11010110 1 1 ?1\.719 ms$/);
  await wire.button(words.show('6B', 3)).click();
  await expect(wire.picture.locator('.character[data-lit] .letter')).toHaveText([
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
  const wire = new WireTab(page);
  await wire.open(request);
  await wire.entry(words.speed).fill('0x2580x');
  await expect(wire.panel.getByText(words.notASpeed)).toBeVisible();
  await expect(wire.entry(words.speed)).toHaveValue('0x2580x');
  await wire.entry(words.speed).fill('0x2580');
  await expect(wire.picture).toHaveAccessibleName(/9600 8E1: Request, 8 bytes, 9\.167 ms/);
  await page.getByRole('radio', { name: words.levelKinds.rs232 }).check();
  await expect(wire.panel).toContainText(words.levelNotes.rs232);

  // t1.5 at 9600 baud 8E1 is 1.719 ms.
  await wire.entry(words.gapAt).fill('8');
  await expect(wire.panel.getByText(words.notAGapAt(7))).toBeVisible();
  await wire.entry(words.gapAt).fill('3');
  await wire.entry(words.gapTime).fill('1.7');
  await expect(wire.panel).toContainText(words.gap('1.7 ms', 'whole'));
  await wire.entry(words.gapTime).fill('2');
  await expect(wire.panel).toContainText(words.gap('2 ms', 'discarded'));
  await expect(wire.picture.locator('[data-measure="gap"]')).toContainText('gap 2 ms');
  // The line is remembered.
  await page.reload();
  await expect(wire.picture).toHaveAccessibleName(/9600 8E1/);
  await expect(page.getByRole('radio', { name: words.levelKinds.rs232 })).toBeChecked();

  // Another device brings its own settings, until they are changed.
  await page.evaluate(() => localStorage.setItem('framewright.device', '"weg-drive"'));
  await page.reload();
  await expect(wire.picture).toHaveAccessibleName(/9600 8N1/);
  await expect(wire.panel).toContainText(words.fromDevice('WEG drive'));
  await wire.entry(words.format).selectOption('8E1');
  await expect(wire.picture).toHaveAccessibleName(/9600 8E1/);
  await expect(wire.panel).not.toContainText(words.fromDevice('WEG drive'));
});

test('what receivers set otherwise read', async ({ page }) => {
  const wire = new WireTab(page);
  await wire.open(request);
  const receiver = wire.entry(words.receiver);
  await receiver.selectOption(words.receivers.parity);
  await expect(wire.panel).toContainText('8 bytes sent, 8 read, 8 of them with an error.');
  await receiver.selectOption(words.receivers['no-parity']);
  await wire.panel.getByText(words.received).click();
  await expect(wire.panel.getByRole('table').getByRole('row').nth(3)).toHaveText(/^2 ?00.*break/);
  await receiver.selectOption(words.receivers.own);
  await wire.entry(words.receiverSpeed).fill('9600');
  await expect(wire.panel).toContainText(words.receiverIs(9600, '8E1'));
  await expect(wire.picture.locator('.received[data-error]')).not.toHaveCount(0);
  // A byte alone has all kinds of parts that the whole has, and is checked sooner.
  await wire.button(words.zoomTo.byte).click();
});

test('characters of ASCII, and the segment of TCP', async ({ page }) => {
  const wire = new WireTab(page);
  await wire.open('#ascii/request?unitId=1&functionCode=3&startAddress=0x6B&quantity=3');
  await expect(wire.picture).toHaveAccessibleName(/19200 8E1: Request, 17 bytes, 9\.74 ms/);
  await expect(wire.pairs.first()).toHaveText(':');
  await expect(wire.panel).toContainText(words.noSilences);
  await wire.panel.getByText(words.table).click();
  // ":" = 3A = 0011 1010: four ones.
  await expect(wire.panel.getByRole('row').nth(1)).toContainText('0 01011100 0 1');

  await new FrameForm(page).choose('Transport', 'TCP');
  const packet = wire.panel.getByRole('img', { name: words.packet.picture(12) });
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
});
