import { openedChooser } from './harness/chooser.ts';
import { expect, FTDI, test } from './harness/fixtures.ts';

// When this fails, look at the browser and the cable before looking at the page.
test('the rig: a port is chosen, opened as asked for, and libmodbus answers at the other end', async ({
  page,
  plugAdapter,
}) => {
  const { cable } = await plugAdapter();
  await page.evaluate(() => {
    const button = document.createElement('button');
    button.textContent = 'Ask for a port';
    button.onclick = async () => {
      const port = await navigator.serial.requestPort();
      await port.open({ baudRate: 9600, parity: 'even' });
      const writer = port.writable?.getWriter();
      // Read 2 holding registers from 10, of unit 1; 9 bytes come back.
      await writer?.write(new Uint8Array([0x01, 0x03, 0x00, 0x0a, 0x00, 0x02, 0xe4, 0x09]));
      const reader = port.readable?.getReader();
      const reply: number[] = [];
      while (reply.length < 9) reply.push(...((await reader?.read())?.value ?? []));
      document.title = `${port.getInfo().usbVendorId}: ${reply.join(' ')}`;
    };
    document.body.append(button);
  });
  await page.getByRole('button', { name: 'Ask for a port' }).click();
  const chooser = await openedChooser();
  expect(await chooser.texts()).toContain(`${new URL(page.url()).origin} wants to connect to a serial port`);
  await chooser.pick();
  // 1010 and 1011
  await expect(page).toHaveTitle(`${FTDI.vendorId}: 1 3 4 3 242 3 243 27 49`);
  await expect.poll(cable.settings).toBe('9600 even 1 none');
});
