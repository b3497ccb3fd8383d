import type { Page } from '@playwright/test';
import { languages } from '../../src/words/index.ts';
import { FrameForm } from '../browser/form.ts';
import { expect, test } from './page.ts';

const words = await languages.en.values();
const { writeValues } = (await languages.en.page()).page;

/** Opens a frame with the drive chosen as the device, and whatever else the browser remembers. */
async function open(page: Page, hash: string, stored: Readonly<Record<string, unknown>> = { device: 'weg-drive' }) {
  await page.addInitScript((all) => {
    for (const [name, value] of Object.entries(all)) {
      if (localStorage.getItem(`framewright.${name}`) === null) {
        localStorage.setItem(`framewright.${name}`, JSON.stringify(value));
      }
    }
  }, stored);
  await page.goto(`./${hash}`);
}

test('a value in the unit of the device becomes the number in its register', async ({ page }) => {
  await open(page, '#rtu/request?unitId=6&functionCode=6&address=0x02AB&value=1');
  const form = new FrameForm(page);
  const value = form.field('value');
  await expect(page.getByText(writeValues, { exact: true })).toBeVisible();
  await value.fill('30.0 Hz');
  await expect(page.getByText('30.0 Hz is 4096 (0x1000).')).toBeVisible();
  await expect(value).toHaveValue('30.0 Hz');
  // 06 06 02 AB 10 00 F5 E5.
  await expect(form.strip.locator('.byte')).toHaveText([/^06/, /^06/, /^02/, /^AB/, /^10/, /^00/, /^F5/, /^E5/]);
  await value.fill('50 Hz');
  await expect(page.getByText('50 Hz is 6827 (0x1AAB), rounded: it stands for 50.00244 Hz.')).toBeVisible();
  await value.press('Tab');
  await expect(page).toHaveURL(/&value=6827&typed\.value=50\+Hz&device=weg-drive/);
  await page.goBack();
  await expect(value).toHaveValue('1');

  // What does not fit is kept and explained, and nothing is sent.
  await value.fill('300 Hz');
  await expect(page.getByText('300 Hz would be raw 40960, which does not fit into i16.')).toBeVisible();
  await expect(value).toHaveAttribute('aria-invalid', 'true');
  await value.fill('3 A');
  await expect(page.getByText(words.fault({ code: 'unit-unknown', unit: 'A', known: ['Hz'] }))).toBeVisible();
  await value.fill('f32 1');
  await expect(page.getByText(words.onlyOne(2))).toBeVisible();
  await value.fill('i16 -5');
  await expect(form.strip.locator('.byte').nth(4)).toHaveText(/^FF/);
});

test('one comma is a decimal comma, which is said, and a list is one click away', async ({ page }) => {
  await open(page, '#rtu/request?unitId=17&functionCode=16&startAddress=1&registers=7', {});
  const form = new FrameForm(page);
  const registers = form.field('registers');
  await registers.fill('f32 21,5');
  await expect(form.strip.locator('.byte').nth(7)).toHaveText(/^41/);
  await expect(page.getByText('The comma is a decimal comma: 21,5 is read as 21.5.')).toBeVisible();
  await registers.fill('21,5');
  // 21.5 is not a register: nothing is written for it, least of all two numbers.
  await expect(registers).toHaveAttribute('aria-invalid', 'true');
  await page.getByRole('button', { name: words.readAs('21, 5') }).click();
  await expect(registers).toHaveValue('21, 5');
  await expect(form.strip.locator('.byte').nth(8)).toHaveText(/^15/);
  await expect(form.strip.locator('.byte').nth(10)).toHaveText(/^05/);
  await expect(page.getByText('decimal comma')).toHaveCount(0);
  // A link holds a list as it was written, whenever that was.
  await page.goto('./#rtu/request?unitId=17&functionCode=16&startAddress=1&registers=21,5');
  await expect(form.strip.locator('.byte').nth(8)).toHaveText(/^15/);
});

