import { FrameForm } from '../browser/form.ts';
import { test } from './page.ts';

test('what is typed before the view that opens has been painted is read, also when the view is left at once', async ({
  page,
}) => {
  await page.goto('./#timing');
  await page.getByRole('link', { name: 'Frame', exact: true }).click();
  await page.getByRole('link', { name: 'Timing', exact: true }).click();
  await page.evaluate(async () => {
    const link = (name: string) => [...document.querySelectorAll('a')].find(({ textContent }) => textContent === name);
    link('Frame')?.click();
    let input: HTMLTextAreaElement | null = null;
    while (input === null) {
      await Promise.resolve();
      input = document.querySelector('main textarea');
    }
    input.focus();
    input.value = '09 03 00 00 00 01 85 42';
    input.dispatchEvent(new InputEvent('input', { bubbles: true }));
  });
  await page.getByRole('link', { name: 'Timing', exact: true }).click();
  await page.getByRole('link', { name: 'Frame', exact: true }).click();
  await new FrameForm(page).expectBytes('09 03 00 00 00 01 85 42');
});
