import { builtFile } from './built-file.ts';
import { allCame, expect, test } from './page.ts';

test('the colours are chosen, kept, and there before anything is drawn', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'light' });
  await page.goto('./');
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await paper();
  await page.getByRole('combobox', { name: 'Colours' }).selectOption('Dark');
  await expect.poll(paper).not.toBe(light);
  // Without the page's own script, too.
  await page.route('**/assets/*.js', (route) => route.fulfill({ body: '', contentType: 'text/javascript' }));
  await page.reload();
  await expect(page.getByText('Framewright is loading')).toBeVisible();
  expect(await paper()).not.toBe(light);
});

test('the first stop of Tab skips the header, and the Frame view is found where it was left', async ({ page }) => {
  await page.setViewportSize({ width: 900, height: 400 });
  await page.goto('./#rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3');
  await expect(page.getByRole('tab', { name: 'Bytes' })).toBeVisible();
  await page.keyboard.press('Tab');
  const skip = page.getByRole('button', { name: 'Skip to the content' });
  await expect(skip).toBeFocused();
  await expect(skip).toBeInViewport();
  await page.keyboard.press('Enter');
  expect(await page.evaluate(() => document.activeElement?.id)).toBe('content');
  await expect(page).toHaveTitle('11 03 006B … · Framewright');

  await page.evaluate(() => scrollTo(0, 150));
  await page.keyboard.press('6');
  await expect(page.getByLabel('Speed, bits a second')).toBeVisible();
  expect(await page.evaluate(() => scrollY)).toBe(0);
  await page.goBack();
  await expect.poll(() => page.evaluate(() => scrollY)).toBe(150);
});

test('the sheet is printed by the menu of the browser, the first time too, and nothing else is', async ({ page }) => {
  await page.goto('./#rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3');
  await expect(page.getByRole('tab', { name: 'Bytes' })).toBeVisible();
  const printed = () =>
    page.evaluate(() => {
      Object.assign(globalThis, { sheets: [] });
      addEventListener('beforeprint', () => {
        // As the browser does, once the page had its say.
        queueMicrotask(() =>
          queueMicrotask(() => {
            const { sheets } = globalThis as unknown as { sheets: unknown[] };
            sheets.push(document.querySelector('.print-sheet svg') !== null);
          }),
        );
      });
    });
  await printed();
  const sheet = page.waitForRequest(builtFile('src/ui/parts/frame-tabs/wire/print-sheet.tsx'));
  await page.mouse.move(300, 300);
  await sheet;
  await allCame(page);
  await page.pdf();
  expect(await page.evaluate(() => (globalThis as unknown as { sheets: unknown[] }).sheets)).toEqual([true]);
  await expect(page.locator('.print-sheet')).toHaveCount(0);

  await page.emulateMedia({ media: 'print' });
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  await expect(page.getByRole('region', { name: 'Print this frame' }).getByRole('img')).toBeVisible();
  await expect(page.getByRole('banner')).toBeHidden();
  await expect(page.getByRole('tablist')).toBeHidden();
  await page.emulateMedia({ media: 'screen' });
});
