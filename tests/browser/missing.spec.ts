import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { languages } from '#known';
import { builtFile } from './built-file.ts';
import { FrameForm } from './form.ts';
import { button, openLog, openTab } from './log-view.ts';
import { expect, test } from './page.ts';

const { strip, views } = await languages.en.page();
const { tabs } = await languages.en.trace();
const checksum = await languages.en.checksum();
const program = await languages.en.program();

// What the page says of parts that these tests keep from coming.
test.use({
  expected: /^(failed: \S+ net::ERR_FAILED|console error: Failed to load resource: net::ERR_FAILED)$/,
});

const notRun = /Framewright is loading/;
const notStyled = /^The style sheet of this page did not load/;

test('a page whose script or style sheet does not come says so, and works without the second; a page that runs says neither', async ({
  page,
}) => {
  const copy = page.getByRole('button', { name: /^Copy / }).first();
  await test.step('without its script', async () => {
    await page.route(/\.js$/, (route) => route.abort());
    await page.goto('./');
    await expect(page.getByText(notRun)).toBeVisible();
    await expect(page.getByText(notStyled)).toBeHidden();
    await page.unrouteAll();
  });
  await test.step('without its style sheet', async () => {
    await page.route(/\.css$/, (route) => route.abort());
    await page.reload();
    await expect(page.getByText(notStyled)).toBeVisible();
    await expect(copy).toBeVisible();
    await expect(page.getByText(notRun)).toHaveCount(0);
    await page.unrouteAll();
  });
  await test.step('with both', async () => {
    await page.reload();
    await expect(copy).toBeVisible();
    await expect(page.getByText(notRun)).toHaveCount(0);
    await expect(page.getByText(notStyled)).toBeHidden();
  });
});

test.describe('from a disk', () => {
  test.use({
    expected:
      /^(failed: file:\S+ net::ERR_FAILED|console error: (Failed to load resource: net::ERR_FAILED|Access to (script|CSS stylesheet) at 'file:\S+' from origin 'null' .*))$/,
  });

  test('a folder that is opened says what to do instead', async ({ page }) => {
    await page.goto(pathToFileURL(resolve('dist/index.html')).href);
    await expect(page.getByText(notRun)).toContainText('open framewright.html instead');
    await expect(page.getByText(notRun)).toContainText('put this folder on a web server');
    await expect(page.getByText(notStyled)).toBeVisible();
    await expect(page.getByRole('banner')).toHaveCount(0);
  });
});

test('a part that cannot be fetched says so at its place, and comes when it can be', async ({ page }) => {
  await page.goto('./');
  const copy = page.getByRole('button', { name: /^Copy / });
  await expect(copy).toBeVisible();
  const parts = /\/assets\/[^/]*\.(js|css)$/;
  await page.route(parts, (route) => route.abort());
  await page.getByRole('link', { name: views.names.reference }).click();
  const alert = page.getByRole('alert');
  // Some browsers do not ask again for a script that failed: a reload is offered at once.
  await expect(alert).toHaveText(`${views.missing} ${views.missingWhy}${views.tryAgain}${views.reload}`);
  await expect(page.getByRole('main')).toHaveCount(0);
  const again = page.getByRole('button', { name: views.tryAgain });
  await again.first().click();
  await expect(alert).toBeVisible();

  await page.unroute(parts);
  // What was asked for again may come by now, and then there is no button.
  await again.evaluateAll(([first]) => (first as HTMLElement | undefined)?.click());
  await expect(page.getByRole('searchbox')).toBeVisible();
  await expect(page.getByText(views.missing)).toHaveCount(0);
  const allStyles = () =>
    [...document.styleSheets].every((sheet) => {
      try {
        return sheet.cssRules.length > 0;
      } catch {
        // So it is in Chromium for one that did not come.
        return false;
      }
    });
  await expect.poll(() => page.evaluate(allStyles)).toBe(true);

  await page.getByRole('link', { name: views.names.frame, exact: true }).click();
  await expect(copy).toBeVisible();
});

test('without its sentences a view says so, and comes as its link has it when they do', async ({ page }) => {
  const sentences = builtFile('src/words/en/checksum.ts');
  await page.route(sentences, (route) => route.abort());
  await page.goto('./#checksum?bytes=0A+0B');
  const missing = page.getByText(views.missing);
  await expect(missing).not.toHaveCount(0);
  await expect(page.getByRole('main')).toHaveCount(0);
  await page.unroute(sentences);
  // What was asked for before that may fail after it: then it is asked for once more.
  await expect(async () => {
    const again = page.getByRole('button', { name: views.tryAgain });
    await again.evaluateAll(([first]) => (first as HTMLElement | undefined)?.click());
    await expect(page.getByLabel(checksum.labels.bytes)).toHaveValue('0A 0B', { timeout: 10_000 });
  }).toPass();
  await expect(missing).toHaveCount(0);
});

