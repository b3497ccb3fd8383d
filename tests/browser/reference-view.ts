import { expect, type Locator, type Page } from '@playwright/test';
import { languages } from '#known';
import type { ReferenceSubject } from '../../src/workbench/index.ts';

const words = await languages.en.reference();

/** The reference as a person meets it. */
export class Reference {
  readonly page: Page;
  readonly search: Locator;
  readonly shown: Locator;

  constructor(page: Page) {
    this.page = page;
    this.search = page.getByRole('searchbox', { name: words.search });
    this.shown = page.getByRole('search').getByRole('status');
  }

  async open(hash = '#reference'): Promise<void> {
    await this.page.goto(`./${hash}`);
    await expect(this.search).toBeVisible();
  }

  table(subject: ReferenceSubject): Locator {
    return this.page.getByRole('table', { name: words.subjects[subject], exact: true });
  }

  /** The heads of a table's rows. */
  heads(subject: ReferenceSubject): Locator {
    return this.table(subject).getByRole('rowheader');
  }

  row(subject: ReferenceSubject, name: string | RegExp): Locator {
    return this.table(subject).getByRole('row').filter({ hasText: name });
  }
}
