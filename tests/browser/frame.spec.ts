import { AxeBuilder } from './axe.ts';
import { FrameForm } from './form.ts';
import { allCame, expect, test } from './page.ts';

test('a paste is read after a click beside the input, where the caret of the browser stays; axe finds nothing, with and without a frame, and at 320 px nothing is wider than the page', async ({
  page,
}) => {
  await page.goto('./#rtu/request?unitId=2&functionCode=3&startAddress=400&quantity=5');
  await page.getByRole('main').click({ position: { x: 2, y: 2 } });
  await page.evaluate((content) => navigator.clipboard.writeText(content), '06 06 02 AB 10 00 F5 E5');
  await page.keyboard.press('Control+V');
  await new FrameForm(page).expectBytes('06 06 02 AB 10 00 F5 E5');

  for (const [colorScheme, hash] of [
    ['light', '#rtu/request?unitId=0&functionCode=3&startAddress=65535&quantity=126'],
    ['dark', '#tcp/reply?functionCode=43&meiType=14&objects=2&moreFollows=0&nextObjectId=5&force.length=3'],
    ['light', '#ascii/request?functionCode=15&bits=1 0 1&unitId=abc'],
    ['dark', '#rtu/request?functionCode=6&value=70000'],
  ] as const) {
    await page.emulateMedia({ colorScheme });
    await page.goto(`./${hash}`);
    await expect(page.getByRole('heading', { name: 'Build' })).toBeVisible();
    expect(await new AxeBuilder(page).findings()).toEqual([]);
  }
  await page.setViewportSize({ width: 320, height: 640 });
  for (const hash of [
    'rtu/request?functionCode=6',
    'ascii/request?functionCode=16&registers=1 2 3 4 5 6 7 8',
    'tcp/reply?functionCode=43&meiType=14',
  ]) {
    await page.goto(`./#${hash}`);
    await expect(page.getByRole('heading', { name: 'Build' })).toBeVisible();
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
  }
});

test('the page works from any folder', async ({ page, baseURL }) => {
  const { origin } = new URL(baseURL!);
  await page.route('**/deep/folder/**', async (route) => {
    const path = new URL(route.request().url()).pathname.replace('/deep/folder/', '/');
    await route.fulfill({ response: await route.fetch({ url: origin + path }) });
  });
  await page.goto(`${origin}/deep/folder/#rtu/request?unitId=1&functionCode=3&startAddress=0&quantity=126`);
  await expect(page.getByText('The quantity is 126. Legal are 1 to 125.').first()).toBeVisible();
  await expect(new FrameForm(page).strip).toBeVisible();
  // What comes behind the first view comes from there too.
  await allCame(page);
  await expect(page.getByRole('table', { name: 'Every byte' })).toBeVisible();
  await page.unrouteAll({ behavior: 'wait' });
});
