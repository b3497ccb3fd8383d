import { expect, type Page } from '@playwright/test';
import { languages } from '#known';
import { FrameForm } from './form.ts';
import { allCame } from './page.ts';

const checksum = await languages.en.checksum();
const input = await languages.en.input();
const trace = await languages.en.trace();
const timing = await languages.en.timing();

const READ = '#rtu/request?unitId=33&functionCode=3&startAddress=999&quantity=4';
const LONG = '06 06 02 AB 10 00 F5 E5\n'.repeat(2500);

const link = (page: Page, name: string) => page.getByRole('link', { name, exact: true });
const button = (page: Page, name: string | RegExp) => page.getByRole('button', { name }).first();
const tab = (page: Page, name: string) => page.getByRole('tab', { name, exact: true });
const file = (name: string, text: string) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });

/**
 * What is done in each view, one after the other in the same window, with everything that is loaded late or works in a
 * worker. The page has no other state when the first begins than that it has been opened.
 */
export const everyView: Readonly<Record<string, (page: Page) => Promise<void>>> = {
  async frame(page) {
    const form = new FrameForm(page);
    await go(page, READ);
    await form.expectBytes('21 03 03 E7 00 04 F3 1A');
    await form.field('quantity').fill('5');
    await form.expectBytes('21 03 03 E7 00 05 32 DA');
  },
  async tabs(page) {
    await tab(page, 'Values').click();
    await expect(page.getByRole('tabpanel', { name: 'Values' })).not.toBeEmpty();
    await tab(page, 'On the wire').click();
    await expect(page.getByRole('img', { name: /^Waveform/ })).toBeVisible();
    await tab(page, 'CRC').click();
    await expect(page.getByRole('tabpanel', { name: 'CRC' })).toContainText('0xDA32');
    await tab(page, 'Compare').click();
    await expect(page.getByRole('tabpanel', { name: 'Compare' })).toContainText('TCP');
    await tab(page, 'Program').click();
    await expect(page.getByRole('tabpanel', { name: 'Program' }).locator('code, pre').first()).not.toBeEmpty();
  },
  async 'long text'(page) {
    await go(page, '');
    await page.evaluate((text) => navigator.clipboard.writeText(text), LONG);
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    await page.keyboard.press('Control+V');
    await expect(page.getByRole('listbox')).toBeVisible();
  },
  async log(page) {
    await go(page, '');
    await page.getByLabel(input.openFile).setInputFiles(file('bus.log', LONG));
    await expect(page.getByRole('listbox')).toBeVisible();
    await expect(page.getByRole('button', { name: /^2[,.]?500 frames/ })).toBeVisible();
    await page.getByRole('listbox').getByRole('option').first().click();
    await expect(page.getByRole('main')).toContainText('06');
    await expect(page.getByText(trace.failed.died)).toHaveCount(0);
  },
  async checksum(page) {
    await link(page, 'Checksum').click();
    await page.locator('.checksum-input input[type=file]').setInputFiles(file('nine', '123456789'));
    await expect(page.getByRole('region', { name: checksum.result })).toContainText('4B37');
  },
  async timing(page) {
    await link(page, 'Timing').click();
    await expect(page).toHaveTitle(timing.title);
    await expect(page.getByRole('main')).toContainText('19200');
  },
  async reference(page) {
    await link(page, 'Reference').click();
    await page.getByRole('searchbox').fill('mask');
    await expect(page.getByRole('main')).toContainText('Mask Write Register');
  },
  async bus(page) {
    await go(page, READ);
    await link(page, 'Bus').click();
    await page.getByLabel('Speed of the virtual bus').selectOption('fast');
    await button(page, 'Use the virtual bus').click();
    const status = page.getByRole('region', { name: 'Connection' }).getByRole('status');
    await expect(status).toContainText('Connected to the virtual bus');
    await button(page, 'Send').click();
    await expect(page.getByRole('region', { name: 'Last reply' })).toContainText('Valid');
    await tab(page, 'Poll').click();
    const poll = page.locator('.poll');
    await poll.getByRole('button', { name: /^(Poll|Start)/ }).click();
    await expect(poll.locator('canvas')).toBeVisible();
    await poll.getByRole('button', { name: 'Stop' }).click();
    for (const name of ['Scan', 'Listen', 'Sequence', 'Virtual devices']) {
      await tab(page, name).click();
      await expect(page.getByRole('tabpanel', { name })).not.toBeEmpty();
    }
    await page.getByRole('button', { name: 'Disconnect' }).click();
    await expect(status).not.toContainText('Connected to');
  },
  devices: async (page) => {
    await page.getByRole('navigation', { name: 'Views' }).getByRole('link', { name: 'Devices' }).click();
    const text = 'Name;Register;Type\nSpeed;40001;int16\n';
    const file = { name: 'drive.csv', mimeType: 'text/csv', buffer: Buffer.from(text) };
    await page.getByLabel('Choose a file…').setInputFiles(file);
    await expect(page.getByRole('region', { name: 'Import of drive.csv' })).toContainText('1 register read');
  },
};

/** Opens a link of this page, as a person does who pastes it into the address. */
async function go(page: Page, hash: string): Promise<void> {
  await page.evaluate((to) => {
    location.hash = to;
  }, hash);
  await expect(page.getByRole('list', { name: 'The frame' })).toBeVisible();
  await allCame(page);
}
