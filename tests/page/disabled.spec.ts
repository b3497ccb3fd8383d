import { DisabledFaults } from '../browser/disabled-faults.ts';
import { allCame, expect, test } from './page.ts';

const READ = 'rtu/request?unitId=33&functionCode=3&startAddress=999&quantity=4';
const COILS = 'rtu/request?unitId=17&functionCode=15&startAddress=19&quantity=10&coils=1011001110';
const REGISTERS = 'rtu/request?unitId=17&functionCode=16&startAddress=1&registers=10,258';

test('what is disabled says why: frames, checksum, timing and reference', async ({ page }) => {
  const faults = new DisabledFaults(page, false);
  for (const hash of [READ, COILS, REGISTERS, `${READ}&force.checksum=0`]) {
    await page.goto(`./#${hash}`);
    await faults.eachTab(hash, allCame);
  }
  await page.getByRole('button', { name: /^All examples/ }).click();
  await allCame(page);
  await faults.at('drawer');
  await page.keyboard.press('Escape');
  for (const view of ['Checksum', 'Timing', 'Reference']) {
    await page.getByRole('link', { name: view, exact: true }).click();
    await allCame(page);
    await faults.at(view);
  }
  await page.getByRole('searchbox').first().fill('zzzz');
  await faults.at('Reference, nothing found');
  expect(faults.found).toEqual([]);
});

test('what is disabled says why: the bus, without a connection, with one, and while it works', async ({ page }) => {
  const faults = new DisabledFaults(page, false);
  await page.goto(`./#${READ}`);
  await page.getByRole('link', { name: 'Bus', exact: true }).click();
  await faults.eachTab('not connected', allCame);
  await page.getByRole('button', { name: 'Use the virtual bus' }).click();
  await faults.eachTab('connected', allCame);
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
    await faults.at(`${name} begins`);
    await faults.eachTab(`while ${name} works`, allCame);
    await tab.click();
    const stop = panel.getByRole('button', { name: /^Stop/ });
    // In one step: the work may end by itself at any time.
    await stop.evaluateAll(([button]) => (button as HTMLElement | undefined)?.click());
  }
  expect(faults.found).toEqual([]);
});
