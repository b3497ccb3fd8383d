import { readFile } from 'node:fs/promises';
import { readCapture } from '../../src/captures/index.ts';
import { Bus, READ_33 } from '../browser/bus-view.ts';
import { expect, test } from './page.ts';

test('the log is filtered, cleared and brought back, paused, loaded again, and opened in the Log view', async ({
  page,
}) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.send('Answered.');
  await bus.take('rtu/request?unitId=6&functionCode=3&startAddress=9&quantity=1');
  await bus.send('The device refused the request: exception 02');
  await expect(bus.lines).toHaveCount(4);

  await bus.log.getByRole('button', { name: '1 exception' }).click();
  await expect(bus.lines).toHaveCount(1);
  await expect(page).toHaveURL(/#bus\?search=exception/);
  const filter = page.getByRole('combobox', { name: 'Filter' });
  await filter.fill('text:"d4 31"');
  await expect(bus.lines).toHaveCount(1);
  await filter.fill('unit:');
  await filter.blur();
  await expect(bus.log.getByText('“unit” needs a value')).toBeVisible();
  await filter.fill('');
  await expect(bus.lines).toHaveCount(4);
  await bus.log.getByRole('radio', { name: 'exchange' }).check();
  await expect(bus.lines).toHaveCount(2);
  await bus.log.getByRole('radio', { name: 'frame' }).check();
  await bus.button('Clear').click();
  await expect(bus.lines).toHaveCount(0);
  await bus.button('Undo clear').click();
  await expect(bus.lines).toHaveCount(4);

  await bus.button('Pause').click();
  await bus.button('Send').click();
  await expect(bus.log).toContainText('Paused: 2 frames not shown yet.');
  await expect(bus.lines).toHaveCount(4);
  await bus.button('Pause').click();
  await expect(bus.lines).toHaveCount(6);

  await page.reload();
  await expect(bus.log).toContainText('6 frames from before the page was loaded again.');
  await expect(bus.lines.nth(1)).toContainText('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18');
  await bus.log.getByRole('button', { name: 'Save…' }).click();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('dialog').getByRole('button', { name: 'Save file' }).click(),
  ]);
  const saved = readCapture(await readFile(await download.path()));
  expect(saved).toMatchObject({ format: 'pcapng', records: { length: 6 }, problems: [] });
  await page.getByRole('dialog').getByRole('button', { name: 'Close' }).click();
  await bus.button('Open in Log').click();
  await expect(page.getByRole('button', { name: '6 frames, 3 exchanges' })).toBeVisible();
});

test('the row that is chosen is the current frame with its pair; F8 goes to what went wrong', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.send('Answered.');
  await bus.take('rtu/request?unitId=6&functionCode=3&startAddress=9&quantity=1');
  await bus.send('The device refused the request: exception 02');
  await bus.waitAtMost(100);
  await bus.take('rtu/request?unitId=77&functionCode=3&startAddress=9&quantity=1');
  await bus.send('No device answered: unit 77');
  await expect(bus.lines).toHaveCount(5);
  await bus.lines.nth(1).click();
  const panel = page.getByRole('tabpanel', { name: 'Frame' });
  await expect(panel).toContainText('12345');
  await expect(bus.result).toContainText('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18');
  await panel.getByRole('button', { name: 'Request', exact: true }).click();
  await expect(bus.result).toContainText('21 03 03 E7 00 04 F3 1A');
  await page.keyboard.press('F8');
  await expect(bus.result).toContainText('06 83 02 71 30');
  await expect(bus.lines.nth(3)).toHaveAttribute('aria-selected', 'true');
  await page.keyboard.press('F8');
  await expect(bus.lines.nth(4)).toHaveAttribute('aria-selected', 'true');
  await expect(bus.lines.nth(4)).toContainText('no reply');
  await page.keyboard.press('Shift+F8');
  await expect(bus.lines.nth(3)).toHaveAttribute('aria-selected', 'true');
});

test('a thousand lines stand: each tab is as it was left, and a reply is shown', async ({ page }) => {
  const bus = new Bus(page);
  await bus.openWithThousandLines();
  const panel = (name: string) => page.getByRole('tabpanel', { name });
  await bus.tab('Scan');
  await page.getByLabel('First unit').fill('5');
  await bus.tab('Listen');
  await bus.tab('Sequence');
  await page.getByLabel('Name', { exact: true }).fill('Mine');
  await bus.tab('Virtual devices');
  await page.getByLabel('What goes wrong').selectOption({ label: 'Late reply' });
  await bus.tab('Poll');
  await page.getByLabel('Interval (ms)').fill('50');
  await bus.button('Start').click();
  const stop = panel('Poll').getByRole('button', { name: 'Stop' });
  await expect(stop).toHaveClass(/stop/);
  await expect(bus.log.getByRole('button', { name: /^\d,\d{3} frames/ })).toBeVisible();

  for (const name of ['Scan', 'Listen', 'Sequence', 'Virtual devices']) await bus.tab(name);
  await expect(page.getByLabel('What goes wrong')).toHaveValue('late');
  await bus.tab('Sequence');
  await expect(page.getByLabel('Name', { exact: true })).toHaveValue('Mine');
  await bus.tab('Scan');
  await expect(page.getByLabel('First unit')).toHaveValue('5');
  await bus.tab('Poll');
  await expect(panel('Poll')).toContainText('Polling.');
  await stop.click();
  await expect(page.getByLabel('Interval (ms)')).toHaveValue('50');

  await bus.tab('Reply');
  await bus.send('Answered.');
  await expect(bus.reply).toContainText('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18');
  await expect(bus.lines.last()).toContainText('41000 = 12345');
});

test('the log is there when the page is loaded again, and again', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.tab('Poll');
  await bus.button('Start').click();
  await expect(bus.lines.nth(3)).toBeVisible();
  await page.reload();
  await expect(bus.log).toContainText(/\d+ frames from before the page was loaded again\./);
  await expect(bus.lines.nth(1)).toContainText('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18');
  await page.reload();
  await expect(bus.lines.nth(1)).toContainText('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18');
});
