import { languages } from '#known';
import { AxeBuilder } from './axe.ts';
import { FrameForm } from './form.ts';
import { expect, test } from './page.ts';

const words = await languages.en.values();

test('at 1280 by 720 the fields stand in sight, in one line each, and look like what they are', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 720 });
  await page.goto('./');
  const form = new FrameForm(page);
  const fields = [
    page.getByRole('combobox', { name: 'Function', exact: true }),
    form.field('unitId'),
    form.field('address'),
    form.field('value'),
  ];
  await expect(fields[3]!).toBeVisible();
  const looks = await Promise.all(
    fields.map((field) =>
      field.evaluate((element) => {
        const { left, bottom } = element.getBoundingClientRect();
        const { color, opacity } = getComputedStyle(element);
        return { left, bottom, color, opacity };
      }),
    ),
  );
  expect(Math.max(...looks.map(({ bottom }) => bottom))).toBeLessThanOrEqual(720);
  expect(new Set(looks.map(({ left }) => left)).size).toBe(1);
  const ink = await page.evaluate(() => getComputedStyle(document.body).color);
  for (const { color, opacity } of looks) expect([color, opacity]).toEqual([ink, '1']);
  // Where a rule stands shows while the field has the focus.
  const value = form.field('value');
  await value.fill('70000');
  const section = page.getByRole('form').getByText('§6.6').first();
  await expect(section).toHaveCSS('opacity', '1');
  await form.field('unitId').focus();
  await expect(section).toHaveCSS('opacity', '0');
});

test('axe finds nothing where fields say more and where frames are compared, and 320 px are wide enough', async ({
  page,
}) => {
  await page.setViewportSize({ width: 320, height: 640 });
  await page.addInitScript(() => localStorage.setItem('framewright.device', JSON.stringify('weg-drive')));
  const axe = new AxeBuilder(page);
  const open = (hash: string, colorScheme: 'light' | 'dark') =>
    page.emulateMedia({ colorScheme }).then(() => page.goto(`./#${hash}`));
  const expectNothing = async (what: string) => {
    expect(await axe.findings(), what).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth), what).toBeLessThanOrEqual(320);
  };

  await open('rtu/request?unitId=17&functionCode=16&startAddress=1&registers=7', 'light');
  await new FrameForm(page).field('registers').fill('f32 21,5');
  await expect(page.getByText('The comma is a decimal comma')).toBeVisible();
  await expectNothing('a decimal comma');

  await open('rtu/request?unitId=6&functionCode=6&address=682&value=3', 'light');
  await expect(page.getByRole('checkbox', { name: words.namedBit(1, 'general enable') })).toBeChecked();
  await expectNothing('names of bits');

  await open('rtu/request?functionCode=22&referenceAddress=682&andMask=0xFFFF&v=3&tab=values', 'dark');
  await page.getByRole('combobox', { name: words.namedBit(0, 'run') }).press('s');
  await expect(page.getByLabel(words.setBits, { exact: true })).toHaveValue('0');
  await expectNothing('masks');

  await open('pdu/request?functionCode=3&startAddress=0x6B&quantity=3', 'dark');
  await page.getByRole('button', { name: /^All ways to write it/ }).click();
  await page.getByLabel('Your manual’s convention').selectOption('Five or six digits');
  await expectNothing('all ways to write an address');

  await open('rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3&v=3&tab=compare', 'light');
  await page.getByLabel('What your device sent').fill('FF 11 03 00 6A 00 03 74 27 00 00 00 00 00 00 00 00 00 00');
  await expect(page.getByRole('list', { name: 'Differences' }).getByRole('listitem')).not.toHaveCount(0);
  await expectNothing('a comparison');
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await axe.findingsOfColours()).toEqual([]);
});
