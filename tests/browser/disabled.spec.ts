import type { Page } from '@playwright/test';
import { allCame, expect, test } from './page.ts';

const READ = 'rtu/request?unitId=33&functionCode=3&startAddress=999&quantity=4';
const COILS = 'rtu/request?unitId=17&functionCode=15&startAddress=19&quantity=10&coils=1011001110';
const REGISTERS = 'rtu/request?unitId=17&functionCode=16&startAddress=1&registers=10,258';

/** What is disabled and in sight, and does not say why, or does not look it. */
const faultsOf = (): readonly string[] => {
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
    return faults.length > 0 ? [`${element.localName} “${name}”: ${faults.join(', ')}`] : [];
  });
};

/** Gathers faults from several places, and expects none at last. */
class Look {
  readonly #page: Page;
  readonly #found = new Map<string, string>();

  constructor(page: Page) {
    this.#page = page;
  }

  async at(where: string): Promise<void> {
    for (const fault of await this.#page.evaluate(faultsOf)) if (!this.#found.has(fault)) this.#found.set(fault, where);
  }

  /** Opens each tab of the view in turn. */
  async eachTab(where: string): Promise<void> {
    const tabs = this.#page.locator('main').getByRole('tablist').first().getByRole('tab');
    for (const tab of await tabs.all()) {
      await tab.click();
      await allCame(this.#page);
      await this.at(`${where}, ${await tab.textContent()}`);
    }
  }

  expectNone(): void {
    expect(Array.from(this.#found, ([fault, where]) => `${where}: ${fault}`)).toEqual([]);
  }
}

test('what is disabled looks it and says why: frames, checksum, timing and reference', async ({ page }) => {
  const look = new Look(page);
  for (const hash of [READ, COILS, REGISTERS, `${READ}&force.checksum=0`]) {
    await page.goto(`./#${hash}`);
    await look.eachTab(hash);
  }
  await page.getByRole('button', { name: /^All examples/ }).click();
  await allCame(page);
  await look.at('drawer');
  await page.keyboard.press('Escape');
  for (const view of ['Checksum', 'Timing', 'Reference']) {
    await page.getByRole('link', { name: view, exact: true }).click();
    await allCame(page);
    await look.at(view);
  }
  await page.getByRole('searchbox').first().fill('zzzz');
  await look.at('Reference, nothing found');
  look.expectNone();
});

test('what is disabled looks it and says why: the bus, without a connection, with one, and while it works', async ({
  page,
}) => {
  const look = new Look(page);
  await page.goto(`./#${READ}`);
  await page.getByRole('link', { name: 'Bus', exact: true }).click();
  await look.eachTab('not connected');
  await page.getByRole('button', { name: 'Use the virtual bus' }).click();
  await look.eachTab('connected');
  await page.getByLabel('Read only').uncheck();
  for (const [name, start] of [
    ['Poll', 'Start'],
    ['Sequence', 'Start'],
    ['Scan', 'Start the scan'],
  ] as const) {
    const tab = page.getByRole('tab', { name, exact: true });
    await tab.click();
    const panel = page.getByRole('tabpanel', { name, exact: true });
    await panel
      .getByRole('button', { name: new RegExp(`^${start}`) })
      .first()
      .click();
    await look.at(`${name} begins`);
    await look.eachTab(`while ${name} works`);
    await tab.click();
    const stop = panel.getByRole('button', { name: /^Stop/ });
    // In one step: the work may end by itself at any time.
    await stop.evaluateAll(([button]) => (button as HTMLElement | undefined)?.click());
  }
  look.expectNone();
});
