import { languages } from '../../src/words/index.ts';
import { Timing } from '../browser/timing-view.ts';
import { expect, test } from './page.ts';

const words = await languages.en.timing();

test('a line, the current exchange, its devices and a gap, by their labels', async ({ page }) => {
  const timing = new Timing(page);
  // Unit 17 reads 3 registers: 8 bytes, answered by 11.
  await page.goto('./#rtu/request?unitId=17&functionCode=3&startAddress=0x6B&quantity=3');
  await page.getByRole('banner').getByRole('link', { name: 'Timing' }).click();
  await expect(page).toHaveTitle(words.title);
  await expect(timing.row(words.silences, /^11 bits/)).toContainText('2.005 ms2005.208 µs, 38.5 bits');

  // 9600 8N1: both readings, and what counts.
  await timing.field(words.speed).fill('0x2580');
  await timing.field(words.format).selectOption('8N1');
  await expect(page.getByText('without parity it asks for two stop bits')).toBeVisible();
  await expect(timing.row(words.silences, /^10 bits/)).toContainText('3.646 ms');
  await expect(timing.row(words.silences, /^10 bits/)).toContainText(words.inForce);
  await page.getByRole('radio', { name: '11 bits' }).check();
  await expect(timing.row(words.silences, /^11 bits/)).toContainText(`${words.inForce}1.146 ms`);
  await expect(timing.row(words.silences, /^11 bits/)).toContainText('4.010 ms');

  // 8 × 10 + 38.5 + 11 × 10 + 38.5 = 267 bits: 27.8125 ms, 35.95 of them in a second.
  const exchange = timing.panel(words.thisExchange);
  await expect(exchange.getByRole('link', { name: '03 Read Holding Registers, unit 17' })).toBeVisible();
  await expect(timing.row(words.steps, words.total)).toContainText('27.813 ms');
  await expect(exchange).toContainText('At most 35.9 exchanges a second. The line is silent for 28.8 % of the time.');
  await timing.field(words.delay).fill('10 ms');
  await expect(timing.row(words.steps, words.silentSteps.answer)).toContainText('10 ms');
  await timing.field(words.delay).fill('soon');
  await expect(page.getByText('“soon” is not a time')).toBeVisible();
  await expect(exchange).toContainText(words.correct);
  await expect(page.getByRole('table', { name: words.steps })).toHaveCount(0);
  await timing.field(words.delay).fill('0');

  // 9 that answer, and one that is waited for: 9 × 27.8125 + 8.333 + 1000 ms.
  await timing.field(words.missing).fill('1');
  await expect(page.getByText('A round takes 1.259 s. Each device is asked every 1.259 s.')).toBeVisible();
  await timing.field(words.devicesCount).fill('248');
  await expect(page.getByText('248 does not fit: whole numbers from 1 to 247')).toContainText('§2.2');
  await timing.field(words.devicesCount).fill('5');

  const gap = timing.panel(words.gapTitle);
  for (const [text, effect, also] of [
    ['0.004 s', 'discarded', 'with 10 bits a character: two frames'],
    ['5 chars', 'two-frames', ''],
  ] as const) {
    await timing.field(words.gap).fill(text);
    await expect(gap, text).toContainText(`${words.effects[effect]}.`);
    await expect(gap, text).toContainText(also);
  }

  // All of it stands in the address, with the frame.
  await timing.field(words.gap).blur();
  const address = page.url();
  await page.evaluate(() => localStorage.clear());
  await page.goto('about:blank');
  await page.goto(address);
  await expect(timing.field(words.speed)).toHaveValue('0x2580');
  await expect(timing.field(words.gap)).toHaveValue('5 chars');
  await expect(timing.field(words.devicesCount)).toHaveValue('5');
  await expect(page.getByRole('link', { name: '03 Read Holding Registers, unit 17' })).toBeVisible();
  await expect(timing.field(words.reply('rtu'))).toHaveAttribute('placeholder', '11');
});

test('above 19200, ASCII, a broadcast, the usual speeds copied, and the line remembered', async ({ page }) => {
  const timing = new Timing(page);
  await timing.open('#timing?baud=38400&format=8E1&gap=1.1&frame=rtu/request?unitId%3D0%26functionCode%3D6');
  await expect(timing.row(words.silences, words.fixed)).toContainText('750 µs');
  await expect(timing.row(words.silences, words.fixed)).toContainText('1.750 ms');
  await expect(timing.row(words.silences, /^11 bits/)).toContainText('1.003 ms');
  const gap = timing.panel(words.gapTitle);
  await expect(gap).toContainText(`${words.effects.discarded}. `);
  await expect(gap).toContainText('To a receiver that counts, with 11 bits a character: two frames.');

  // A broadcast: 8 × 11 bits and the turnaround.
  await expect(timing.field(words.turnaround)).toHaveValue('100 ms');
  await expect(page.getByText('a broadcast goes to all devices at once, and takes 102.292 ms')).toBeVisible();
  await timing.field(words.reply('rtu')).fill('0x08');
  await expect(timing.field(words.delay)).toHaveValue('0 ms');

  await page.getByRole('button', { name: words.copy }).click();
  await expect(page.getByText(words.copied, { exact: true })).toBeVisible();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toMatch(
    /^Speed\tCharacter, 11 bits, µs\tt1\.5, 11 bits, µs/,
  );

  await page.getByRole('radio', { name: 'ASCII' }).check();
  await expect(timing.field(words.request('ascii'))).toHaveAttribute('placeholder', '17');
  await expect(page.getByRole('table', { name: words.silences })).toHaveCount(0);
  await timing.field(words.gap).fill('1.1 s');
  await expect(gap).toContainText('More than 1 s is an error');

  // The line is remembered, the exchange is not.
  await page.goto('about:blank');
  await timing.open();
  await expect(timing.field(words.speed)).toHaveValue('38400');
  await expect(timing.field(words.gap)).toHaveValue('1.1 s');
  await expect(page.getByRole('radio', { name: 'RTU' })).toBeChecked();
  await expect(timing.field(words.reply('rtu'))).toHaveValue('');

  // The line of a device, from its profile.
  await page.getByRole('banner').getByRole('link', { name: 'Frame' }).click();
  await page.getByRole('heading', { name: 'Device', exact: true }).click();
  await page.getByLabel('Device profile').selectOption({ label: 'WEG drive' });
  await page.getByRole('link', { name: 'Timing of this line' }).click();
  await expect(timing.field(words.speed)).toHaveValue('9600');
  await expect(timing.field(words.format)).toHaveValue('8N1');
  await expect(page).toHaveURL(/#timing\?baud=9600&format=8N1&.*&frame=rtu/);
});
