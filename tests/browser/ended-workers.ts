import type { Page } from '@playwright/test';
import { languages } from '#known';

const inputWords = await languages.en.input();

export const connected = 'Connected to the virtual bus';
export const status = (page: Page) => page.getByRole('region', { name: 'Connection' }).getByRole('status');
export const useVirtualBus = (page: Page) => page.getByRole('button', { name: 'Use the virtual bus' });
export const openBus = (page: Page) => page.getByRole('link', { name: 'Bus', exact: true }).click();

/** Lets a test end every worker of the page, as the browser does when memory runs out: no event tells of it. */
export const letWorkersBeEnded = (page: Page) =>
  page.addInitScript(() => {
    const workers: Worker[] = [];
    const Own = window.Worker;
    window.Worker = class extends Own {
      constructor(address: string | URL, options?: WorkerOptions) {
        super(address, options);
        workers.push(this);
      }
    };
    Object.assign(window, { endWorkers: () => workers.splice(0).forEach((worker) => void worker.terminate()) });
  });

export const endWorkers = (page: Page) =>
  page.evaluate(() => (window as unknown as { endWorkers(): void }).endWorkers());

export const longText = '06 06 02 AB 10 00 F5 E5\n'.repeat(2500);

export async function openText(page: Page): Promise<void> {
  await page.goto('./');
  await page
    .getByLabel(inputWords.openFile)
    .setInputFiles({ name: 'bus.log', mimeType: 'text/plain', buffer: Buffer.from(longText) });
}

export async function openFile(page: Page): Promise<void> {
  await page.goto('./#checksum');
  const buffer = Buffer.from('123456789');
  await page
    .locator('.checksum-input input[type=file]')
    .setInputFiles({ name: 'nine', mimeType: 'text/plain', buffer });
}