test('an address is read in what is written around it', async ({ page }) => {
  await open(page, '#rtu/request?unitId=17&functionCode=3&startAddress=1&quantity=1', {});
  const form = new FrameForm(page);
  const address = form.field('startAddress');
  for (const [typed, high, low] of [
    ['40108.5', '00', '6B'],
    ['4-0108', '00', '6B'],
    ['%MW107:X3', '00', '6B'],
    ['0x1000 (4096)', '10', '00'],
    ['H1000', '10', '00'],
  ] as const) {
    await address.fill(typed);
    await expect(form.strip.locator('.byte').nth(2)).toHaveText(new RegExp(`^${high}`));
    await expect(form.strip.locator('.byte').nth(3)).toHaveText(new RegExp(`^${low}`));
  }
});

test('names of values and of bits are offered where registers are written', async ({ page }) => {
  await open(page, '#rtu/request?unitId=6&functionCode=6&address=685&value=0');
  const form = new FrameForm(page);
  const value = form.field('value');
  await page.getByLabel('P0685 direction', { exact: true }).selectOption({ label: words.namedNumber(1, 'reverse') });
  await expect(value).toHaveValue('1');
  await form.field('address').fill('682');
  const enable = page.getByRole('checkbox', { name: words.namedBit(1, 'general enable') });
  await enable.press('Space');
  await expect(value).toHaveValue('0x0003');
  await expect(enable).toBeChecked();
  await expect(form.explanation).toContainText('run, general enable');
});

test('a scale with limits: the table of the drive, both ways, remembered, and typed into registers', async ({
  page,
}) => {
  await open(
    page,
    '#rtu/reply?unitId=6&functionCode=3&registers=4096+2048&answering=060300000002C5BC&v=3&tab=values',
    {},
  );
  await page.locator('summary', { hasText: new RegExp(`^${words.scale}`) }).press('Enter');
  const label = (name: keyof typeof words.scaleLabels) => page.getByLabel(words.scaleLabels[name], { exact: true });
  await label('factor').fill('60/8192');
  await label('unit').fill('Hz');
  await label('least').fill('60');
  await label('most').fill('0');
  await expect(page.getByText(words.scaleFaults.limits)).toBeVisible();
  await label('least').fill('0');
  await label('most').fill('60');
  await expect(page.getByRole('table', { name: words.scaleTable }).getByRole('row')).toHaveText([
    'HzRaw number',
    '0.00 (0x0000)',
    '15.02048 (0x0800)',
    '30.04096 (0x1000)',
    '45.06144 (0x1800)',
    '60.08192 (0x2000)',
  ]);
  await expect(page.getByText('stands for 30.0 Hz', { exact: true })).toBeVisible();
  const units = page.getByLabel(words.inUnits, { exact: true });
  await units.fill('60.1 Hz');
  await expect(page.getByText('60.1 Hz is outside the limits: 0.0 to 60.0 Hz.')).toBeVisible();
  await page.getByLabel(words.raw, { exact: true }).fill('0x2001');
  await expect(page.getByText(/^stands for 60\.0 Hz, more exactly 60\.00732, outside the limits/)).toBeVisible();

  // Remembered, and known where registers are written.
  await page.goto('./#rtu/request?functionCode=23&writeRegisters=0');
  await page.reload();
  const form = new FrameForm(page);
  await expect(page.getByText(writeValues, { exact: true })).toBeVisible();
  await form.field('writeRegisters').fill('15 Hz, 30 Hz\nf32 CDAB 21.5');
  await expect(page.getByText('15 Hz is 2048 (0x0800). 30 Hz is 4096 (0x1000).')).toBeVisible();
  await form.field('writeRegisters').press('Tab');
  await expect(page).toHaveURL(/writeRegisters=2048\+4096\+0x0000\+0x41AC/);
  await form.field('writeRegisters').fill('61 Hz');
  await expect(page.getByText('61 Hz is outside the limits: 0.0 to 60.0 Hz.')).toBeVisible();
});

