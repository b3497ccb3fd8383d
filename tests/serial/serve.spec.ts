import { readAsClient } from './harness/cable.ts';
import { openedChooser } from './harness/chooser.ts';
import { expect, test } from './harness/fixtures.ts';

// libmodbus opens one end of a pseudo-terminal once only: each cable is read from once.
for (const { what, options, unit, address, quantity, reads, answer } of [
  {
    what: 'on a cable',
    options: {},
    unit: 33,
    address: 999,
    quantity: 4,
    reads: '12345 54321 6666 8888',
    answer: '21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18',
  },
  {
    what: 'at 9600 baud, through an adapter that hands over every 16 ms',
    options: { pace: true, lump: 16 },
    unit: 1,
    address: 0,
    quantity: 5,
    reads: '10 20 30 40 50',
    answer: '01 03 0A 00 0A 00 14 00 1E 00 28 00 32',
  },
  {
    what: 'through an adapter that echoes',
    options: { echo: true },
    unit: 17,
    address: 0x6b,
    quantity: 3,
    reads: '555 0 100',
    answer: '11 03 06 02 2B 00 00 00 64',
  },
  {
    what: 'that asks for what a device does not have',
    options: {},
    unit: 6,
    address: 9,
    quantity: 1,
    reads: 'Illegal data address',
    answer: '06 83 02 71 30',
  },
]) {
  test(`the virtual devices answer libmodbus ${what}`, async ({ page, plugAdapter }) => {
    const { cable } = await plugAdapter({ ...options, unit: null });
    await page.goto('/#rtu/request?unitId=33&functionCode=3&startAddress=999&quantity=4');
    await page.getByRole('link', { name: 'Bus', exact: true }).click();
    const button = (name: string) => page.getByRole('button', { name, exact: true });
    await page.getByLabel('Speed (baud)').fill('9600');
    await page.getByRole('tab', { name: 'Virtual devices' }).click();
    await expect(button('Answer what arrives on the adapter')).toBeDisabled();
    await button('Connect…').click();
    await (await openedChooser()).pick(0);
    await button('Answer what arrives on the adapter').click();
    await expect(button('Stop answering')).toBeVisible();

    expect(readAsClient(cable.device, unit, address, quantity)).toBe(reads);
    const log = page.getByRole('region', { name: 'Log' }).getByRole('listbox').getByRole('option');
    await expect(log.first()).toContainText('request');
    await expect(log.nth(1)).toContainText(answer);
    await expect(page.getByRole('region', { name: 'Who hears what' })).toContainText(`Unit ${unit} (`);

    await button('Send').click();
    await expect(page.getByRole('region', { name: 'Current frame' })).toContainText('another master asks');
    await button('Stop answering').click();
    await expect(button('Answer what arrives on the adapter')).toBeVisible();
  });
}
