import { expect, type Locator, type Page } from '@playwright/test';
import { languages } from '#known';

const words = await languages.en.checksumSteps();

/** The steps as a person meets them. */
export class Steps {
  readonly page: Page;
  readonly list: Locator;
  /** The row that is chosen. */
  readonly chosen: Locator;

  constructor(page: Page) {
    this.page = page;
    this.list = page.getByRole('treegrid', { name: words.list });
    this.chosen = this.list.getByRole('row', { selected: true });
  }

  async open(query: string): Promise<void> {
    await this.page.goto(`./#checksum?${query}`);
    await this.page.locator('details.checksum-steps > summary').click();
    await expect(this.list).toBeVisible();
  }

  button(name: string): Locator {
    return this.page.getByRole('button', { name, exact: true });
  }

  /** Presses keys, one after the other. */
  async press(...keys: readonly string[]): Promise<void> {
    for (const key of keys) await this.page.keyboard.press(key);
  }
}
