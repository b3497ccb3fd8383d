import { readFileSync } from 'node:fs';
import { builtFile } from './built-file.ts';
import { expect, test } from './page.ts';

test('the page opens with what it names, asks no other host for anything, and loads what a tab shows when it is opened', async ({
  page,
  request,
  baseURL,
}) => {
  const loaded: string[] = [];
  page.on('request', (given) => loaded.push(given.url()));
  await page.goto('./', { waitUntil: 'networkidle' });
  await expect(page).toHaveTitle('Framewright: Modbus frames built and explained');
  await expect(page.locator('#app')).not.toBeEmpty();
  const icon = await page.locator('link[rel=icon]').getAttribute('href');
  expect((await request.get(`./${icon}`)).status()).toBe(200);

  const values = builtFile('src/ui/parts/frame-tabs/values/values.tsx');
  const count = () => loaded.filter((url) => values.test(url)).length;
  expect(count()).toBe(0);
  await page.getByRole('tab', { name: 'Values' }).click();
  await expect.poll(count).toBeGreaterThan(0);
  expect(new Set(loaded.map((url) => new URL(url).origin))).toEqual(new Set([new URL(baseURL!).origin]));
});

test('the policy that the README gives to hosts is that of the page, and forbids frames', async ({ request }) => {
  const html = await (await request.get('./')).text();
  const [, built] = /http-equiv="?Content-Security-Policy"? content="([^"]*)"/.exec(html) ?? [];
  const [, header = ''] = /Content-Security-Policy: (.*)/.exec(readFileSync('README.md', 'utf8')) ?? [];
  const rules = (policy: string) => policy.split('; ').sort();
  expect(rules(header)).toEqual(rules(`${built?.replaceAll('&#39;', "'")}; frame-ancestors 'none'`));
});
