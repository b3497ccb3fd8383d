import { expect, test, watch } from './page.ts';

test('what a page complains of is written down', async ({ browser, baseURL }) => {
  const context = await browser.newContext();
  const complaints: string[] = [];
  await watch(context, complaints);
  const page = await context.newPage();
  await page.goto(baseURL!);
  await page.evaluate(`console.warn('odd')`);
  await page.evaluate(() => {
    setTimeout(() => {
      throw new Error('never mind');
    });
    void fetch('./missing');
    const image = new Image();
    image.src = 'https://example.org/';
  });
  for (const complaint of [
    'console warning: odd',
    'thrown: never mind',
    `404: ${baseURL}missing`,
    expect.stringMatching(/^against the policy: img-src https:\/\/example.org/),
  ]) {
    await expect.poll(() => complaints).toContainEqual(complaint);
  }
  await context.close();
});

test.fail('fails on purpose: a test whose page complains', async ({ page }) => {
  await page.goto('./');
  const said = page.waitForEvent('console');
  await page.evaluate(`console.error('odd')`);
  await said;
});

test.describe('pages that share a context', () => {
  test.describe.configure({ mode: 'serial' });

  test('leave something behind', async ({ page }) => {
    await page.goto('./#rtu/request?functionCode=3');
    await page.emulateMedia({ colorScheme: 'dark' });
    await page.setViewportSize({ width: 320, height: 640 });
    await page.route('**/assets/**', (route) => route.abort());
    await page.addInitScript(() => Object.assign(globalThis, { left: 'behind' }));
    const left = await page.evaluate(async () => {
      localStorage.setItem('left', 'behind');
      sessionStorage.setItem('left', 'behind');
      await new Promise((resolve) => {
        indexedDB.open('left').onsuccess = resolve;
      });
      return (await indexedDB.databases()).length + localStorage.length + sessionStorage.length;
    });
    expect(left).toBeGreaterThanOrEqual(3);
  });

  test('find nothing of each other', async ({ page }) => {
    await page.goto('./');
    await expect(page.getByRole('button', { name: /^Copy / }).first()).toBeVisible();
    const found = await page.evaluate(async () => ({
      left: 'left' in globalThis,
      stored: [localStorage.getItem('left'), sessionStorage.getItem('left')],
      databases: (await indexedDB.databases()).map(({ name }) => name),
      dark: matchMedia('(prefers-color-scheme: dark)').matches,
      wide: innerWidth > 1000,
    }));
    expect(found).toEqual({ left: false, stored: [null, null], databases: [], dark: false, wide: true });
  });
});
