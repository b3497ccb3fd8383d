import { languages } from '../../src/words/index.ts';
import { FrameForm } from '../browser/form.ts';
import { reply, ValuesTab } from '../browser/values-tab.ts';
import { expect, test } from './page.ts';

const words = await languages.en.values();
const { writeValues } = (await languages.en.page()).page;

test('the registers of a reply in every type and order, and the expected value found', async ({ page }) => {
  const values = new ValuesTab(page);
  await page.goto(`./${reply}`);
  await expect(values.marked.getByRole('listitem')).toHaveText([/^77\.5146 f32 CDAB A float with few digits/]);
  const wide = values.table(2);
  await expect(wide.getByRole('row', { name: /^CDAB/ })).toContainText('0x429B077A');
  await expect(wide.getByRole('row', { name: /^ABCD/ })).toContainText('125452955');
  await expect(values.table(4).getByRole('row', { name: /^HGFEDCBA/ })).toContainText('4503602232195591');

  const expected = page.getByLabel(words.expected, { exact: true });
  await expected.fill('77.5');
  await expect(values.marked.getByRole('listitem').first()).toContainText(words.likely({ code: 'expected-rounded' }));
  await expected.fill('pump');
  await page.getByRole('button', { name: words.goTo('40112, address 111') }).click();
  await expect(page.getByLabel(words.first, { exact: true })).toHaveValue('4');
  await expect(values.marked.getByRole('listitem').first()).toContainText('"PUMP" text ABCD');
  await expected.fill('12345');
  await expect(values.panel).toContainText(words.notFound);

  // What stands for bytes lights them.
  await values.table(1).getByRole('row', { name: /^AB/ }).hover();
  const lit = new FrameForm(page).strip.locator('.byte[data-lit]');
  await expect(lit).toHaveText([/^50/, /^55/]);
});

test('a scale both ways, and the tab in the link', async ({ page }) => {
  const values = new ValuesTab(page);
  await page.goto(`./${reply}`);
  // A drive's 8192 for 60 Hz.
  await page.getByLabel(words.first, { exact: true }).selectOption('3');
  await values.openScale();
  await page.getByLabel(words.scaleLabels.factor, { exact: true }).fill('60/0');
  await expect(page.getByText(words.scaleFaults.factor)).toBeVisible();
  await page.getByLabel(words.scaleLabels.factor, { exact: true }).fill('60/8192');
  await expect(page.getByText('stands for 30.0', { exact: true })).toBeVisible();
  await page.getByLabel(words.inUnits, { exact: true }).fill('50');
  await expect(page.getByText('is raw 6827 (0x1AAB), rounded: it stands for 50.00244', { exact: true })).toBeVisible();

  // The tab is in the link, and a frame that gets shorter leaves no register behind.
  await new FrameForm(page).field('registers').fill('5');
  await expect(page.getByLabel(words.first, { exact: true })).toHaveValue('0');
  await expect(values.table(2)).toHaveCount(0);
  await page.reload();
  await expect(values.panel).toBeVisible();
});

test('typed values become registers, and what is wrong with them is said before', async ({ page }) => {
  const values = new ValuesTab(page);
  const apply = page.getByRole('button', { name: words.apply });
  await page.goto('./#rtu/request?functionCode=16&registers=1+2');
  const form = new FrameForm(page);
  await page.getByRole('button', { name: writeValues }).click();
  await expect(apply).toBeDisabled();
  await values.typed.fill('f32 CDAB 21.5\nu16 70000');
  await expect(page.getByText('70000 does not fit into u16: 0 to 65535.')).toBeVisible();
  await expect(apply).toBeDisabled();
  await values.typed.fill('f32 CDAB 21.5\nf32 16777217, f64 NaN\ntext "PUMP"');
  await expect(page.getByText('16777217 is rounded: the registers hold 16777216.')).toBeVisible();
  await expect(page.getByText('NaN is not a finite number.')).toBeVisible();
  await values.typed.fill('f32 CDAB 21.5\ntext "PUMP"');
  await values.typed.press('Tab');
  await page.keyboard.press('Enter');
  await expect(form.field('registers')).toHaveValue('0x0000 0x41AC 0x5055 0x4D50');
  await expect(form.strip).toContainText('AC');
  await page.goBack();
  await expect(form.field('registers')).toHaveValue('1 2');

  // A single register takes one.
  await form.chooseFunction(6);
  await page.getByRole('button', { name: writeValues }).click();
  await expect(page.getByText(words.onlyOne(4))).toBeVisible();
  await values.typed.fill('i16 -5');
  await apply.click();
  await expect(form.field('value')).toHaveValue('0xFFFB');
  await form.chooseFunction(3);
  await expect(values.typed).toHaveCount(0);
});

test('masks from bits to set and to clear', async ({ page }) => {
  await page.goto('./#rtu/request?functionCode=22&referenceAddress=4&andMask=0x00F2&orMask=0x0025&v=3&tab=values');
  const form = new FrameForm(page);
  const set = page.getByLabel(words.setBits, { exact: true });
  const clear = page.getByLabel(words.clearBits, { exact: true });
  const current = page.getByLabel(words.current, { exact: true });
  await expect(set).toHaveValue('0, 2');
  await expect(clear).toHaveValue('3, 8-15');
  // The example of the specification.
  await current.fill('12h');
  await expect(page.getByText('23, 0x0017, 0000 0000 0001 0111')).toBeVisible();
  await set.fill('0, 16');
  await expect(page.getByText(words.notABit('16'))).toBeVisible();
  await expect(page.getByRole('button', { name: words.useMasks })).toBeDisabled();
  await set.fill('0, 3');
  await expect(page.getByText(words.bothWays('3'))).toBeVisible();
  await clear.fill('4');
  await current.fill('x');
  await expect(page.getByText(words.notARegister('x'))).toBeVisible();
  await current.fill('0x0010');
  await expect(page.getByText('9, 0x0009, 0000 0000 0000 1001')).toBeVisible();
  const truth = page.getByRole('table', { name: words.truth });
  await expect(truth.getByRole('row').nth(3)).toHaveText('0000cleared4');
  await page.getByRole('button', { name: words.useMasks }).click();
  await expect(form.field('andMask')).toHaveValue('0xFFE6');
  await expect(form.field('orMask')).toHaveValue('0x0009');
  await page.goBack();
  await expect(set).toHaveValue('0, 2');
});
