import { AxeBuilder } from './axe.ts';
import { FrameForm } from './form.ts';
import { allCame, expect, test } from './page.ts';

type Page = import('@playwright/test').Page;

const strip = (page: Page) => page.getByRole('region', { name: 'The frame' });
const LONG = `./#rtu/request?unitId=17&functionCode=16&startAddress=0&registers=${Array.from({ length: 100 }, (_, n) => n).join('+')}`;

test('nothing moves when a frame is copied, or when a field has no value and the frame before stays, dimmed', async ({
  page,
}) => {
  await page.clock.install();
  await page.goto('./');
  const copy = strip(page).getByRole('button', { name: /^(Copy (hex|the)|Copied)/ });
  const boxes = () =>
    page.evaluate(() =>
      [...document.querySelectorAll('.strip button, .build input')].map((element) =>
        element.getBoundingClientRect().toJSON(),
      ),
    );
  await expect(copy).toBeVisible();
  await allCame(page);
  const before = await boxes();
  await copy.click();
  await expect(copy).toHaveAccessibleName('Copied');
  expect(await boxes()).toEqual(before);
  await page.clock.runFor(2500);
  await expect(copy).toHaveAccessibleName(/^Copy /);
  expect(await boxes()).toEqual(before);

  const value = new FrameForm(page).field('value');
  const top = () => value.evaluate((element) => element.getBoundingClientRect().top);
  const stood = await top();
  await value.fill('70000');
  await expect(copy).toHaveAccessibleName('Copy the frame before');
  expect(await top()).toBe(stood);
  expect(await page.evaluate(() => document.getAnimations().length)).toBe(0);
  expect(await new AxeBuilder(page).findings()).toEqual([]);
});

test('the strip stays in sight at any size, and not on more than 35 % of it', async ({ page }) => {
  await page.goto(LONG);
  await expect(strip(page)).toContainText('Valid request');
  for (const [width, height] of [
    [1280, 720],
    [1400, 900],
    [1024, 768],
    [2560, 1300],
    [390, 844],
    [320, 640],
    [640, 400],
  ] as const) {
    await page.setViewportSize({ width, height });
    await page.evaluate(() => scrollTo(0, 0));
    // Not by the wheel: where the mouse was left, something else may scroll.
    await page.evaluate(() => scrollTo(0, 2000));
    const head = page.getByText('Valid request', { exact: true });
    await expect(head).toBeInViewport();
    const tall = () =>
      page.evaluate(() => {
        const shown = ['.strip', '.strip-head', '.strip-body'].flatMap((name) => {
          const element = document.querySelector(name);
          const box = element?.getBoundingClientRect();
          return element && box && box.height > 0 && box.top < innerHeight && box.bottom > 0 ? [box.bottom] : [];
        });
        return Math.max(...shown) / innerHeight;
      });
    await expect.poll(tall, `${width} x ${height}`).toBeLessThanOrEqual(0.36);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  }

  // All bytes of registers that are unfolded are equally wide, and no line breaks inside a register.
  const registers = new FrameForm(page).strip.locator('[data-kind="registers"]');
  await registers.getByRole('button', { name: / more/ }).click();
  await expect(registers.locator('.byte[data-from]')).toHaveCount(200);
  const bytes = await registers
    .locator('.byte')
    .evaluateAll((cells) =>
      cells.map((cell) => cell.getBoundingClientRect()).map(({ top, width }) => ({ top, width: Math.round(width) })),
    );
  expect(new Set(bytes.map(({ width }) => width)).size).toBe(1);
  expect(new Set(bytes.map(({ top }) => top)).size).toBeGreaterThan(1);
  expect(bytes.filter(({ top }, at) => at % 2 === 1 && top !== bytes[at - 1]?.top)).toEqual([]);
});

test('nothing of a long frame is cut: neither its bytes nor the checksum that it should have, alone or paired', async ({
  page,
}) => {
  const values = (bytes: number) => Array.from({ length: bytes >> 1 }, (_, n) => n).join('+');
  const wrong = '&force.checksum=0x1234';
  const frames = [
    `rtu/request?unitId=6&functionCode=6&address=683&value=4096${wrong}`,
    `rtu/reply?unitId=6&functionCode=6&address=683&value=4096&answering=060602AB1000F5E5${wrong}`,
    ...[30, 255].flatMap((size) => [
      `rtu/request?unitId=17&functionCode=16&startAddress=0&registers=${values(size - 9)}${wrong}`,
      `rtu/reply?unitId=17&functionCode=3&registers=${values(size - 5)}&answering=1103006B000676C5${wrong}`,
    ]),
  ];
  for (const frame of frames) {
    await page.goto(`./#${frame}`);
    const should = strip(page).getByText(/^should be .. ..$/);
    // The frame before may be there for a moment.
    await expect(async () => {
      const [, pair] = (await should.innerText()).match(/^should be (.. ..)$/) ?? [];
      expect(
        await strip(page)
          .getByRole('button', { name: `Use ${pair}` })
          .count(),
        frame,
      ).toBe(1);
    }).toPass();
    await expect(strip(page).getByRole('group', { name: 'Request and reply' })).toHaveCount(
      frame.includes('answering') ? 1 : 0,
    );
    for (const [width, height] of [
      [320, 640],
      [640, 360],
      [1024, 768],
      [1280, 720],
      [2560, 1300],
    ] as const) {
      await page.setViewportSize({ width, height });
      const what = `${width} px, ${frame.slice(0, 60)}`;
      await expect(should, what).toBeVisible();
      const cut = await strip(page).evaluate(async (section) => {
        // What follows the size of the window is drawn one frame later.
        await new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)));
        return [section, ...section.querySelectorAll('.strip-body, .strip-main, .strip-fields, .bytes')]
          .filter((box) => getComputedStyle(box).overflow !== 'visible')
          .filter((box) => box.scrollHeight > box.clientHeight + 1 || box.scrollWidth > box.clientWidth + 1)
          .map(({ className }) => className);
      });
      expect(cut, what).toEqual([]);
    }
  }
});

test('the explanation is copied as a picture', async ({ page }) => {
  await page.goto('./');
  await strip(page).getByRole('button', { name: 'Copies the explanation' }).click();
  await page
    .getByRole('menuitem', { name: /^Picture/ })
    .first()
    .click();
  await expect
    .poll(() => page.evaluate(async () => (await navigator.clipboard.read()).flatMap(({ types }) => types)))
    .toContain('image/png');
});