test('file records, a FIFO, and both directions of 17 are read and written as values', async ({ page }) => {
  const group = 'subRequests[0].fileNumber=4&subRequests[0].recordNumber=7&subRequests[0].recordData=1714+1213';
  await open(
    page,
    `#pdu/request?functionCode=21&subRequests=2&${group}&subRequests[1].recordData=1&v=3&tab=values`,
    {},
  );
  const form = new FrameForm(page);
  const first = page.getByLabel(words.first, { exact: true });
  await expect(first.getByRole('option')).toHaveText([
    /^file 4, record 7 = 1714/,
    /^file 4, record 8 = 1213/,
    /^file 1, record 0 = 1,/,
  ]);
  const second = page.getByRole('group', { name: '2', exact: true });
  await second.getByRole('button', { name: writeValues }).click();
  await page.getByLabel(words.typed, { exact: true }).fill('f32 CDAB 77.5146');
  await page.getByRole('button', { name: words.apply }).click();
  await expect(form.field('recordData', second)).toHaveValue('0x077A 0x429B');
  await form.field('recordData', second).fill('text "PUMP"');
  await expect(page.getByText('2 registers: 0x5055 0x4D50')).toBeVisible();

  const openNext = (hash: string) => page.evaluate((to) => (location.hash = `${to}&v=3&tab=values`), hash);
  // The request of AP 6.14 asks for file 4, record 1, and file 3, record 9.
  await openNext(
    '#pdu/reply?functionCode=20&subResponses=2&subResponses[0].recordData=0x0DFE+0x0020&subResponses[1].recordData=0x33CD+0x0040&answering=140E0600040001000206000300090002',
  );
  await expect(first.getByRole('option')).toHaveText([
    /^file 4, record 1/,
    /^file 4, record 2/,
    /^file 3, record 9/,
    /^file 3, record 10/,
  ]);
  await openNext('#pdu/reply?functionCode=24&fifoValues=0x01B8+0x1284');
  await expect(first.getByRole('option')).toHaveText([/^number 1 in the list = 440/, /^number 2/]);
  await form.field('fifoValues').fill('u32 CDAB 1');
  await expect(first.getByRole('option')).toHaveText([/= 1, 0x0001/, /= 0, 0x0000/]);
  await openNext('#pdu/request?functionCode=23&readStartAddress=3&writeStartAddress=14&writeRegisters=255+256');
  await expect(first.getByRole('option')).toHaveText([/^40015, address 14 = 255/, /^40016/]);
  await openNext('#pdu/reply?functionCode=23&registers=254+2765&answering=1700030002000E00010200FF');
  await expect(first.getByRole('option')).toHaveText([/^40004, address 3 = 254/, /^40005/]);
});

test('masks by the names of the device’s bits', async ({ page }) => {
  await open(page, '#rtu/request?functionCode=22&referenceAddress=682&andMask=0xFFFF&v=3&tab=values');
  const run = page.getByRole('combobox', { name: words.namedBit(0, 'run') });
  await expect(run).toHaveValue('keep');
  await run.selectOption('set');
  await page.getByRole('combobox', { name: words.namedBit(1, 'general enable') }).selectOption('clear');
  await expect(page.getByLabel(words.setBits, { exact: true })).toHaveValue('0');
  await expect(page.getByLabel(words.clearBits, { exact: true })).toHaveValue('1');
  await page.getByLabel(words.current, { exact: true }).fill('0x0006');
  await expect(page.getByText('5, 0x0005, 0000 0000 0000 0101')).toBeVisible();
  await expect(page.getByLabel(words.current, { exact: true })).toHaveAccessibleDescription(/run, direction/);
  const put = page.getByRole('button', { name: words.useMasks });
  await put.press('Enter');
  await expect(new FrameForm(page).field('andMask')).toHaveValue('0xFFFC');
});
