// Polling at full speed in the built page, and what its window and its workers hold at each minute.
import { launch } from 'puppeteer-core';
import { findBrowserWithoutWindows } from '../../scripts/find-browser.mjs';
import { servePage } from '../built-page.mjs';

const LINK = '#rtu/request?unitId=33&functionCode=3&startAddress=999&quantity=4';

/**
 * @param {number} minutes
 * @param {(minute: number, rounds: number, bytes: readonly number[]) => void} each called at the beginning and after each minute
 *   with what the window, the session and the trace hold
 */
export async function minutesOfPolling(minutes, each) {
  const { address, close } = await servePage();
  const browser = await launch({
    executablePath: findBrowserWithoutWindows(),
    args: [...(process.getuid?.() === 0 ? ['--no-sandbox'] : []), '--disable-background-networking'],
    defaultViewport: { width: 1280, height: 900 },
    protocolTimeout: 600_000,
  });
  try {
    const page = await browser.newPage();
    await page.goto(address + LINK);
    const click = (what) => page.locator(`::-p-aria(${what})`).click();
    await click('[name="Bus"][role="link"]');
    await page.locator('::-p-aria(Speed of the virtual bus)').fill('fast');
    await click('[name="Use the virtual bus"][role="button"]');
    await click('[name="Poll"][role="tab"]');
    await page.locator('::-p-aria(Interval \\(ms\\))').fill('0');
    await click('[name="Start"][role="button"]');
    const rounds = async () => {
      const said = await page.$eval('main', (main) => /([\d,]+) rounds/.exec(main.textContent)?.[1]);
      return Number(said?.replaceAll(',', ''));
    };
    await page.waitForFunction(() => /\d\d rounds/.test(document.querySelector('main').textContent));
    const window = await page.createCDPSession();
    const held = async (session) => {
      await session.send('HeapProfiler.collectGarbage');
      const { usedSize, backingStorageSize = 0 } = await session.send('Runtime.getHeapUsage');
      return usedSize + backingStorageSize;
    };
    const begun = Date.now();
    for (let minute = 0; minute <= minutes; minute++) {
      const wait = begun + minute * 60_000 - Date.now();
      if (wait > 0) await new Promise((done) => setTimeout(done, wait));
      const bytes = [await held(window)];
      for (const name of ['session', 'trace']) bytes.push(await held((await workerOf(page, name)).client));
      each(minute, await rounds(), bytes);
    }
  } finally {
    await browser.close();
    close();
  }
}

/**
 * A worker of the page, which may have been asked for only just now.
 * @param {import('puppeteer-core').Page} page
 * @param {string} name
 */
async function workerOf(page, name) {
  for (;;) {
    const worker = page.workers().find((one) => one.url().includes(name));
    if (worker) return worker;
    await new Promise((done) => setTimeout(done, 50));
  }
}
