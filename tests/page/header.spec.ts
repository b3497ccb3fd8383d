import { expect, test } from './page.ts';

test('a device that is chosen sets the line of the wire, the timing and the bus', async ({ page }) => {
  await page.goto('./#rtu/request?unitId=6&functionCode=6');
  const header = page.getByRole('banner');
  const line = header.getByRole('button', { name: /^Serial line/ });
  await expect(line).toHaveText('19200 8E1');
  await header.getByRole('button', { name: /^Chosen device/ }).click();
  const devices = page.getByRole('dialog', { name: /^Chosen device/ });
  await expect(devices.getByRole('searchbox')).toBeFocused();
  await page.keyboard.type('weg');
  await page.keyboard.press('Enter');
  await expect(devices).toBeHidden();
  await expect(header.getByRole('button', { name: 'Chosen device: WEG drive' })).toBeFocused();
  await expect(line).toHaveText('9600 8N1');

  await page.getByRole('tab', { name: 'On the wire' }).click();
  await expect(page.getByLabel('Speed, bit/s')).toHaveValue('9600');
  await page.getByLabel('Speed, bit/s').fill('38400');
  await expect(line).toHaveText('38400 8N1');
  await header.getByRole('link', { name: 'Timing' }).click();
  await expect(page.getByLabel('Speed, bits a second')).toHaveValue('38400');

  await line.click();
  const setting = page.getByRole('dialog', { name: /^Serial line/ });
  await setting.getByRole('button', { name: 'Use it' }).click();
  await expect(page.getByLabel('Speed, bits a second')).toHaveValue('9600');
  await page.keyboard.press('Escape');
  await expect(setting).toBeHidden();
  await header.getByRole('link', { name: /Not connected/ }).click();
  await page
    .getByRole('button', { name: /virtual bus/ })
    .first()
    .click();
  await expect(header.getByRole('link', { name: 'Virtual bus' })).toBeVisible();
  await expect(page.getByText(/Connected to the virtual bus, 9600 baud, 8N1/).first()).toBeVisible();
});

test('one line, wherever it is shown, whoever sets it: a device, a link, or a hand', async ({ page }) => {
  const header = page.getByRole('banner');
  const line = header.getByRole('button', { name: /^Serial line/ });
  const choose = async (device: string) => {
    await header.getByRole('button', { name: /^Chosen device/ }).click();
    await page
      .getByRole('dialog', { name: /^Chosen device/ })
      .getByRole('button', { name: device })
      .first()
      .click();
  };
  const setting = page.getByRole('group', { name: 'Speed and format' });
  /** The same speed and parity in the header, on the wire, in the timing and in what the bus opens a port with. */
  const expectEverywhere = async (baud: string, format: string, parity: string) => {
    await expect(line).toHaveText(`${baud} ${format}`);
    await header.getByRole('link', { name: 'Frame', exact: true }).click();
    await page.getByRole('tab', { name: 'On the wire' }).click();
    await expect(page.getByLabel('Speed, bit/s')).toHaveValue(baud);
    await header.getByRole('link', { name: 'Timing' }).click();
    await expect(page.getByLabel('Speed, bits a second')).toHaveValue(baud);
    await header.getByRole('link', { name: 'Bus', exact: true }).click();
    await expect(setting.getByLabel('Speed (baud)')).toHaveValue(baud);
    await expect(setting.getByLabel('Parity')).toHaveValue(parity);
  };
  await page.goto('./#rtu/request?unitId=6&functionCode=6');
  await expectEverywhere('19200', '8E1', 'even');
  await choose('WEG drive');
  await expectEverywhere('9600', '8N1', 'none');
  await choose('None');
  await expectEverywhere('19200', '8E1', 'even');
  await setting.getByLabel('Speed (baud)').fill('38400');
  await expectEverywhere('38400', '8E1', 'even');
  // What is set by hand stays when no other device is chosen, and gives way to the next device.
  await choose('WEG drive');
  await expectEverywhere('9600', '8N1', 'none');
  await page.evaluate(() => {
    location.hash = 'rtu/request?v=3&unitId=6&functionCode=6&line=57600-8O1';
  });
  await expectEverywhere('57600', '8O1', 'odd');
});

test('a sheet is printed: the frame, its bytes, the waveform, the link', async ({ page }) => {
  await page.goto('./#rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3');
  await expect(page.getByRole('tab', { name: 'Bytes' })).toBeVisible();
  // What stands in the page at the time that it is printed.
  const printed = page.evaluate(
    () =>
      new Promise<readonly (string | null | undefined)[]>((resolve) => {
        globalThis.print = () => {
          const sheet = document.querySelector('.print-sheet');
          resolve([sheet?.textContent, sheet?.querySelector('table')?.textContent, sheet?.querySelector('svg')?.role]);
        };
      }),
  );
  await page.keyboard.press('Control+p');
  expect(await printed).toEqual([
    expect.stringMatching(/11 03 00 6B 00 03 76 87.*#rtu\/request\?/s),
    expect.stringContaining('Function code'),
    'img',
  ]);
});
