import type { Page } from '@playwright/test';
import { openedChooser } from './harness/chooser.ts';
import { expect, test } from './harness/fixtures.ts';

/** The Bus view as a person meets it. */
class Bus {
  readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  get status() {
    return this.page.getByRole('region', { name: 'Connection' }).getByRole('status');
  }
  button(name: string | RegExp) {
    return this.page.getByRole('button', { name });
  }
  get result() {
    return this.page.getByRole('region', { name: 'Frame at hand' });
  }
  get log() {
    return this.page.getByRole('region', { name: 'Log' });
  }

  /** Makes a frame the one at hand, and opens the view. */
  async open(frame: string): Promise<void> {
    await this.page.goto(`/#${frame}`);
    await this.page.getByRole('link', { name: 'Bus' }).click();
  }

  async choose(row = 0): Promise<void> {
    await this.button('Connect …').click();
    const chooser = await openedChooser();
    await chooser.pick(row);
    await expect(this.status).toContainText('Connected to');
  }
}

test('a port is chosen, a request is sent, and libmodbus answers', async ({ page, plugAdapter }) => {
  const bus = new Bus(page);
  const { cable } = await plugAdapter();
  await bus.open('rtu/request?unitId=1&functionCode=3&startAddress=10&quantity=2');
  await expect(bus.status).toContainText('Not connected.');
  await bus.page.getByLabel('Speed (baud)').fill('9600');
  await bus.choose();
  await expect(bus.status).toContainText('Connected to FTDI FT232R, 9600 baud, 8E1.');
  expect(cable.settings()).toBe('9600 even 1 none');
  await bus.button('Send').click();
  await expect(bus.result).toContainText('Answered.');
  await expect(bus.result).toContainText('01 03 04 03 F2 03 F3 1B 31');
  await expect(bus.log.getByRole('listbox').getByRole('option')).toHaveCount(2);
  await expect(bus.log.getByRole('listbox').getByRole('option').first()).toContainText('good');
  await bus.button('Disconnect').click();
  await expect(bus.status).toContainText('Not connected.');
});
