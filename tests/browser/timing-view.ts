import { expect, type Locator, type Page } from '@playwright/test';
import { languages } from '#known';

const words = await languages.en.timing();

/** The view of the timing as a person meets it. */
export class Timing {
  readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  async open(hash = '#timing'): Promise<void> {
    await this.page.goto(`./${hash}`);
    await expect(this.field(words.speed)).toBeVisible();
  }

  field(label: string): Locator {
    return this.page.getByLabel(label, { exact: true });
  }

  panel(name: string): Locator {
    return this.page.getByRole('region', { name, exact: true });
  }

  row(table: string, name: string | RegExp): Locator {
    return this.page.getByRole('table', { name: table }).getByRole('row', { name });
  }
}
