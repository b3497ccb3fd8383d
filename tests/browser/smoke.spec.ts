import { readFileSync } from 'node:fs';
import { builtFile } from './built-file.ts';
import { expect, test } from './page.ts';

test('the page opens, and everything it names is there', async ({ page, request }) => {
  await page.goto('./');
  await expect(page).toHaveTitle('Framewright: Modbus frames built and explained');
  await expect(page.locator('#app')).not.toBeEmpty();

  const icon = await page.locator('link[rel=icon]').getAttribute('href');
  expect((await request.get(`./${icon}`)).status()).toBe(200);
});

test('the page asks no other host for anything', async ({ page, baseURL }) => {
  const hosts = new Set<string>();
  page.on('request', (request) => hosts.add(new URL(request.url()).origin));
  await page.goto('./', { waitUntil: 'networkidle' });
  expect([...hosts]).toEqual([new URL(baseURL!).origin]);
});

test('what a tab shows is loaded when it is opened', async ({ page }) => {
  const loaded: string[] = [];
  page.on('request', (request) => loaded.push(request.url()));
  await page.goto('./', { waitUntil: 'networkidle' });
  const values = builtFile('src/ui/parts/frame-tabs/values/values.tsx');
  const count = () => loaded.filter((url) => values.test(url)).length;
  expect(count()).toBe(0);
  await page.getByRole('tab', { name: 'Values' }).click();
  await expect.poll(count).toBeGreaterThan(0);
});

test('the policy that the README gives to hosts is that of the page, and forbids frames', async ({ page }) => {
  await page.goto('./');
  const built = await page.locator('meta[http-equiv=Content-Security-Policy]').getAttribute('content');
  const [, header = ''] = /Content-Security-Policy: (.*)/.exec(readFileSync('README.md', 'utf8')) ?? [];
  const rules = (policy: string) => policy.split('; ').sort();
  expect(rules(header)).toEqual(rules(`${built}; frame-ancestors 'none'`));
});
