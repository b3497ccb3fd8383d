import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { FrameForm } from './form.ts';

/** The devices as a person meets them. */
export class Device {
  readonly page: Page;
  readonly form: FrameForm;

  constructor(page: Page) {
    this.page = page;
    this.form = new FrameForm(page);
  }

  async open(hash = ''): Promise<void> {
    await this.page.goto(`./${hash}`);
    await this.page.getByRole('heading', { name: 'Device', exact: true }).click();
  }

  async choose(name: string): Promise<void> {
    await this.page.getByLabel('Device profile').selectOption({ label: name });
  }

  async press(name: string): Promise<void> {
    await this.page.getByRole('button', { name, exact: true }).click();
  }

  async paste(text: string): Promise<void> {
    await this.page.getByText('Import a register map').click();
    await this.page.getByLabel('Or paste it here').fill(text);
    await this.press('Import what is pasted');
  }

  async download(button: string) {
    const [file] = await Promise.all([this.page.waitForEvent('download'), this.press(button)]);
    return { name: file.suggestedFilename(), text: readFileSync(await file.path(), 'utf8') };
  }

  get panel() {
    return this.page
      .getByRole('group')
      .filter({ has: this.page.getByRole('heading', { name: 'Device', exact: true }) });
  }

  get said() {
    return this.panel.getByRole('status');
  }

  get rows() {
    return this.page.getByRole('group', { name: 'Registers of this device' }).locator('tbody tr');
  }

  cell(row: string, column: string) {
    return this.rows.filter({ hasText: row }).locator(`[data-column="${column}"]`);
  }

  get explanation() {
    return this.form.explanation;
  }
}
