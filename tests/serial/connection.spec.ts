import { test as bare } from '@playwright/test';
import { Bus } from './harness/bus.ts';
import { openedChooser } from './harness/chooser.ts';
import { CH340, expect, test } from './harness/fixtures.ts';

/** Reads register 10 and 11, which are 1010 and 1011. */
const REQUEST = '01 03 00 0A 00 02 E4 09';
const REPLY = '01 03 04 03 F2 03 F3 1B 31';

test('a port is chosen, opened in every format, and answers in each', async ({ page, plugAdapter }) => {
  const bus = new Bus(page);
  const { cable } = await plugAdapter();
  await bus.hold(REQUEST);
  await expect(bus.status).toContainText('Not connected.');
  await bus.setting('Speed (baud)').fill('9600');
  await bus.choose();
  await expect(bus.status).toContainText('Connected to FTDI FT232R, 9600 baud, 8E1.');
  await expect.poll(cable.settings).toBe('9600 even 1 none');
  await bus.ask(REQUEST, REPLY);
  await expect(bus.lines).toHaveCount(2);
  await expect(bus.lines.nth(1)).toContainText('reply');

  const formats = [
    { baud: '19200', parity: 'none', stopBits: '1', is: '19200 baud, 8N1.', cable: '19200 none 1 none' },
    { baud: '0x9600', parity: 'none', stopBits: '2', is: '38400 baud, 8N2.', cable: '38400 none 2 none' },
    { baud: '115200', parity: 'odd', stopBits: '1', is: '115200 baud, 8O1.', cable: '115200 odd 1 none' },
  ];
  for (const [index, format] of formats.entries()) {
    await bus.disconnect();
    await bus.setting('Speed (baud)').fill(format.baud);
    await bus.setting('Parity').selectOption(format.parity);
    await bus.setting('Stop bits').selectOption(format.stopBits);
    await bus.reopen('FTDI FT232R');
    await expect(bus.status).toContainText(`Connected to FTDI FT232R, ${format.is}`);
    await expect.poll(cable.settings).toBe(format.cable);
    await bus.button('Send').click();
    await expect(bus.lines).toHaveCount(2 * (index + 2));
    await expect(bus.reply).toContainText(REPLY);
  }
});

test('the list is cancelled, lines of the adapter cannot be set, and a reloaded page offers the port first', async ({
  page,
  plugAdapter,
}) => {
  const bus = new Bus(page);
  await plugAdapter();
  await bus.hold(REQUEST);
  await bus.button('Connect…').click();
  await (await openedChooser()).cancel();
  await expect(bus.status).toContainText('No port was chosen. Connect again');
  await bus.choose();

  // A pseudo-terminal has no such lines, as some adapters.
  await bus.unfold();
  await page.getByText('Lines of the adapter').click();
  await page.getByLabel('DTR').check();
  await expect(bus.connection).toContainText('This adapter has no such lines, or does not let them be set.');
  await bus.ask(REQUEST, REPLY);

  await page.reload();
  await expect(bus.status).toContainText('Not connected.');
  await expect(bus.connection.getByRole('button')).toHaveText([
    'Connect to FTDI FT232R',
    'Choose another port…',
    'Use the virtual bus',
  ]);
  await bus.reopen('FTDI FT232R');
  await bus.ask(REQUEST, REPLY);
});

// The browser itself writes into the console here, so this is not the test whose console must be silent.
bare('a policy forbids the list of ports', async ({ page }) => {
  const bus = new Bus(page);
  await page.route('**/*', async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, headers: { ...response.headers(), 'permissions-policy': 'serial=()' } });
  });
  await page.goto('/#bus');
  await page.reload();
  await bus.button('Connect…').click();
  await expect(bus.status).toContainText('The browser did not show its list of ports. Serial ports may be blocked');
});

test('a port that does not open says why, and opens once it can', async ({ page, plugAdapter }) => {
  const bus = new Bus(page);
  // What a page sees of a port that another program has: it is in the list, and does not open.
  const adapter = await plugAdapter({ ...CH340, serial: 'S1' });
  await adapter.cable.cut();
  await bus.hold(REQUEST);
  await bus.button('Connect…').click();
  await (await openedChooser()).pick();
  await expect(bus.status).toContainText('WCH CH340 is there, but does not open. Another program');
  await adapter.pullOut();
  await adapter.plugIn();
  await bus.reopen('WCH CH340');
  await bus.ask(REQUEST, REPLY);
});
