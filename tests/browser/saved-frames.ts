import type { Locator, Page } from '@playwright/test';
import { languages } from '#known';

const words = await languages.en.input();

/** The saved frames as a person meets them. */
export class SavedFrames {
  readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  async open(hash = ''): Promise<void> {
    await this.page.goto(`./${hash}`);
    await this.show();
  }

  /** Opens the drawer with them. */
  async show(): Promise<void> {
    const tab = this.page.getByRole('tab', { name: /^Saved frames/ });
    const opener = this.page.getByRole('button', { name: words.drawer.open });
    if ((await opener.getAttribute('aria-expanded')) === 'false') await opener.click();
    await tab.click();
  }

  async save(name: string): Promise<void> {
    await this.page.getByLabel('Name of this frame').fill(name);
    await this.page.getByRole('button', { name: 'Save this frame' }).click();
  }

  async import(name: string, text: string): Promise<void> {
    await this.page
      .getByLabel('Import a file')
      .setInputFiles({ name, mimeType: 'application/json', buffer: Buffer.from(text) });
  }

  get panel(): Locator {
    return this.page.getByRole('tabpanel', { name: /^Saved frames/ });
  }

  get rows(): Locator {
    return this.page.getByRole('list', { name: 'Saved frames' }).getByRole('listitem');
  }

  get names(): Locator {
    return this.rows.getByRole('link');
  }

  get said(): Locator {
    // Each row has a place that says what was copied.
    return this.panel.getByRole('status').last();
  }

  button(name: string): Locator {
    return this.page.getByRole('button', { name, exact: true });
  }
}
