import { DisabledFaults } from './disabled-faults.ts';
import { allCame, expect, test } from './page.ts';

const READ = 'rtu/request?unitId=33&functionCode=3&startAddress=999&quantity=4';

test('what is disabled looks it: frames, checksum, reference, and the bus without a connection and while it polls', async ({
  page,
}) => {
  const faults = new DisabledFaults(page, true);
  await page.goto(`./#${READ}&force.checksum=0`);
  await faults.eachTab('frames', allCame);
  for (const view of ['Checksum', 'Reference']) {
    await page.getByRole('link', { name: view, exact: true }).click();
    await allCame(page);
    await faults.at(view);
  }
  await page.getByRole('searchbox').first().fill('zzzz');
  await faults.at('Reference, nothing found');
  await page.getByRole('link', { name: 'Bus', exact: true }).click();
  await faults.eachTab('not connected', allCame);
  await page.getByRole('button', { name: 'Use the virtual bus' }).click();
  await page.getByRole('tab', { name: 'Poll', exact: true }).click();
  const panel = page.getByRole('tabpanel', { name: 'Poll', exact: true });
  await panel.getByRole('button', { name: 'Start' }).click();
  await expect(panel.getByRole('button', { name: 'Stop' })).toBeVisible();
  await faults.at('while it polls');
  expect(faults.found).toEqual([]);
});
