import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { AxeBuilder } from '../browser/axe.ts';
import { openedChooser } from './harness/chooser.ts';
import { expect, test } from './harness/fixtures.ts';

const status = (page: Page) => page.getByRole('region', { name: 'Connection' }).getByRole('status');
const row = (page: Page, name: string) => page.getByRole('row', { name });

/** Opens the view with a frame at hand, connects, and opens the panel. */
async function connect(page: Page, frame: string): Promise<void> {
  await page.goto(`/#${frame}`);
  await page.getByRole('link', { name: 'Bus' }).click();
  await page.getByLabel('Speed (baud)').fill('9600');
  await page.getByRole('button', { name: 'Connect…' }).click();
  const chooser = await openedChooser();
  await chooser.pick(0);
  await expect(status(page)).toContainText('Connected to');
  await page.getByRole('tab', { name: 'Poll' }).click();
}

test('the current frame is polled, drawn and saved; a lost adapter ends it, and it goes on', async ({
  page,
  plugAdapter,
}) => {
  // An adapter is chosen, pulled out and plugged in again.
  test.slow();
  const adapter = await plugAdapter();
  await connect(page, 'rtu/request?unitId=1&functionCode=3&startAddress=10&quantity=2');
  await expect(page.getByText('2 values in 1 request a round.')).toBeVisible();
  const interval = page.getByLabel('Interval (ms)');
  await interval.fill('soon');
  await expect(interval).toHaveAttribute('aria-invalid', 'true');
  await expect(interval).toHaveValue('soon');
  await interval.fill('0x32');
  await page.getByRole('button', { name: 'Start' }).click();
  const panel = page.getByRole('region', { name: 'Values: 03 Read Holding Registers, unit 1' });
  await expect(panel).toContainText(/[3-9] rounds\. Every request was answered\./);
  // libmodbus holds 1000 + the address.
  for (const [name, value, hex] of [
    ['Holding register 10', '1010', '03F2'],
    ['Holding register 11', '1011', '03F3'],
  ] as const) {
    const cells = row(page, name).getByRole('cell');
    await expect(cells).toHaveText([/400\d\d|0x000/, value, hex, value, value, value, '0', /^(< 1|\d+) s$/]);
  }
  await expect(
    page.getByRole('img', { name: /^Chart of Holding register 10, Holding register 11 over/ }),
  ).toBeVisible();
  await page.getByText('The last rounds as a table').click();
  await expect(
    page
      .getByRole('row', { name: /^\d\d:\d\d:\d\d\.\d (Holding register 10 )?1010 (Holding register 11 )?1011$/ })
      .first(),
  ).toBeVisible();

  await adapter.pullOut();
  await expect(page.getByText('The adapter was lost, and the poll has ended.')).toBeVisible();
  const goOn = page.getByRole('button', { name: 'Go on' });
  await expect(goOn).toBeDisabled();
  const before = Number(/(\d+) rounds/.exec((await panel.textContent()) ?? '')?.[1]);
  await adapter.plugIn();
  await page.getByRole('button', { name: 'Connect to FTDI FT232R' }).click();
  await goOn.click();
  await expect(page.getByText('Polling.')).toBeVisible();
  await expect
    .poll(async () => Number(/(\d+) rounds/.exec((await panel.textContent()) ?? '')?.[1]))
    .toBeGreaterThan(before + 3);
  await page.getByRole('button', { name: 'Stop', exact: true }).click();
  await expect(page.getByText('Stopped.')).toBeVisible();
  expect(await new AxeBuilder(page).findings()).toEqual([]);

  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save as CSV' }).click(),
  ]);
  const text = await readFile(await download.path(), 'utf8');
  const [header, first] = text.split('\r\n');
  expect(header).toBe('\uFEFFTime (UTC),Holding register 10,Holding register 11');
  expect(first).toMatch(/^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z,1010,1011$/);
});

test('chosen registers of a device are read in as few requests as there need be', async ({ page, plugAdapter }) => {
  await plugAdapter();
  await connect(page, 'rtu/request?unitId=1&functionCode=3&startAddress=10&quantity=2');
  await page.getByLabel('Registers of a device').check();
  await page.getByLabel('Device profile').selectOption({ label: 'S7-200 with holding registers from VB800' });
  // libmodbus has 200 registers, and refuses VW1202, the 202nd.
  for (const name of ['VW800', 'VW802', 'VW820', 'VW1202']) {
    await page.getByLabel('Find registers to poll').fill(name);
    await page.getByRole('checkbox', { name: `${name} u16` }).check();
  }
  await expect(page.getByText('4 values in 2 requests a round.')).toBeVisible();
  await page.getByText('How they are read').click();
  await page.getByLabel('Largest gap').fill('0');
  await expect(page.getByText('4 values in 3 requests a round.')).toBeVisible();
  await page.getByLabel('Interval (ms)').fill('50');
  await page.getByRole('button', { name: 'Start' }).click();
  // VB800 is register 1, and libmodbus holds 1000 + the address.
  for (const [name, value] of [
    ['VW800', '1000'],
    ['VW802', '1001'],
    ['VW820', '1010'],
  ] as const) {
    await expect(row(page, name).getByRole('cell').nth(1)).toHaveText(value);
  }
  await expect(row(page, 'VW1202').getByRole('cell').nth(1)).toHaveText('– exception 02, ILLEGAL DATA ADDRESS');
  await expect(row(page, 'VW1202').getByRole('cell').nth(6)).toHaveText(/^\d+ \(100 %\)$/);
  await expect(row(page, 'VW820').getByRole('cell').nth(6)).toHaveText('0');
  await page.getByRole('button', { name: 'Stop', exact: true }).click();
  await expect(page.getByText('Stopped.')).toBeVisible();
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.setViewportSize({ width: 320, height: 800 });
  await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth)).toBe(320);
  expect(await new AxeBuilder(page).findings()).toEqual([]);
  // What was chosen is there again.
  await page.reload();
  await page.getByRole('tab', { name: 'Poll' }).click();
  await expect(page.getByText('4 values in 3 requests a round.')).toBeVisible();
});
