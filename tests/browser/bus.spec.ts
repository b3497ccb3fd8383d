import { readFile } from 'node:fs/promises';
import type { Locator, Page } from '@playwright/test';
import type { LogLine } from '../../src/bus/index.ts';
import { readCapture, writeTraceJson } from '../../src/captures/index.ts';
import { recordsOfLines } from '../../src/workbench/index.ts';
import { AxeBuilder } from './axe.ts';
import { allCame, expect, test } from './page.ts';

const READ_33 = 'rtu/request?unitId=33&functionCode=3&startAddress=999&quantity=4';
const SET_SPEED = 'rtu/request?unitId=6&functionCode=6&address=683&value=4096';

/** The Bus view on the virtual bus, as a person meets it. */
class Bus {
  readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  get status() {
    return this.page.getByRole('region', { name: 'Connection' }).getByRole('status');
  }
  get result() {
    return this.page.getByRole('region', { name: 'Current frame' });
  }
  /** What is said of the reply that came last. */
  get reply() {
    return this.page.getByRole('region', { name: 'Last reply' });
  }
  get log() {
    return this.page.getByRole('region', { name: 'Log' });
  }
  get lines() {
    return this.log.getByRole('listbox', { name: /(frame|exchange)s?$/ }).getByRole('option');
  }
  get question() {
    return this.page.getByRole('dialog', { name: 'Send this request?' });
  }
  button(name: string | RegExp) {
    return this.page.getByRole('button', { name, exact: typeof name === 'string' });
  }

  /** Makes a frame the one at hand, and connects to the virtual bus. */
  async open(frame: string): Promise<void> {
    await this.page.goto(`./#${frame}`);
    await this.page.getByRole('link', { name: 'Bus', exact: true }).click();
    await this.page.getByLabel('Speed of the virtual bus').selectOption('fast');
    await this.button('Use the virtual bus').click();
    await expect(this.status).toContainText('Connected to the virtual bus, 19200 baud, 8E1.');
  }

  /** Makes another frame the one at hand while the bus stays as it is. */
  async take(frame: string): Promise<void> {
    await this.page.evaluate((hash) => {
      location.hash = hash;
    }, frame);
    await this.page.getByRole('link', { name: 'Bus', exact: true }).click();
    await expect(this.result).toBeVisible();
  }

  async send(said: string): Promise<void> {
    await this.button('Send').click();
    await expect(this.result).toContainText(said);
  }

  async writeAllowed(): Promise<void> {
    await this.page.getByLabel('Read only').uncheck();
  }

  async tab(name: string): Promise<void> {
    await this.page.getByRole('tablist', { name: 'What to do on the line' }).getByRole('tab', { name }).click();
  }

  /** Sets how long a reply is waited for; the settings are folded away while there is a connection. */
  async waitAtMost(milliseconds: number): Promise<void> {
    await this.button('Change').click();
    await this.page.getByLabel('Time-out (ms)').fill(String(milliseconds));
    await this.button('Change').click();
  }

  async openDevices(): Promise<void> {
    await this.tab('Virtual devices');
    await expect(this.page.getByRole('heading', { name: 'Devices on the line' })).toBeVisible();
  }

  /** Asks for a fault of every device; a late reply is late by so many milliseconds. */
  async askFor(fault: string, often: 'once' | 'always', late?: number): Promise<void> {
    await this.openDevices();
    await this.page.getByLabel('What goes wrong').selectOption({ label: fault });
    await this.page.getByLabel('How often').selectOption(often);
    if (late !== undefined) {
      await this.page.getByLabel('Late by (ms)').fill(String(late));
      await this.page.getByLabel('Late by (ms)').press('Enter');
    }
    await this.button('Ask for this fault').click();
  }

  /** Polls the current frame for one round, and returns what was read. */
  async pollOnce(): Promise<Locator> {
    await this.tab('Poll');
    await this.page.getByLabel('Interval (ms)').fill('60000');
    await this.button('Start').click();
    const values = this.page.getByRole('region', { name: /^Values: / });
    await expect(values).toContainText('1 round.');
    return values;
  }
}

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

