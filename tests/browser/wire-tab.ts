import type { Locator, Page } from '@playwright/test';

/** A request of three registers, by RTU. */
export const request = '#rtu/request?unitId=1&functionCode=3&startAddress=0x6B&quantity=3';

/** The frame on its line as a person meets it. */
export class WireTab {
  readonly page: Page;
  readonly panel: Locator;
  readonly picture: Locator;
  /** The pairs over the bytes in sight. */
  readonly pairs: Locator;

  constructor(page: Page) {
    this.page = page;
    this.panel = page.getByRole('tabpanel', { name: 'On the wire' });
    this.picture = this.panel.getByRole('img', { name: /^Waveform/ });
    this.pairs = this.picture.locator('.character .pair');
  }

  async open(hash: string): Promise<void> {
    await this.page.goto(`./${hash}&v=3&tab=wire`);
  }

  button(name: string): Locator {
    return this.panel.getByRole('button', { name, exact: true });
  }

  entry(label: string): Locator {
    return this.panel.getByLabel(label, { exact: true });
  }
}
