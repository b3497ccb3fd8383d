import { expect, type Page } from '@playwright/test';
import { languages } from '#known';

const words = await languages.en.trace();

/** The rows of the log: frames or exchanges. */
export const list = (page: Page) => page.getByRole('listbox', { name: /(frame|exchange)s?$/ });
export const chosen = (page: Page) => list(page).getByRole('option', { selected: true });
export const filter = (page: Page) => page.getByRole('combobox', { name: words.filter });
export const button = (page: Page, name: string) => page.getByRole('button', { name, exact: true });
export const openTab = (page: Page, name: string) =>
  page.getByRole('tablist', { name: words.tabs.label }).getByRole('tab', { name, exact: true }).click();

/** The dialog that saves a log. */
export const saving = (page: Page) => page.getByRole('dialog', { name: words.export.title });

/** Opens the Log view with a file. */
export async function openLog(page: Page, text: string, name = 'log.txt'): Promise<void> {
  await page.goto('./#log');
  await expect(page.getByText(words.empty)).toBeVisible();
  const file = { name, mimeType: 'text/plain', buffer: Buffer.from(text) };
  await page.getByLabel(words.openFile).setInputFiles(file);
  await expect(list(page)).toBeVisible();
}

/** Pastes a text outside of fields. */
export async function paste(page: Page, text: string): Promise<void> {
  await page.evaluate((content) => navigator.clipboard.writeText(content), text);
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await page.keyboard.press('Control+V');
}
