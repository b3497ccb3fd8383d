import { Bus } from './harness/bus.ts';
import { openedChooser } from './harness/chooser.ts';
import { CH340, expect, test } from './harness/fixtures.ts';

const REQUEST = '01 03 00 0A 00 02 E4 09';
const REPLY = '01 03 04 03 F2 03 F3 1B 31';

test('an adapter is pulled out while idle and while waiting, and is there again when it is put in', async ({
  page,
  plugAdapter,
}) => {
  const bus = new Bus(page);
  const adapter = await plugAdapter();
  await bus.hold(REQUEST);
  await bus.unfold();
  await bus.setting('Time-out (ms)').fill('20000');
  await bus.choose();
  await bus.ask(REQUEST, REPLY);

  await adapter.pullOut();
  await expect(bus.status).toContainText('FTDI FT232R was pulled out. Plug it in again');
  await expect(bus.button('Connect to FTDI FT232R')).toBeHidden();
  await adapter.plugIn();
  await bus.reopen('FTDI FT232R');
  await bus.ask(REQUEST, REPLY);

  // Unit 9 is not there, so it is waited for.
  await bus.hold('09 03 00 00 00 01 85 42');
  await bus.button('Send').click();
  await expect(bus.result).toContainText('Sent, waiting for the reply…');
  await adapter.pullOut();
  await expect(bus.result).toContainText('The adapter was lost meanwhile.');
  await expect(bus.status).toContainText('FTDI FT232R was pulled out.');
  await adapter.plugIn();
  await bus.reopen('FTDI FT232R');
  await bus.ask(REQUEST, REPLY);
});

test('an adapter without serial number is chosen again when it was pulled out', async ({ page, plugAdapter }) => {
  const bus = new Bus(page);
  const adapter = await plugAdapter(CH340);
  await bus.hold(REQUEST);
  await bus.choose();
  await adapter.pullOut();
  await expect(bus.status).toContainText('WCH CH340 was pulled out.');
  await expect(bus.status).toContainText('An adapter without a serial number has to be chosen in the list again.');
  await adapter.plugIn();
  await expect(bus.connection.getByRole('button')).toHaveText(['Connect…', 'Use the virtual bus']);
  await bus.choose();
  await bus.ask(REQUEST, REPLY);
});

test('of two adapters the one that was chosen is used, of different kinds and of the same', async ({
  page,
  plugAdapter,
}) => {
  const bus = new Bus(page);
  // Units 1 and 2 hold the same registers, and each answers at its own adapter only.
  const first = await plugAdapter();
  const other = await plugAdapter({ ...CH340, serial: 'C1', unit: 2 });
  const ofUnit2 = ['02 03 00 00 00 01 84 39', '02 03 02 03 E8 FC FA'] as const;
  await bus.hold(REQUEST);
  await bus.button('Connect…').click();
  const chooser = await openedChooser();
  await expect.poll(chooser.rows).toBe(2);
  await chooser.pick(0);
  await expect(bus.status).toContainText('Connected to FTDI FT232R');
  await bus.ask(REQUEST, REPLY);
  await bus.disconnect();
  await bus.choose(1);
  await expect(bus.status).toContainText('Connected to WCH CH340');
  await bus.ask(...ofUnit2);
  await bus.disconnect();

  await first.pullOut();
  await expect(bus.button('Connect to FTDI FT232R')).toBeHidden();
  await bus.setting('Speed (baud)').fill('115200');
  const twin = await plugAdapter({ ...CH340, serial: 'C2' });
  await bus.choose(1);
  await expect(bus.connection).toContainText('Two adapters of the same kind are plugged in');
  await expect.poll(twin.cable.settings).toBe('115200 even 1 none');
  await expect.poll(other.cable.settings).toBe('19200 even 1 none');
  await bus.ask(REQUEST, REPLY);
  await bus.disconnect();
  await expect(bus.button('Connect to WCH CH340')).toHaveCount(2);
});
