import { expect, type Page } from '@playwright/test';
import { languages } from '#known';

const words = await languages.en.checksum();

/** The Checksum view as a person meets it. */
export class ChecksumView {
  readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  async open(query = ''): Promise<void> {
    await this.page.goto(`./#checksum${query}`);
    await this.unfoldAll();
  }

  /** Opens the table of all algorithms, if it is folded. */
  async unfoldAll(): Promise<void> {
    const heading = this.page.getByRole('heading', { name: words.all });
    await expect(heading).toBeVisible();
    if (!(await heading.evaluate((title) => title.closest('details')?.open))) await heading.click();
    await expect(this.search).toBeVisible();
  }

  get input() {
    return this.page.getByLabel(words.labels.bytes);
  }

  get search() {
    return this.page.getByRole('searchbox', { name: words.search });
  }

  get results() {
    return this.page.getByRole('region', { name: words.result });
  }

  get table() {
    return this.page.getByRole('table', { name: words.all });
  }

  row(name: string) {
    return this.table.getByRole('row').filter({ has: this.page.getByRole('radio', { name, exact: true }) });
  }

  async unfold(title: string): Promise<void> {
    await this.page.locator('summary').filter({ hasText: title }).click();
  }
}