test('a fault asked for once happens once, and who heard the frame is shown', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
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

test('the quiet after a time-out is on at first, says what it costs, and is kept', async ({ page }) => {
  await page.goto('./');
  await page.getByRole('link', { name: 'Bus', exact: true }).click();
  const quiet = page.getByRole('checkbox', { name: 'Quiet after a time-out' });
  await expect(quiet).toBeChecked();
  await expect(quiet).toHaveAccessibleDescription(/waits until that reply has come, at most 1000 ms more\./);
  const rules = page.getByRole('group', { name: 'Transactions' });
  const hint = rules.getByText('A request that a late reply could answer');
  for (const width of [1280, 390]) {
    await page.setViewportSize({ width, height: 900 });
    const [whole, above, below] = await Promise.all([rules, quiet, hint].map((one) => one.boundingBox()));
    expect(below!.y).toBeGreaterThanOrEqual(above!.y + above!.height);
    expect(below!.width).toBeGreaterThan(0.8 * whole!.width);
  }
  await page.getByLabel('Time-out (ms)').fill('250');
  await expect(quiet).toHaveAccessibleDescription(/at most 250 ms more\./);
  await quiet.uncheck();
  await page.reload();
  await expect(quiet).not.toBeChecked();
  await expect(quiet).toHaveAccessibleDescription(/at most 250 ms more\./);
});

test('where a device is always late, the page says how late, and what to do', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.waitAtMost(600);
  await bus.askFor('Late reply', 'always', 900);
  const advice = /The device answers after \d+ ms, and the time-out is 600 ms: raise it under Transactions\./;
  for (const count of [1, 2, 3]) {
    await bus.send('No device answered: unit ');
    await expect(bus.lines.filter({ hasText: 'late reply' })).toHaveCount(count);
    await expect(page.getByText(advice)).toHaveCount(0);
  }
  await bus.tab('No answer');
  await bus.button('Send').click();
  await expect(page.getByRole('tabpanel', { name: 'No answer' })).toContainText(advice);
  const values = await bus.pollOnce();
  await expect(values.getByRole('status')).toContainText(advice);
});

test('a reply that may be another request’s is doubtful in words, and no value', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
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
  await bus.send('No device answered: unit 2, 03 Read Holding Registers.');
  // Why that may be, step by step.
  const why = page.getByRole('region', { name: 'No device answered: unit 2, 03 Read Holding Registers' });
  await expect(why.getByRole('listitem')).toHaveCount(8);
  await expect(why.getByText('This request cannot be shorter.')).toBeVisible();
  await why.getByRole('button', { name: 'Look for an echo' }).click();
  await expect(why.getByText('Nothing came back, not even the request')).toBeVisible();
  await expect(page).toHaveURL(/#bus\?tab=no-answer/);
  expect(await new AxeBuilder(page).findings('.no-answer')).toEqual([]);
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
  expect(await new AxeBuilder(page).findings()).toEqual([]);
  await page.setViewportSize({ width: 390, height: 844 });
  await bus.tab('Reply');
  await bus.lines.nth(1).click();
  await expect(panel.getByRole('button', { name: 'Request', exact: true })).toBeInViewport();
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
});

test('the view has no fault that axe knows, light and dark, also at 320 px', async ({ page }) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.openDevices();
  await bus.button('Ask for this fault').click();
  await bus.button('Ask for this fault').click();
  await bus.waitAtMost(100);
  await bus.send('No device answered: unit ');
  await expect(page.getByRole('region', { name: 'Who hears what' })).toContainText('Unit 33');
  await expect(page.getByLabel('Value at 0', { exact: true })).toBeVisible();
  const axe = new AxeBuilder(page);
  expect(await axe.findings()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await axe.findingsOfColours()).toEqual([]);
  await page.setViewportSize({ width: 320, height: 700 });
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320);
  expect(await axe.findings()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'light' });
  expect(await axe.findingsOfColours()).toEqual([]);
});

for (const [width, height] of [
  [1280, 720],
  [1400, 900],
] as const) {
  test(`at ${width} × ${height} the newest reply, the checklist and the log are in sight after Send, and nothing moves the log`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height });
    const bus = new Bus(page);
    await bus.open(READ_33);
    await allCame(page);
    const top = async () => (await bus.log.boundingBox())!.y;
    const before = await top();
    await bus.send('Answered.');
    await expect(bus.reply.getByText('Answered.')).toBeInViewport({ ratio: 1 });
    await expect(bus.reply.getByText('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18')).toBeInViewport({ ratio: 1 });
    expect(await top()).toBe(before);
    // An eight-byte frame is not cut.
    const hex = bus.lines.first().getByText('21 03 03 E7 00 04 F3 1A');
    await expect(hex).toBeInViewport({ ratio: 1 });
    expect(await hex.evaluate((element) => element.scrollWidth <= element.clientWidth)).toBe(true);
    await bus.take('rtu/request?unitId=5&functionCode=3&startAddress=0&quantity=4');
    await bus.send('No device answered: unit 5');
    const heading = page.getByRole('heading', { name: /^No device answered/ });
    await expect(heading).toBeInViewport({ ratio: 1 });
    await expect(heading).toBeFocused();
    await expect(bus.button('Try units 1–247')).toBeInViewport({ ratio: 1 });
    expect(await top()).toBe(before);
    expect(await page.evaluate(() => scrollY)).toBe(0);
  });
}

