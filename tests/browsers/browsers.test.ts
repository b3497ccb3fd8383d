import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, test } from 'vitest';
// @ts-expect-error: the script has no types of its own.
import { serveBuiltPage } from '../../scripts/static-server.mjs';
import { browsersHere } from './browsers-here.ts';
import { Driver } from './driver.ts';
import type { Around } from './step.ts';
import { steps } from './steps.ts';
import { stepsWithoutAServer } from './steps-without-a-server.ts';
import type { Browser, Tab } from './tab.ts';

const all = process.env['BROWSERS'] === 'all';

/** The built page, served as any static host does it. */
const serve: Around['serve'] = serveBuiltPage;
const { address: base, close } = await serve();
const folder = mkdtempSync(join(tmpdir(), 'framewright-'));

afterAll(() => {
  rmSync(folder, { recursive: true, force: true });
  close();
});

const oneFile = pathToFileURL(join('dist', 'framewright.html')).href;

const file = (name: string, content: string | Uint8Array) => {
  const path = join(folder, name);
  writeFileSync(path, content);
  return path;
};

// WebKitGTK's driver stops answering now and then, whatever the page does: a step is tried once more there.
describe.each(browsersHere())('$name', ({ name, start }) => {
  let browser: Browser;
  let tab: Tab;

  beforeAll(async () => {
    browser = await start();
  });
  afterAll(() => browser?.close());
  beforeEach(async () => {
    tab = await browser.open();
  });
  afterEach(() => tab?.close());

  const retry = name === 'WebKitGTK' ? 1 : 0;
  const wanted = [...steps, ...stepsWithoutAServer].filter(({ always }) => all || always);
  test.each(wanted)('$name', { retry }, async ({ run }) => {
    const page = new Driver(tab, base);
    await run(page, { file, oneFile, serve });
    expect(await page.complaints()).toEqual([]);
  });
});
