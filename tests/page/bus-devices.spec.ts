import { Bus, READ_33, SET_SPEED } from '../browser/bus-view.ts';
import { expect, test } from './page.ts';

test('a fault asked for once happens once, and who heard the frame is shown', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.waitAtMost(200);
  await bus.openDevices();
  await bus.button('Ask for this fault').click();
  await expect(page.getByText('Silence: no reply, every device, once')).toBeVisible();
  await bus.send('No device answered: unit ');
  await expect(page.getByText('Nothing goes wrong.')).toBeVisible();
  const heard = page.getByRole('region', { name: 'Who hears what' });
  await expect(heard).toContainText('Unit 33 (Modicon 984): its unit; it would answer. Fault asked for: Silence');
  await expect(heard).toContainText('Unit 1 (Siemens S7-200): not its unit, so it says nothing');
  await bus.send('Answered.');
  await expect(heard).toContainText('Unit 33 (Modicon 984): its unit: it answers');
});

test('where a device is always late, the page says how late, and what to do', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.waitAtMost(600);
  await bus.askFor('Late reply', 'always', 900);
  const late = bus.lines.filter({ hasText: 'late reply' });
  const advice = /The device answers after \d+ ms, and the time-out is 600 ms: raise it under Transactions\./;
  for (const count of [1, 2, 3]) {
    await bus.send('No device answered: unit ');
    await expect(late).toHaveCount(count);
    await expect(page.getByText(advice)).toHaveCount(0);
  }
  await bus.tab('No answer');
  await bus.button('Send').click();
  await expect(page.getByRole('tabpanel', { name: 'No answer' })).toContainText(advice);
  await expect(late).toHaveCount(4);
  const values = await bus.pollOnce();
  await expect(values.getByRole('status')).toContainText(advice);
});

test('a reply that may be another request’s is doubtful in words, and no value', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.waitAtMost(200);
  await bus.askFor('Late reply', 'once', 60_000);
  await bus.send('No device answered: unit ');
  await bus.take('rtu/request?unitId=33&functionCode=3&startAddress=998&quantity=4');
  await bus.send('Answered, but perhaps not to this request.');
  await expect(bus.reply).toContainText(
    'A request before this one was not answered in time, and this may be its reply.',
  );
  await expect(bus.lines.nth(2)).toContainText('may answer another request');
  const values = await bus.pollOnce();
  await expect(values).toContainText(
    /1 reply came that may be the answer to another request .*; its values are not counted\./,
  );
  const row = values.getByRole('row').filter({ hasText: 'Holding register 999' });
  await expect(row).toContainText('doubtful');
  await expect(row).not.toContainText(/12345|3039/);
});

test('a reply with a wrong CRC is explained', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.askFor('Wrong checksum', 'once');
  await bus.send('A whole reply came back, but its CRC is wrong.');
  await bus.button('Show the reply').click();
  await expect(bus.reply).toContainText('One bit of byte 12 is wrong');
  await expect(bus.lines.nth(1)).toContainText('wrong CRC');
  await bus.send('Answered.');
});

test('what stands in a device is changed by hand and by requests, and kept', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.openDevices();
  await bus.button('Modicon 984').click();
  const from = page.getByLabel('From address');
  await from.fill('0x3E7');
  await from.press('Enter');
  const value = page.getByLabel('Value at 999');
  await expect(value).toHaveValue('12345');
  await value.fill('70000');
  await value.press('Enter');
  await expect(page.getByText('−32768 to 65535, or 0x0000 to 0xFFFF.')).toBeVisible();
  await expect(value).toHaveValue('70000');
  await value.fill('0x1234');
  await value.press('Enter');
  await expect(value).toHaveValue('4660');
  await bus.send('Answered.');
  await expect(bus.lines.last()).toContainText('21 03 08 12 34');

  // The speed follows the reference once the drive runs.
  await bus.writeAllowed();
  await bus.button('WEG drive').click();
  for (const frame of [SET_SPEED, 'rtu/request?unitId=6&functionCode=6&address=682&value=1']) {
    await bus.take(frame);
    await bus.send('Answered.');
  }
  await bus.openDevices();
  await bus.button('WEG drive').click();
  await expect(page.getByLabel('Value at 683')).toHaveValue('4096');
  await expect(page.getByLabel('Value at 681')).toHaveValue('4096');

  const unit = page.getByLabel('Unit of Siemens S7-200 (1)');
  await unit.fill('248');
  await unit.press('Enter');
  await expect(page.getByText('A unit is 1 to 247')).toBeVisible();
  await unit.fill('0x21');
  await unit.press('Enter');
  await expect(page.getByText('Unit 33 is there more than once')).toBeVisible();
  await expect.poll(() => page.evaluate(() => localStorage['framewright.virtual-devices'])).toContain('4660');
  await page.reload();
  await bus.button('Use the virtual bus').click();
  await bus.openDevices();
  await expect(unit).toHaveValue('33');
  await page.getByLabel('Unit of Modicon 984 (5)').fill('34');
  await page.getByLabel('Unit of Modicon 984 (5)').press('Enter');
  await bus.button('Modicon 984').click();
  await from.fill('999');
  await from.press('Enter');
  await expect(value).toHaveValue('4660');
  await bus.button('Put back the first devices').click();
  await expect(unit).toHaveValue('1');
  await bus.button('Undo').click();
  await expect(unit).toHaveValue('33');
});

test('devices are added, taken off, and brought back', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open('rtu/request?unitId=2&functionCode=3&startAddress=0&quantity=1');
  await bus.waitAtMost(200);
  await bus.send('No device answered: unit 2, 03 Read Holding Registers.');
  // Why that may be, step by step.
  const why = page.getByRole('region', { name: 'No device answered: unit 2, 03 Read Holding Registers' });
  await expect(why.getByRole('listitem')).toHaveCount(8);
  await expect(why.getByText('This request cannot be shorter.')).toBeVisible();
  await why.getByRole('button', { name: 'Look for an echo' }).click();
  await expect(why.getByText('Nothing came back, not even the request')).toBeVisible();
  await expect(page).toHaveURL(/#bus\?tab=no-answer/);
  await bus.openDevices();
  await page.getByLabel('Add a device').selectOption({ label: 'Plain device, 1000 addresses of each kind' });
  await bus.button('Add').click();
  await expect(page.getByLabel('Value at 0', { exact: true })).toHaveValue('0');
  await bus.send('Answered.');
  const power = page.getByLabel('Unit 2 has power');
  await power.uncheck();
  await bus.send('No device answered: unit ');
  await power.check();
  await bus.send('Answered.');
  await bus.button('Remove Plain device, 1000 addresses of each kind, unit 2').click();
  await bus.send('No device answered: unit ');
  await bus.button('Undo').click();
  await bus.send('Answered.');
});
