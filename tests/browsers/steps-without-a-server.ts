import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { expect } from 'vitest';
import type { Driver } from './driver.ts';
import { type Around, LINK, LOG, type Step } from './step.ts';

/** Uses every view, with what comes late or works in a worker in it. */
async function useEveryView(page: Driver, { file }: Around, base: string): Promise<void> {
  await page.open(LINK, base);
  await page.fill('Value', '4097');
  await page.sees('list', 'The frame', /10.*01.*34.*25/);
  for (const [tab, says] of TABS) {
    await page.click('tab', tab);
    await page.sees('region', tab, says);
  }
  await page.paste(LOG);
  await page.sees('main', undefined, /6 frames, 3 exchanges/);
  await page.click('link', 'Bus');
  await page.fill('Speed of the virtual bus', 'as fast as possible');
  await page.click('button', 'Use the virtual bus');
  await page.sees('region', 'Connection', /Connected to the virtual bus/);
  await page.click('button', 'Send');
  await page.sees('region', 'Last reply', /Valid reply/);
  await page.click('link', 'Devices');
  await page.attach('Choose a file…', file('drive.csv', 'Name;Register;Type\nSpeed;40001;int16\n'));
  await page.sees('region', 'Import of drive.csv', /1 register read/);
  await page.click('link', 'Checksum');
  await page.attach(/^Open a file/, file('check.bin', '123456789'));
  await page.sees('main', undefined, /0x4B37/);
  await page.click('link', 'Timing');
  await page.sees('region', 'Usual speeds', /19200/);
  await page.click('link', 'Reference');
  await page.fill('Search the reference', '0x2B');
  await page.sees('main', undefined, /Encapsulated Interface Transport/);
}

const TABS: readonly (readonly [tab: string, says: RegExp])[] = [
  ['Values', /4097/],
  ['On the wire', /./],
  ['CRC', /2534/],
  ['Compare', /Transaction identifier/],
  ['Program', /./],
];

/** More than is read at a time, in zeros, and its CRC-16/MODBUS. */
const LARGE = 10_000_000;
const LARGE_CRC = /0xEC4F/;

export const stepsWithoutAServer: readonly Step[] = [
  {
    name: 'offline, every view works',
    async run(page, around) {
      const { address, close } = await around.serve();
      await page.open('', address);
      await page.until('the browser keeps the page', () => navigator.serviceWorker.controller !== null);
      close();
      await fetch(address).then(
        () => Promise.reject(new Error('The server goes on.')),
        () => undefined,
      );
      await useEveryView(page, around, address);
      for (const hash of ['#bus', '#checksum', '#devices', '#log', '#reference', '#timing']) {
        await page.open(hash, address);
        await page.sees('main', undefined, /./);
      }
    },
  },
  {
    name: 'a missing part is there again',
    async run(page, { serve }) {
      const manifest: Readonly<Record<string, { readonly file: string; readonly css?: readonly string[] }>> =
        JSON.parse(readFileSync('dist/manifest.json', 'utf8'));
      const [reference, checksum] = ['reference', 'checksum'].map(
        (view) => manifest[`src/ui/${view}/${view}-view.tsx`],
      );
      // What the browser keeps is not asked for.
      const refused = new Set([...(reference?.css ?? []), checksum?.file ?? '', 'offline-worker.js']);
      expect(refused.size).toBe(3);
      const { address, close } = await serve({ refused });
      await page.open('', address);
      await page.click('link', 'Reference');
      await page.until('a part is missing', () => document.querySelector('.missing') !== null);
      refused.delete(reference?.css?.[0] ?? '');
      await page.click('button', 'Try again');
      await page.sees('main', undefined, /Read Holding Registers/);
      await page.until('the style has come', () =>
        [...document.styleSheets].every((sheet) => {
          try {
            return sheet.cssRules.length > 0;
          } catch {
            return false;
          }
        }),
      );
      await page.click('link', 'Checksum');
      await page.until('a part is missing', () => document.querySelector('.missing') !== null);
      refused.delete(checksum?.file ?? '');
      // Firefox asks again for a script that failed after a reload only.
      await page.click('button', 'Reload the page');
      await page.sees('region', 'Checksums', /CRC-16/);
      close();
    },
  },
  {
    name: 'the one file runs from a disk, with its workers',
    always: true,
    async run(page, { file, oneFile }) {
      await page.open(LINK, oneFile);
      await page.sees('list', 'The frame', /F5 E5/);
      await page.click('link', 'Log');
      await page.attach(/^Open file/, file('bus.log', LOG));
      await page.sees('main', undefined, /6 frames, 3 exchanges/);
      await page.click('link', 'Bus');
      await page.click('button', 'Use the virtual bus');
      await page.sees('region', 'Connection', /Connected to the virtual bus/);
    },
  },
  {
    name: 'the one file reads chosen files',
    async run(page, { file, oneFile }) {
      await page.open('#checksum', oneFile);
      await page.attach(/^Open a file/, file('check.bin', '123456789'));
      await page.sees('main', undefined, /0x4B37/);
      await page.attach(/^Open a file/, file('large.bin', new Uint8Array(LARGE)));
      await page.sees('region', 'Checksums', LARGE_CRC);
      await page.open('#log', oneFile);
      await page.attach(/^Open file/, file('bus.log.gz', gzipSync(LOG.repeat(2))));
      await page.sees('main', undefined, /12 frames, 6 exchanges/);
    },
  },
  {
    name: 'the one file copies, and says what the browser does not let it do',
    async run(page, { oneFile }) {
      await page.open(LINK, oneFile);
      await page.click('button', /^Copy hex/);
      await page.sees('region', 'The frame', /Copied|copy/i);
      const serial = await page.ask(() => 'serial' in navigator);
      await page.click('link', 'Bus');
      await page.sees('region', 'Connection', serial ? /Connect…/ : /Web Serial/);
    },
  },
];
