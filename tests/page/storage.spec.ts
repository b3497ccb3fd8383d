import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { FrameForm } from '../browser/form.ts';
import { expect, test } from './page.ts';

const SOURCE = 'src';

/** The keys that the page stores under, as its source has them. */
const keys = readdirSync(SOURCE, { recursive: true, encoding: 'utf8' })
  .filter((file) => /\.tsx?$/.test(file))
  .flatMap((file) => [
    ...readFileSync(join(SOURCE, file), 'utf8').matchAll(/(?:new \w+(?:<[^(]*>)?|super)\(\s*storage,\s*'([a-z-]+)',/g),
  ])
  .map(([, name]) => `framewright.${name}`);

async function fill(page: Page, texts: Readonly<Record<string, string>>): Promise<void> {
  await page.addInitScript((all) => {
    for (const [key, text] of Object.entries(all)) localStorage.setItem(key, text);
  }, texts);
}

async function openDevice(page: Page) {
  await page.goto('./');
  await page.getByRole('heading', { name: 'Device', exact: true }).click();
  await expect(page.getByLabel('Device profile')).toBeVisible();
}

/** Opens every tab of the Bus view. */
async function openBus(page: Page) {
  await page.goto('./#bus');
  for (const [title, inside] of [
    ['Poll', '.poll'],
    ['Virtual devices', '.virtual'],
    ['Scan', '.scan'],
    ['Sequence', '.sequence'],
  ] as const) {
    await page.getByRole('tab', { name: title }).click();
    await expect(page.locator(inside)).toBeVisible();
  }
}

for (const nonsense of [
  '{"constructor":1,"baud":-5,"parity":"purple","table":"constructor","from":"__proto__","lines":{"__proto__":[7]}}',
  '[null,7,{"table":"constructor","id":1,"model":"toString"}]',
])
  test(`the page stands whatever is stored: ${nonsense.slice(0, 20)}`, async ({ page }) => {
    expect(keys.length).toBeGreaterThan(15);
    await fill(page, Object.fromEntries(keys.map((key) => [key, nonsense])));
    await openDevice(page);
    await new FrameForm(page).expectBytes('06 06 02 AB 10 00 F5 E5');
    await openBus(page);
    await expect(page.getByLabel('Speed (baud)')).toHaveValue('19200');
    await expect(page.locator('.sequence')).toContainText(
      'It is left alone, and changes last until the page is closed.',
    );
    for (const view of ['checksum', 'timing', 'reference']) {
      await page.goto(`./#${view}`);
      await expect(page.getByRole('main')).not.toBeEmpty();
    }
  });

test('what cannot be read in a list is named, and the rest can be used', async ({ page }) => {
  const register = { name: 'Level', table: 'holding-register', address: 1 };
  const profile = { id: 'pump', name: 'Pump', convention: 'zero-based', registers: [register] };
  const broken = { ...profile, id: 'odd', name: 'Odd', registers: [{ ...register, table: 'constructor' }] };
  const sequence = { name: 'Stir', transport: 'rtu', steps: [] };
  const device = { id: 1, model: 'weg-drive', unit: 6, on: true };
  await fill(page, {
    'framewright.devices': JSON.stringify({ format: 'framewright-devices', version: 1, profiles: [broken, profile] }),
    'framewright.sequences': JSON.stringify({
      format: 'framewright-sequences',
      version: 1,
      sequences: [sequence, { ...sequence, name: 'Jump', steps: [{ kind: 'constructor' }] }],
    }),
    'framewright.virtual-devices': JSON.stringify([device, { ...device, id: 2, unit: 999 }]),
  });
  await openDevice(page);
  const faults = page.locator('.kept-fault');
  await expect(faults).toContainText('One of your devices cannot be read, and is not shown.');
  await expect(faults).toContainText('“Odd”: Row 1:');
  await page.getByLabel('Device profile').selectOption({ label: 'Pump' });
  await expect(page.getByRole('group', { name: 'Registers of this device' })).toContainText('Level');

  await openBus(page);
  await page.getByRole('tab', { name: 'Virtual devices' }).click();
  await expect(page.locator('.virtual')).toContainText('One device that this browser kept cannot be read');
  await expect(page.getByRole('button', { name: 'WEG drive', exact: true })).toBeVisible();
  await page.getByRole('tab', { name: 'Sequence' }).click();
  const sequences = page.locator('.sequence');
  await expect(sequences).toContainText('One of your sequences cannot be read, and is not shown.');
  await expect(sequences).toContainText('Sequence 2 (“Jump”): Step 1');
  await sequences.getByLabel('Sequence', { exact: true }).selectOption('Stir');
  await expect(sequences.getByLabel('Name')).toHaveValue('Stir');
});

test('a device that an earlier page kept is taken over with its meaning, and is there after a reload', async ({
  page,
}) => {
  // In version 1 a register held value × factor + offset.
  const register = { name: 'Level', table: 'holding-register', address: 1, unit: '%', factor: 10, offset: 400 };
  const profile = { id: 'pump', name: 'Pump', convention: 'zero-based', registers: [register] };
  const text = JSON.stringify({ format: 'framewright-devices', version: 1, profiles: [profile] });
  await page.goto('./');
  await page.evaluate((list) => localStorage.setItem('framewright.devices', list), text);
  await page.reload();
  await page.getByRole('heading', { name: 'Device', exact: true }).click();
  const registers = page.getByRole('group', { name: 'Registers of this device' });
  const scaled = page.getByLabel('Device profile');
  await scaled.selectOption({ label: 'Pump' });
  await expect(registers.locator('tbody [data-column="factor"]')).toHaveText('0.1');
  await expect(registers.locator('tbody [data-column="offset"]')).toHaveText('-40');
  const kept = () => page.evaluate(() => localStorage.getItem('framewright.devices'));
  await expect.poll(kept).toBeNull();
  await page.reload();
  await page.getByRole('heading', { name: 'Device', exact: true }).click();
  await expect(registers.locator('tbody [data-column="factor"]')).toHaveText('0.1');
  await expect(registers.locator('tbody [data-column="offset"]')).toHaveText('-40');
  await expect(scaled).toHaveValue('pump');
  await expect(page.locator('.kept-fault')).toHaveCount(0);
});
