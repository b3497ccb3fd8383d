import { readFile } from 'node:fs/promises';
import { defaultRules } from '#known';
import { Bus } from './harness/bus.ts';
import { expect, test } from './harness/fixtures.ts';
import { LatePeer } from './harness/late-peer.ts';

/** Takes 20 ms; is late once, repeats each twentieth reply, and is slower than the time-out for three requests. */
const manner = (number: number): readonly number[] => {
  if (number === 40) return [1300];
  if (number >= 150 && number < 153) return [1100];
  return number % 20 === 10 ? [20, 24] : [20];
};

test.use({ replyTimeout: defaultRules.timeout });

test('300 reads of a device that is late and repeats itself show no register the value of another', async ({
  page,
  plugAdapter,
}) => {
  test.slow();
  const adapter = await plugAdapter({ unit: null });
  const peer = new LatePeer(adapter.cable.device, manner);
  const bus = new Bus(page);
  await page.goto('/#rtu/request?unitId=1&functionCode=3&startAddress=10&quantity=2');
  await page.getByRole('link', { name: 'Bus' }).click();
  await bus.choose();
  await page.getByRole('tab', { name: 'Poll' }).click();
  await page.getByLabel('Registers of a device').check();
  await page.getByLabel('Device profile').selectOption({ label: 'S7-200 with holding registers from VB800' });
  const names = ['VW800', 'VW820', 'VW840', 'VW860'];
  for (const name of names) {
    await page.getByLabel('Find registers to poll').fill(name);
    await page.getByRole('checkbox', { name: `${name} u16` }).check();
  }
  await page.getByText('How they are read').click();
  await page.getByLabel('Largest gap').fill('0');
  await expect(page.getByText('4 values in 4 requests a round.')).toBeVisible();
  await page.getByLabel('Interval (ms)').fill('0');
  await page.getByRole('button', { name: 'Start' }).click();
  await expect.poll(() => peer.requests, { timeout: 100_000 }).toBeGreaterThan(300);
  await page.getByRole('button', { name: 'Stop', exact: true }).click();
  await expect(page.getByText('Stopped.')).toBeVisible();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save as CSV' }).click(),
  ]);
  const rows = (await readFile(await download.path(), 'utf8')).trim().split('\r\n').slice(1);
  const columns = names.map((_, at) => rows.map((row) => row.split(',')[at + 1]).filter(Boolean));
  // VB800 is register 1, the address 0, and two bytes on is the next address.
  expect(columns.map((values) => [...new Set(values)])).toEqual([['1000'], ['1010'], ['1020'], ['1030']]);
  expect(columns.flat().length).toBeGreaterThanOrEqual(270);
  peer.stop();
});
