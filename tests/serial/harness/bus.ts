import type { Page } from '@playwright/test';
import { expect } from '../../browser/page.ts';
import { openedChooser } from './chooser.ts';

/** The Bus view as a person meets it. */
export class Bus {
  readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  get connection() {
    return this.page.getByRole('region', { name: 'Connection' });
  }
  get status() {
    return this.connection.getByRole('status');
  }
  get result() {
    return this.page.getByRole('region', { name: 'Current frame' });
  }
  /** What is said of the reply that came last. */
  get reply() {
    return this.page.getByRole('region', { name: 'Last reply' });
  }
  get question() {
    return this.page.getByRole('dialog', { name: 'Send this request?' });
  }
  get lines() {
    return this.page.getByRole('region', { name: 'Log' }).getByRole('listbox').getByRole('option');
  }
  get readOnly() {
    return this.page.getByLabel('Read only: send nothing that may change a device');
  }
  button(name: string | RegExp) {
    return this.page.getByRole('button', { name });
  }
  /** The settings are folded away while there is a connection. */
  async unfold(): Promise<void> {
    const change = this.connection.getByRole('button', { name: 'Change', expanded: false });
    if (await change.isVisible()) await change.click();
  }
  setting(label: string) {
    return this.connection.getByLabel(label);
  }

  /** Makes an RTU request the current frame by typing its bytes, and goes to this view. */
  async hold(request: string): Promise<void> {
    await this.page.getByRole('link', { name: 'Frame', exact: true }).click();
    await this.page.getByLabel('A frame, a log or code').fill(request);
    await this.page.getByRole('link', { name: 'Bus' }).click();
    await expect(this.result.locator('.bytes-line').first()).toHaveText(request);
  }

  /** Chooses a port in the browser's own list, and opens it. */
  async choose(row = 0): Promise<void> {
    await this.button(/^(Connect…|Choose another port…)$/).click();
    const chooser = await openedChooser();
    await chooser.pick(row);
    await expect(this.status).toContainText('Connected to');
  }

  /** Opens a port that was chosen before. */
  async reopen(name: string): Promise<void> {
    await this.button(`Connect to ${name}`).click();
    await expect(this.status).toContainText('Connected to');
  }

  async disconnect(): Promise<void> {
    await this.button('Disconnect').click();
    await expect(this.status).toContainText('Not connected.');
  }

  /** Sends a request, and awaits the reply; both are bytes as the page writes them. */
  async ask(request: string, reply: string, said = 'Answered.'): Promise<void> {
    await this.hold(request);
    await this.button('Send').click();
    await expect(this.reply.locator('.bytes-line')).toHaveText(reply);
    await expect(this.reply).toContainText(said);
  }
}