test('on a phone the checklist comes into sight with the focus, but the caret stays where somebody types', async ({
  page,
}) => {
  await page.setViewportSize({ width: 390, height: 844 });
  const bus = new Bus(page);
  await bus.open('rtu/request?unitId=5&functionCode=3&startAddress=0&quantity=4');
  await bus.waitAtMost(100);
  await bus.send('No device answered: unit 5');
  const heading = page.getByRole('heading', { name: /^No device answered/ });
  await expect(heading).toBeFocused();
  await expect(heading).toBeInViewport({ ratio: 1 });
  await expect(bus.button('Try units 1–247')).toBeInViewport({ ratio: 1 });

  await bus.tab('Reply');
  const search = bus.log.getByRole('combobox');
  await search.fill('05');
  await page.keyboard.press('Control+Enter');
  await expect(page.getByRole('tab', { name: 'No answer' })).toHaveAttribute('aria-selected', 'true');
  await expect(bus.result.getByText('Steps to find out why stand in the tab “No answer”.')).toBeAttached();
  await expect(search).toBeFocused();
  await expect(search).toBeInViewport();
});

test('a thousand lines stand: a reply is shown at once, and each tab is as it was left', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 720 });
  const bus = new Bus(page);
  // As if they had come before the page was loaded again.
  const lines = Array.from({ length: 1000 }, (_, n): LogLine => {
    const time = Date.UTC(2026, 0, 1) + 20 * n;
    return n % 2 === 0
      ? { time, direction: 'sent', transport: 'rtu', kind: 'request', hex: '210303E70004F31A' }
      : { time, direction: 'received', transport: 'rtu', kind: 'reply', hex: '2103083039D4311A0A22B8C418' };
  });
  await page.addInitScript(
    (log) => sessionStorage.setItem('framewright.bus-log', log),
    writeTraceJson(recordsOfLines(lines)),
  );
  await bus.open(READ_33);
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
  const red = await stop.evaluate((element) => getComputedStyle(element).backgroundColor);
  expect(red).toBe(
    await page.evaluate(() => {
      const swatch = Object.assign(document.createElement('i'), { style: 'background: var(--bad)' });
      document.body.append(swatch);
      const color = getComputedStyle(swatch).backgroundColor;
      swatch.remove();
      return color;
    }),
  );
  await expect(bus.log.getByRole('button', { name: /^\d,\d{3} frames/ })).toBeVisible();

  for (const name of ['Scan', 'Listen', 'Sequence', 'Virtual devices']) await bus.tab(name);
  await expect(page.getByLabel('What goes wrong')).toHaveValue('late');
  await bus.tab('Sequence');
  await expect(page.getByLabel('Name', { exact: true })).toHaveValue('Mine');
  await bus.tab('Scan');
  await expect(page.getByLabel('First unit')).toHaveValue('5');
  await bus.tab('Poll');
  await expect(panel('Poll').locator('canvas')).toBeVisible();
  await expect(panel('Poll')).toContainText('Polling.');
  await stop.click();
  await expect(page.getByLabel('Interval (ms)')).toHaveValue('50');

  await bus.tab('Reply');
  await bus.send('Answered.');
  await expect(bus.reply.getByText('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18')).toBeInViewport({ ratio: 1 });
  await expect(bus.lines.last()).toContainText('41000 = 12345');
});

test('leaving asks first while a job runs, and the log is there when the page is loaded again', async ({ page }) => {
  const asked: string[] = [];
  page.on('dialog', (dialog) => {
    asked.push(dialog.type());
    void dialog.accept();
  });
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.tab('Poll');
  await bus.button('Start').click();
  await expect(bus.lines.nth(3)).toBeVisible();
  await page.reload();
  expect(asked).toEqual(['beforeunload']);
  await expect(bus.log).toContainText(/\d+ frames from before the page was loaded again\./);
  await expect(bus.lines.nth(1)).toContainText('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18');
  await page.reload();
  expect(asked).toHaveLength(1);
  await expect(bus.lines.nth(1)).toContainText('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18');
});

test('the chart is drawn where the browser says that its language is C', async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(Navigator.prototype, 'language', { get: () => 'C', configurable: true });
    Object.defineProperty(Navigator.prototype, 'languages', { get: () => ['C'], configurable: true });
  });
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.tab('Poll');
  await page
    .locator('.poll')
    .getByRole('button', { name: /^(Poll|Start)/ })
    .click();
  await expect(page.locator('.poll canvas')).toBeVisible();
});
