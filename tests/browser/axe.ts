import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Page } from '@playwright/test';

const source = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

interface AxeResult {
  readonly violations: readonly {
    readonly id: string;
    readonly help: string;
    readonly nodes: readonly { readonly html: string }[];
  }[];
}

/** Runs axe in the page as it stands. */
export class AxeBuilder {
  private readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  /** Each rule broken, with the elements that break it; in the whole page, or within what a selector finds. */
  async findings(within = 'html'): Promise<string[]> {
    await this.page.evaluate(source);
    const result = await this.page.evaluate(
      (where) => (globalThis as unknown as { axe: { run(where: string): Promise<AxeResult> } }).axe.run(where),
      within,
    );
    return result.violations.map(({ id, help, nodes }) => `${id}: ${help}: ${nodes.map(({ html }) => html).join(' ')}`);
  }
}
