import { expect, type Page, test } from '@playwright/test';
import { views } from '../../src/words/index.ts';

const message = (page: Page, text: string) => page.getByRole('alert').filter({ hasText: text });

test('a part that cannot be fetched says so at its place, and comes when it can be', async ({ page }) => {
  const parts = /\/assets\/(compare-panel|reference-view)-[^/]*\.(js|css)$/;
  await page.route(parts, (route) => route.abort());
  await page.goto('./');
  const missing = message(page, views.missing);
  await expect(missing).toHaveCount(1);
  await expect(page.getByLabel('Bytes', { exact: true })).toBeVisible();

  await missing.getByRole('button', { name: views.tryAgain }).click();
  const explained = message(page, views.missingWhy);
  await expect(explained.getByRole('button', { name: views.reload })).toBeVisible();

  await page.getByRole('link', { name: views.names.reference }).click();
  await expect(missing).toHaveCount(1);
  await expect(explained).toHaveCount(0);
  await page.unroute(parts);
  await missing.getByRole('button', { name: views.tryAgain }).click();
  await expect(page.getByRole('searchbox')).toBeVisible();
  await expect(page.getByRole('alert')).toHaveCount(0);

  await page.getByRole('link', { name: views.names.frame, exact: true }).click();
  await expect(page.getByText('Compare', { exact: false }).first()).toBeVisible();
  await expect(page.getByRole('alert')).toHaveCount(0);
  const styles = await page.evaluate(() =>
    [...document.styleSheets].flatMap(({ href }) => /(compare-panel|reference-view)/.exec(href ?? '')?.[1] ?? []),
  );
  expect(styles.sort()).toEqual(['compare-panel', 'reference-view']);
});

test('sentences and tools that cannot be fetched are missed, and the form works on', async ({ page }) => {
  const parts = /\/assets\/(en-)?tools-[^/]*\.(js|css)$/;
  await page.route(parts, (route) => route.abort());
  await page.goto('./#rtu/request?unitId=1&functionCode=6&address=1&value=2');
  const missing = message(page, views.missing);
  await expect(missing).toHaveCount(1);
  await page.getByLabel('Value', { exact: true }).fill('3');
  await expect(page.getByRole('button', { name: /^Copy / })).toHaveCount(0);
  await page.unroute(parts);
  await missing.getByRole('button', { name: views.tryAgain }).click();
  await expect(page.getByRole('button', { name: /^Copy / })).toBeVisible();
  await expect(page.getByLabel('Value', { exact: true })).toHaveValue('3');
  await expect(page.getByRole('alert')).toHaveCount(0);
});
