import { expect, type Page } from '@playwright/test';

/** What is disabled and in sight, and does not say why, or, where looks are asked for, does not look it. */
const faultsOf = (looks: boolean): readonly string[] => {
  const text = (ids: string | null) =>
    (ids ?? '')
      .split(' ')
      .map((id) => document.getElementById(id)?.textContent?.trim() ?? '')
      .join(' ')
      .trim();
  const why = (element: Element | null) =>
    element ? text(element.getAttribute('aria-describedby')) || (element.getAttribute('title') ?? '') : '';
  const disabled = document.querySelectorAll<HTMLElement>(
    ':is(button, input, select, textarea):disabled, button[aria-disabled="true"]',
  );
  return [...disabled].flatMap((element) => {
    if (!element.checkVisibility() || element.closest('[hidden]')) return [];
    const name =
      element.getAttribute('aria-label') ??
      (element as HTMLInputElement).labels?.[0]?.textContent?.trim() ??
      element.textContent?.trim();
    const faults: string[] = [];
    const around = element.closest('fieldset:disabled');
    if (why(element) === '' && why(around) === '') faults.push('no reason');
    const told = () => (faults.length > 0 ? [`${element.localName} “${name}”: ${faults.join(', ')}`] : []);
    if (!looks) return told();
    const drawn = element.closest('.file') ?? element;
    const { cursor, borderStyle, color } = getComputedStyle(drawn);
    const soft = Object.assign(document.createElement('i'), { style: 'color: var(--soft)' });
    document.body.append(soft);
    const isSoft = color === getComputedStyle(soft).color;
    soft.remove();
    if (cursor !== 'not-allowed') faults.push(`cursor ${cursor}`);
    const isBox = element.matches('[type="checkbox"], [type="radio"]');
    if (!isBox && !isSoft) faults.push('as dark as what is not disabled');
    if (!isBox && borderStyle === 'solid') faults.push(`border ${borderStyle}`);
    return told();
  });
};

/** Gathers the faults of what is disabled from several places. */
export class DisabledFaults {
  readonly #page: Page;
  readonly #looks: boolean;
  readonly #found = new Map<string, string>();

  /** `looks`: whether also what does not look disabled is a fault. */
  constructor(page: Page, looks: boolean) {
    this.#page = page;
    this.#looks = looks;
  }

  async at(where: string): Promise<void> {
    for (const fault of await this.#page.evaluate(faultsOf, this.#looks))
      if (!this.#found.has(fault)) this.#found.set(fault, where);
  }

  /** Opens each tab of the view in turn, and waits until all of it has come. */
  async eachTab(where: string, allCame: (page: Page) => Promise<void>): Promise<void> {
    const tabs = this.#page.locator('main').getByRole('tablist').first().getByRole('tab');
    await expect(tabs.first()).toBeVisible();
    for (const tab of await tabs.all()) {
      await tab.click();
      await allCame(this.#page);
      await this.at(`${where}, ${await tab.textContent()}`);
    }
  }

  get found(): readonly string[] {
    return Array.from(this.#found, ([fault, where]) => `${where}: ${fault}`);
  }
}
