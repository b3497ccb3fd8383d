import { readAsClient } from './harness/cable.ts';
import { openedChooser } from './harness/chooser.ts';
import { expect, test } from './harness/fixtures.ts';

for (const [what, options] of [
  ['a cable', {}],
  ['a paced cable with lumps of 16 ms', { pace: true, lump: 16 }],
  ['an adapter that echoes', { echo: true }],
] as const) {
  test(`the virtual devices answer libmodbus on ${what}`, async ({ page, plugAdapter }) => {
    const { cable } = await plugAdapter({ ...options, unit: null });
    await page.goto('/#rtu/request?unitId=33&functionCode=3&startAddress=999&quantity=4');
    await page.getByRole('link', { name: 'Bus', exact: true }).click();
    const button = (name: string) => page.getByRole('button', { name, exact: true });
    await page.getByLabel('Speed (baud)').fill('9600');
    await page.getByLabel('Parity').selectOption('none');
    await page.getByText('Virtual devices', { exact: true }).click();
    await expect(button('Answer what arrives on the adapter')).toBeDisabled();
    await button('Connect …').click();
    await (await openedChooser()).pick(0);
    await button('Answer what arrives on the adapter').click();
    await expect(button('Stop answering')).toBeVisible();

    expect(readAsClient(cable.device, 33, 999, 4)).toBe('12345 54321 6666 8888');
    expect(readAsClient(cable.device, 1, 0, 5)).toBe('10 20 30 40 50');
    const log = page.getByRole('region', { name: 'Log' }).getByRole('listbox').getByRole('option');
    await expect(log.filter({ hasText: 'Request' })).toHaveCount(2);
    await expect(log.filter({ hasText: '21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18' }).first()).toContainText('Reply');
    await expect(page.getByRole('region', { name: 'Who hears what' })).toContainText(
      'Unit 1 (Siemens S7-200): its unit',
    );

    await button('Send').click();
    await expect(page.getByRole('region', { name: 'Frame at hand' })).toContainText('another asks');
    await button('Stop answering').click();
    await expect(button('Answer what arrives on the adapter')).toBeVisible();
  });
}
