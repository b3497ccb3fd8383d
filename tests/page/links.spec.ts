import { randomBytes } from 'node:crypto';
import type { Page } from '@playwright/test';
import { languages } from '../../src/words/index.ts';
import { FrameForm } from '../browser/form.ts';
import { expect, test } from './page.ts';

const program = await languages.en.program();

const chosen = (page: Page) => page.getByLabel('Device profile');
/** What was typed for a drive: by a name, and in a unit. */
const LINK =
  '#rtu/request?v=2&unitId=6&functionCode=6&address=HR684&value=4096&typed.address=P0683&typed.value=30+Hz&device=weg-drive';

test('what was typed in a unit and by a name comes back by Back, Forward, a reload and a link', async ({ page }) => {
  await page.goto('./#rtu/request?unitId=6&functionCode=6&address=0&value=1');
  const form = new FrameForm(page);
  await page.getByRole('heading', { name: 'Device', exact: true }).click();
  await chosen(page).selectOption('WEG drive');
  await form.field('address').fill('P0683');
  await form.field('address').press('Tab');
  await form.field('value').fill('30 Hz');
  await form.field('value').press('Tab');
  await form.expectCopied('060602AB1000F5E5');
  await form.field('value').fill('15 Hz');
  await form.field('value').press('Tab');

  await page.goBack();
  await expect(form.field('value')).toHaveValue('30 Hz');
  await expect(form.field('address')).toHaveValue('P0683');
  await page.goForward();
  await expect(form.field('value')).toHaveValue('15 Hz');
  await page.goBack();
  await page.reload();
  await expect(form.field('value')).toHaveValue('30 Hz');
  await expect(form.field('address')).toHaveValue('P0683');
  await form.expectCopied('060602AB1000F5E5');
  await expect(page).toHaveURL(`./${LINK}`);
});

test('somebody else, who speaks to another device, opens the link, and keeps the own choice', async ({ page }) => {
  await page.addInitScript(() => localStorage.setItem('framewright.device', '"s7-200"'));
  await page.goto(`./${LINK}`);
  const form = new FrameForm(page);
  await expect(form.field('value')).toHaveValue('30 Hz');
  await expect(form.field('address')).toHaveValue('P0683');
  await expect(form.field('value')).toHaveAccessibleDescription('30 Hz is 4096 (0x1000).');
  await form.expectCopied('060602AB1000F5E5');
  await page.getByRole('heading', { name: 'Device', exact: true }).click();
  await expect(chosen(page)).toHaveValue('weg-drive');
  expect(await page.evaluate(() => localStorage.getItem('framewright.device'))).toBe('"s7-200"');
});

test('a link for a device that is not known here has its numbers, and says what was typed', async ({ page }) => {
  await page.goto(`./${LINK.replace('P0683', 'Speed').replace('weg-drive', 'pump-7')}`);
  const form = new FrameForm(page);
  await form.expectCopied('060602AB1000F5E5');
  await expect(form.field('value')).toHaveValue('4096');
  await expect(form.field('address')).toHaveValue('HR684');
  await expect(form.field('value')).toHaveAccessibleDescription(/typed as “30 Hz”/);
  await expect(form.field('address')).toHaveAccessibleDescription(/typed as “Speed”/);
  await expect(page.getByRole('alert')).toHaveCount(0);
  await form.field('value').fill('1');
  await expect(form.field('value')).toHaveAccessibleDescription('1, 0x0001');
});

test('a link from a newer page, and one that is too long, say so', async ({ page }) => {
  await page.goto('./#rtu/request?v=6&unitId=6&functionCode=6&address=0x02AB&value=4096');
  const form = new FrameForm(page);
  await expect(page.getByRole('alert')).toContainText('It is from a newer version of this page');
  await form.expectCopied('060602AB1000F5E5');
  const hash = `rtu/request?functionCode=99&data="${'A'.repeat(2_000_000)}"`;
  await page.evaluate((to) => (location.hash = to), hash);
  await expect(page.getByRole('alert')).toContainText('It is too long');
  expect(await page.evaluate(() => document.body.innerHTML.length)).toBeLessThan(500_000);
  await form.expectCopied('060602AB1000F5E5');
});

test('a frame of 64 kB is drawn by its beginning, and the rest when it is asked for', async ({ page }) => {
  await page.goto(`./#rtu/request?functionCode=99&data="${'A'.repeat(64_000)}"`);
  const form = new FrameForm(page);
  await expect(page.getByRole('button', { name: /^Copy / })).toBeVisible();
  await expect(form.strip.getByText('63,992 more')).toBeVisible();
  await page.getByRole('button', { name: 'Unfold all bytes' }).press('Enter');
  await expect(form.explanation.getByRole('row')).toHaveCount(601);
  await page.getByRole('button', { name: 'Show the next 600' }).press('Enter');
  await expect(form.explanation.getByRole('row')).toHaveCount(1201);
  // 2000 names that no field has are named in part, and none is a forced value.
  const names = Array.from({ length: 2000 }, (_, index) => `force.a${index}=1`).join('&');
  await page.evaluate(
    (to) => (location.hash = to),
    `rtu/request?unitId=6&functionCode=6&address=0x02AB&value=4096&${names}`,
  );
  await expect(page.getByRole('alert')).toContainText('“force.a0” is not known and was left out.');
  await expect(page.getByRole('alert')).toContainText('1,992 more parts left out.');
  await form.expectCopied('060602AB1000F5E5');
});

test('a search of 2 MB in a link finds nothing, and is cut where the page repeats it', async ({ page }) => {
  await page.goto('./#reference');
  await expect(page.getByRole('searchbox')).toBeVisible();
  await page.evaluate((to) => (location.hash = to), `reference?search=${'x'.repeat(2_000_000)}`);
  await expect(page.getByText(/x{100}…/)).toBeVisible();
  expect(await page.evaluate(() => document.body.innerText.length)).toBeLessThan(10_000);
});

test('of a frame of 39,064 bytes only what is in sight is drawn, in every tab', async ({ page }) => {
  const data = randomBytes(39_060).toString('hex');
  await page.goto(`./#rtu/request?unitId=1&functionCode=65&data=${data}`);
  const { strip } = new FrameForm(page);
  const linesLeft = new RegExp(program.linesLeft(2).replace(/^2/, '\\d+'));
  await expect(strip).toContainText('more');
  const elements = () => page.evaluate(() => document.querySelectorAll('*').length);
  const many = { Bytes: 2000, Values: 2000, 'On the wire': 2000, CRC: 2000, Compare: 2000, Program: 40_000 };
  for (const [name, most] of Object.entries(many)) {
    await page.getByRole('tab', { name, exact: true }).click();
    await expect(page.getByRole('tabpanel', { name })).not.toBeEmpty();
    if (name === 'Program') await expect(page.getByText(linesLeft).first()).toBeVisible();
    expect(await elements(), name).toBeLessThan(most);
  }
});
