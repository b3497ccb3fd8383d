import { expect, type Locator, type Page } from '@playwright/test';
import { recordsOfLines, writeTraceJson } from '#known';
import type { LogLine } from '../../src/bus/index.ts';

export const READ_33 = 'rtu/request?unitId=33&functionCode=3&startAddress=999&quantity=4';
export const SET_SPEED = 'rtu/request?unitId=6&functionCode=6&address=683&value=4096';

/** The Bus view on the virtual bus, as a person meets it. */
export class Bus {
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

  /** Connects as `open` does, on a page whose log has a thousand lines from before it was loaded again. */
  async openWithThousandLines(): Promise<void> {
    const lines = Array.from({ length: 1000 }, (_, n): LogLine => {
      const time = Date.UTC(2026, 0, 1) + 20 * n;
      return n % 2 === 0
        ? { time, direction: 'sent', transport: 'rtu', kind: 'request', hex: '210303E70004F31A' }
        : { time, direction: 'received', transport: 'rtu', kind: 'reply', hex: '2103083039D4311A0A22B8C418' };
    });
    await this.page.addInitScript(
      (log) => sessionStorage.setItem('framewright.bus-log', log),
      writeTraceJson(recordsOfLines(lines)),
    );
    await this.open(READ_33);
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
