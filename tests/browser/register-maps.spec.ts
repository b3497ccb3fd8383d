import { languages } from '#known';
import { AxeBuilder } from './axe.ts';
import { expect, test } from './page.ts';
import { MAP, RegisterMaps } from './register-maps.ts';

const words = await languages.en.library();

test('of a map of thousands of registers the rows in sight are drawn, and a cell far down is edited', async ({
  page,
}) => {
  const maps = new RegisterMaps(page);
  await page.goto('./#devices');
  const rows = Array.from({ length: 5000 }, (_, at) => `Register ${at},holding-register,${at},u16,V`);
  await maps.choose('Long.csv', `name,table,address,type,unit\n${rows.join('\n')}\n`);
  await maps.keep();
  const drawn = maps.registers.locator('tbody tr');
  await expect(drawn.first()).toContainText('Register 0');
  expect(await drawn.count()).toBeLessThan(60);
  await drawn.first().locator('[data-column="unit"]').focus();
  await page.keyboard.press('Control+End');
  const last = drawn.filter({ hasText: 'Register 4999' }).locator('[data-column="unit"]');
  await expect(last).toBeFocused();
  await expect(last).toBeInViewport();
  await page.keyboard.press('Enter');
  await page.keyboard.type('kV');
  await page.keyboard.press('Enter');
  await expect(last).toHaveText('kV');
  // A text that is wrong stays, though its row is scrolled away and comes back.
  await drawn.filter({ hasText: 'Register 4990' }).locator('[data-column="name"]').dblclick();
  const name = page.getByRole('textbox', { name: 'Name of Register 4990' });
  await name.fill(' ');
  await page.keyboard.press('Enter');
  await expect(name).toHaveAccessibleDescription('Name is missing.');
  await drawn.filter({ hasText: 'Register 4991' }).locator('[data-column="unit"]').focus();
  await page.keyboard.press('Control+Home');
  await expect(drawn.filter({ hasText: /^Register 0/ }).locator('[data-column="unit"]')).toBeFocused();
  await page.keyboard.press('Control+End');
  await expect(name).toHaveValue(' ');
  await expect(name).toBeInViewport();
});

test('at 390 and 320 px the requests of each register are in sight; axe finds nothing, nor with values and an import', async ({
  page,
}) => {
  const maps = new RegisterMaps(page);
  await page.setViewportSize({ width: 390, height: 844 });
  await page.goto('./#devices');
  await maps.openDevice(/^WEG drive/);
  const buttons = maps.registers.getByRole('button');
  await expect(maps.registers.getByRole('button', { name: 'Read P0683 speed reference' })).toBeVisible();
  for (const width of [390, 320]) {
    await page.setViewportSize({ width, height: 844 });
    await expect(buttons).toHaveCount(12);
    const ends = await buttons.evaluateAll((all) =>
      all.map((each) => each.getBoundingClientRect()).flatMap(({ left, right }) => [left, right]),
    );
    expect(Math.min(...ends)).toBeGreaterThanOrEqual(0);
    expect(Math.max(...ends)).toBeLessThanOrEqual(width);
    const sideways = await maps.registers.evaluate(
      (group) =>
        [group, ...group.querySelectorAll('div, table'), document.documentElement].filter(
          ({ scrollWidth, clientWidth }) => scrollWidth > clientWidth,
        ).length,
    );
    expect(sideways).toBe(0);
    const [read, write] = await Promise.all(
      ['Read', 'Write'].map((act) => maps.registers.getByRole('button', { name: `${act} P0683` }).boundingBox()),
    );
    expect(read?.y).toBe(write?.y);
  }
  await maps.registers.getByLabel('In the order of').selectOption({ label: 'Unit' });
  await expect
    .poll(() => maps.names())
    .toEqual(['P0681 actual speed', 'P0683 speed reference', 'P0682 control word', 'P0685 direction']);
  const axe = new AxeBuilder(page);
  expect(await axe.findings()).toEqual([]);
  await page.setViewportSize({ width: 1280, height: 720 });
  await maps.registers.getByRole('link', { name: words.toBus }).click();
  await page.getByRole('navigation').getByRole('link', { name: 'Devices' }).click();
  await maps.registers.getByRole('button', { name: words.toVirtual }).click();
  await maps.registers.getByRole('button', { name: words.readAll(4) }).click();
  await expect(maps.registers.getByRole('status')).toContainText('4 of 4 values read.');
  await maps.choose('WP 12.csv', MAP);
  expect(await axe.findings()).toEqual([]);
});
