import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Page } from '@playwright/test';
import { allCame } from './page.ts';

const source = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

interface AxeResult {
  readonly violations: readonly {
    readonly id: string;
    readonly help: string;
    readonly nodes: readonly { readonly html: string }[];
  }[];
}

interface Axe {
  run(where: string, options: object): Promise<AxeResult>;
}

/** The rules that ask for colours. */
const ofColours = ['color-contrast', 'link-in-text-block'];

/** Runs axe in the page when all that it waits for has come. */
export class AxeBuilder {
  private readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  /** Each rule broken, with the elements that break it; in the whole page, or within what a selector finds. */
  findings(within = 'html'): Promise<string[]> {
    return this.run(within, {});
  }

  /** The rules of colours broken: for what was examined in the other colour scheme. */
  findingsOfColours(): Promise<string[]> {
    return this.run('html', { runOnly: ofColours });
  }

  private async run(within: string, options: object): Promise<string[]> {
    await allCame(this.page);
    if (!(await this.page.evaluate(() => 'axe' in globalThis))) await this.page.evaluate(source);
    const result = await this.page.evaluate(
      ([where, how]) => (globalThis as unknown as { axe: Axe }).axe.run(where, { ...how, resultTypes: ['violations'] }),
      [within, options] as const,
    );
    return result.violations.map(({ id, help, nodes }) => `${id}: ${help}: ${nodes.map(({ html }) => html).join(' ')}`);
  }
}
