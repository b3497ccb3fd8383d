import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { expect, test } from './page.ts';

const BUILT_IN = 'WEG drive: start the motor at 30 Hz';

async function open(page: Page) {
  await page.goto('./#bus?tab=sequence');
  const panel = page.locator('.sequence');
  await expect(panel.getByRole('heading', { name: 'Finally' })).toBeVisible();
  return panel;
}

test('the motor of the guide is started on the virtual bus, and stopped by Escape', async ({ page }) => {
  const panel = await open(page);
  const start = panel.getByRole('button', { name: 'Start' });
  await expect(start).toBeDisabled();
  await page.getByRole('button', { name: 'Use the virtual bus' }).click();

  // Read only is on at first.
  await start.click();
  await expect(panel.locator('.run-said')).toHaveText(/Not started: .*“Read only” is on/);
  await page.getByRole('checkbox', { name: /Read only/ }).uncheck();

  // Nobody is asked about virtual devices.
  await start.click();
  const steps = panel.locator('.step');
  await expect(steps.nth(0)).toContainText('✓ answered');
  await expect(steps.nth(3)).toContainText('✓ came true: 4');
  await expect(steps.nth(4)).toHaveAttribute('aria-current', 'step');
  await expect(panel.getByLabel('Time (ms)').first()).toBeDisabled();
  await page.keyboard.press('Escape');
  await expect(panel.locator('.run-said')).toHaveText('Stopped. “Finally” was carried out.');
  await expect(steps.nth(4)).toContainText('■ stopped here');
  await expect(steps.nth(5)).toContainText('✓ answered');
  await expect(
    page
      .getByRole('listbox')
      .getByRole('option', { name: /06 06 02 AA 00 00 A9 E5/ })
      .last(),
  ).toBeVisible();

  // A change makes a copy, and what came of the run says nothing of that.
  await panel.getByLabel('Time (ms)').first().fill('20');
  await expect(panel.getByLabel('Name')).toHaveValue(`${BUILT_IN} (2)`);
  await expect(panel.locator('.step-mark')).toHaveCount(0);
});

test('steps are typed, moved, undone, kept, saved and opened', async ({ page }) => {
  const panel = await open(page);
  await panel.getByRole('button', { name: 'New', exact: true }).click();
  await panel.getByLabel('Name').fill('Pump');
  await panel.getByLabel('Name').press('Enter');
  await expect(panel.getByLabel('Name')).toBeFocused();
  const steps = panel.getByRole('group', { name: 'Add to the steps' });
  await steps.getByRole('button', { name: 'Add the current frame' }).click();
  await expect(panel.getByLabel(/^Frame \(/)).toHaveValue('06 06 02 AB 10 00 F5 E5');
  await expect(panel.locator('.step-meaning')).toContainText('06 Write Single Register, unit 6');
  await steps.getByRole('button', { name: 'Add a condition' }).click();
  await panel.getByLabel('Address (from 0)').fill('0x2A9');
  await panel.getByLabel('Value').fill('fast');
  await expect(panel.locator('[data-field="value"] .error')).toHaveText(/“fast” is not a number/);
  await expect(panel.locator('.run-bar')).toContainText('Cannot start: 1 mistake');
  await panel.getByRole('button', { name: 'Move up: Step 2' }).click();
  await expect(panel.getByRole('button', { name: 'Move down: Step 1' })).toBeEnabled();
  await expect(panel.locator('.step').first()).toContainText('Wait until');
  await panel.getByRole('button', { name: 'Undo' }).click();
  await expect(panel.locator('.step').first()).toContainText('Send');
  await panel.getByRole('button', { name: 'Remove: Step 2' }).click();
  await expect(panel.getByRole('button', { name: 'Remove: Step 1' })).toBeFocused();

  // A link to a frame is its bytes.
  await panel
    .getByLabel(/^Frame \(/)
    .fill('https://example.org/#rtu/request?unitId=6&functionCode=6&address=0x2AA&value=0');
  await panel.getByLabel(/^Frame \(/).press('Tab');
  await expect(panel.getByLabel(/^Frame \(/)).toHaveValue('06 06 02 AA 00 00 A9 E5');

  const saved = page.waitForEvent('download');
  await panel.getByRole('button', { name: 'Save as a file' }).click();
  const path = await (await saved).path();
  const file = JSON.parse(await readFile(path, 'utf8'));
  expect(file.sequences[0].steps).toEqual([{ kind: 'send', bytes: '06 06 02 AA 00 00 A9 E5', onFailure: 'stop' }]);

  await page.reload();
  const again = await open(page);
  await expect(again.getByLabel('Name')).toHaveValue('Pump');
  file.sequences[0].steps.push({ kind: 'wait', duration: 5 });
  file.sequences.push({ name: 'Odd', transport: 'rtu', steps: [{ kind: 'jump' }] });
  const buffer = Buffer.from(JSON.stringify(file));
  await again.getByLabel('Open a file…').setInputFiles({ name: 'more.json', mimeType: 'application/json', buffer });
  await expect(again).toContainText('the one from the file is now “Pump (2)”');
  await expect(again).toContainText('Sequence 2 (“Odd”) was not added: Step 1 has an unknown kind (jump)');
  await again.getByLabel('Sequence', { exact: true }).selectOption('Pump');
  await expect(again.locator('.step')).toHaveCount(1);
});