test('a button whose code cannot be fetched does what it says, or says that it cannot', async ({ page }) => {
  const clipboard = () => page.evaluate(() => navigator.clipboard.readText());
  const writer = builtFile('copied-text');
  await page.route(writer, (route) => route.abort());
  await page.addInitScript(() => localStorage.setItem('framewright.copy', '"c"'));
  await page.goto('./#rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3');
  await button(page, strip.copy('spaced')).click();
  await expect.poll(clipboard).toBe('11 03 00 6B 00 03 76 87');
  await page.unroute(writer);
  await page.reload();
  await button(page, strip.copy('c')).click();
  await expect.poll(clipboard).toContain('0x11, 0x03');

  const maker = builtFile('src/ui/trace/tabs/made-device.tsx');
  await page.route(maker, (route) => route.abort());
  await openLog(page, ['01 03 00 00 00 01 84 0A', '01 03 02 00 07 F9 86'].join('\n'));
  await openTab(page, tabs.names.values);
  await button(page, tabs.values.makeDevice(1)).click();
  await expect(page.getByText(views.missing)).toBeVisible();
  await page.unroute(maker);
  await page.getByRole('button', { name: views.tryAgain }).click();
  await expect(page.getByText(tabs.values.deviceMade('Unit 1 of log.txt'))).toBeVisible();
});

test('a part whose script or sentences come empty says so, as one that cannot be fetched', async ({ page }) => {
  const empty = (module: string) =>
    page.route(builtFile(module), (route) => route.fulfill({ contentType: 'text/javascript', body: '' }));
  for (const [module, address] of [
    ['src/ui/bus/poll/poll-panel.tsx', 'bus?tab=poll'],
    ['src/words/en/scan.ts', 'bus?tab=scan'],
    ['src/words/en/checksum.ts', 'checksum'],
  ] as const) {
    await empty(module);
    await page.goto(`./#${address}`);
    await expect(page.getByText(views.missing).first(), module).toBeVisible();
    await page.unrouteAll();
    await page.getByRole('button', { name: views.reload }).click();
    await expect(page.getByText(views.missing), module).toHaveCount(0);
    await expect(page.getByRole('main'), module).toBeVisible();
  }

  await empty('src/ui/parts/program/saved-zip.tsx');
  await page.goto('./#rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3&tab=program');
  await button(page, program.saveAll).click();
  await expect(page.getByText(views.missing)).toBeVisible();
});

test.describe('a part that fails', () => {
  test.use({ expected: /^thrown: planted$/ });

  test('says so at its place, and the rest of the page works', async ({ page }) => {
    await page.goto('./');
    await expect(page.getByRole('button', { name: /^Copy / }).first()).toBeVisible();
    await page.evaluate(() => {
      const { select } = Intl.PluralRules.prototype;
      Object.assign(window, { mend: () => Object.assign(Intl.PluralRules.prototype, { select }) });
      Intl.PluralRules.prototype.select = () => {
        throw new RangeError('planted');
      };
    });
    const link = (name: string) => page.getByRole('navigation').first().getByRole('link', { name, exact: true });
    await link('Reference').click();
    await expect(page.getByText(views.failed('RangeError: planted'))).toBeVisible();
    await page.evaluate(() => (window as unknown as { mend(): void }).mend());
    await link('Frame').click();
    await expect(page.getByRole('region', { name: 'The frame' })).toContainText('Valid request');
    await link('Reference').click();
    await expect(page.getByRole('main')).toBeVisible();
  });
});

test.describe('without the sentences of the first view', () => {
  test.use({ expected: /^(failed: |console error: Failed to load |thrown: Failed to fetch dynamically imported )/ });

  test('the page says so in plain words, and offers to reload', async ({ page }) => {
    const words = builtFile('common');
    await page.route(words, (route) => route.abort());
    await page.goto('./#rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3');
    await expect(page.getByText('The words of this page did not load.')).toBeVisible();
    await expect(page.getByText(notRun)).toBeHidden();
    await expect(page.getByRole('main')).toHaveCount(0);
    await page.unroute(words);
    await page.getByRole('button', { name: 'Reload' }).click();
    await expect(page.getByRole('region', { name: 'The frame' })).toContainText('Valid request');
    await expect(new FrameForm(page).field('unitId')).toHaveValue('17');
  });
});
