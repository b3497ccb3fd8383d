import { existsSync, readFileSync, statSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { everyView } from './every-view.ts';
import { expect, test } from './page.ts';

const path = resolve('dist/framewright.html');
const address = pathToFileURL(path).href;

test.beforeAll(() => {
  if (!existsSync(path)) throw new Error('There is no one file: npm run build:file');
});

test('the one file weighs at most 1.5 MB, has a policy of hashes, and nothing in it is unsafe', () => {
  expect(statSync(path).size).toBeLessThanOrEqual(1_500_000);
  const html = readFileSync(path, 'utf8');
  const [, policy = ''] = /http-equiv="?Content-Security-Policy"? content="([^"]*)"/.exec(html) ?? [];
  expect(policy.replaceAll('&#39;', "'")).toMatch(
    /script-src 'sha256-\S+' 'sha256-\S+' blob:; style-src 'sha256-\S+'; worker-src blob:$/,
  );
  expect(policy).not.toMatch(/unsafe|\*|http/);
});

test('the one file does from a disk what the page does, and asks for nothing else', async ({ page }) => {
  const asked: string[] = [];
  page.on('request', (request) => asked.push(request.url()));
  await page.goto(address);
  for (const [view, use] of Object.entries(everyView)) await test.step(view, () => use(page));
  await page.goto(address);
  await page.getByRole('button', { name: /^Copy / }).click();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe('06 06 02 AB 10 00 F5 E5');
  expect(asked.filter((url) => url !== address && !/^(blob:null\/|data:image\/)/.test(url))).toEqual([]);
});
