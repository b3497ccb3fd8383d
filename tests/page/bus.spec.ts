import { Bus, READ_33, SET_SPEED } from '../browser/bus-view.ts';
import { expect, test } from './page.ts';

test('a request is sent on the virtual bus, and its device answers', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.send('Answered.');
  // The reply that the Chinese source prints.
  await expect(bus.reply).toContainText('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18');
  await expect(bus.lines).toHaveCount(2);
  await expect(bus.lines.nth(1)).toContainText('41000 = 12345');
  await bus.button('Disconnect').click();
  await expect(bus.status).toContainText('Not connected.');
});

test('where the browser has no Web Serial, the virtual bus is what is offered', async ({ page }) => {
  await page.addInitScript(() => {
    Reflect.deleteProperty(Navigator.prototype, 'serial');
  });
  const bus = new Bus(page);
  await page.goto(`./#${READ_33}`);
  await page.getByRole('link', { name: 'Bus', exact: true }).click();
  await expect(bus.status).toContainText('This browser has no Web Serial');
  await expect(bus.button('Connect…')).toHaveCount(0);
  await bus.open(READ_33);
  await bus.send('Answered.');
});

test('nothing is written while “Read only” is on, but what is allowed once; the virtual bus asks no question', async ({
  page,
}) => {
  const bus = new Bus(page);
  await bus.open(SET_SPEED);
  await expect(page.getByLabel('Read only')).toHaveAccessibleDescription(
    /^Allowed: 01, 02, 03, 04, .*; of 08, 2B what/,
  );
  await bus.send('Not sent: it may change something in a device');
  await expect(bus.lines).toHaveCount(0);
  await bus.button('Send this one').click();
  await expect(bus.result).toContainText('Answered.');
  await expect(bus.lines).toHaveCount(2);
  await bus.send('Not sent: it may change something in a device');
  await expect(bus.lines).toHaveCount(2);

  await bus.writeAllowed();
  await bus.send('Answered.');
  await expect(bus.lines).toHaveCount(4);
  await bus.take('rtu/request?unitId=0&functionCode=6&address=683&value=0');
  // What was said of the other frame is not said of this one.
  await expect(bus.result).not.toContainText('Answered.');
  await expect(bus.reply).toContainText('To: 06 Write Single Register, unit 6');
  await bus.send('No device answers this request.');
  await expect(bus.question).toHaveCount(0);
  await expect(bus.lines).toHaveCount(5);
});

test('a device refuses what it does not have', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open('rtu/request?unitId=6&functionCode=3&startAddress=9&quantity=1');
  await bus.send('The device refused the request: exception 02, ILLEGAL DATA ADDRESS (');
  await expect(bus.reply).toContainText('06 83 02');
  await expect(bus.lines.nth(1)).toContainText('exception 02, ILLEGAL DATA ADDRESS');
});

test('the quiet after a time-out is on at first, says what it costs, and is kept', async ({ page }) => {
  await page.goto('./');
  await page.getByRole('link', { name: 'Bus', exact: true }).click();
  const quiet = page.getByRole('checkbox', { name: 'Quiet after a time-out' });
  await expect(quiet).toBeChecked();
  await expect(quiet).toHaveAccessibleDescription(/waits until that reply has come, at most 1000 ms more\./);
  await page.getByLabel('Time-out (ms)').fill('250');
  await expect(quiet).toHaveAccessibleDescription(/at most 250 ms more\./);
  await quiet.uncheck();
  await page.reload();
  await expect(quiet).not.toBeChecked();
  await expect(quiet).toHaveAccessibleDescription(/at most 250 ms more\./);
});

test('what no device answers opens its steps with the focus, but the caret stays where somebody types', async ({
  page,
}) => {
  const bus = new Bus(page);
  await bus.open('rtu/request?unitId=5&functionCode=3&startAddress=0&quantity=4');
  await bus.waitAtMost(100);
  await bus.send('No device answered: unit 5');
  await expect(page.getByRole('heading', { name: /^No device answered/ })).toBeFocused();

  await bus.tab('Reply');
  const search = bus.log.getByRole('combobox');
  await search.fill('05');
  await page.keyboard.press('Control+Enter');
  await expect(page.getByRole('tab', { name: 'No answer' })).toHaveAttribute('aria-selected', 'true');
  await expect(bus.result.getByText('Steps to find out why stand in the tab “No answer”.')).toBeAttached();
  await expect(search).toBeFocused();
});
