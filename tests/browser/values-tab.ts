import type { Locator, Page } from '@playwright/test';
import { languages } from '#known';

const words = await languages.en.values();

/** A reply of registers from 40108: 77.5146 as CDAB, 0, 4096, "PUMP". */
export const reply =
  '#rtu/reply?unitId=17&functionCode=3&registers=0x077A+0x429B+0x0000+4096+0x5055+0x4D50&answering=1103006B000676C5&v=3&tab=values';

/** The values of registers as a person meets them. */
export class ValuesTab {
  readonly page: Page;
  readonly panel: Locator;
  /** The field of the values that become registers. */
  readonly typed: Locator;
  /** The values that are likely. */
  readonly marked: Locator;

  constructor(page: Page) {
    this.page = page;
    this.panel = page.getByRole('tabpanel', { name: 'Values' });
    this.typed = page.getByLabel(words.typed, { exact: true });
    this.marked = page.getByRole('list', { name: words.marked });
  }

  /** The table of the values of so many registers. */
  table(registers: 1 | 2 | 4): Locator {
    return this.page.getByRole('table', { name: words.width(registers) });
  }

  /** Unfolds the scale. */
  async openScale(): Promise<void> {
    await this.page.locator('summary', { hasText: new RegExp(`^${words.scale}`) }).press('Enter');
  }
}
