import { AxeBuilder } from './axe.ts';
import { FrameForm } from './form.ts';
import { allCame, expect, test } from './page.ts';

type Page = import('@playwright/test').Page;

const clipboard = (page: Page) => page.evaluate(() => navigator.clipboard.readText());
const strip = (page: Page) => page.getByRole('region', { name: 'The frame' });
const WRONG = './#rtu/request?unitId=6&functionCode=6&address=0x02AB&value=4096&force.checksum=0xA1E6';
const LONG = `./#rtu/request?unitId=17&functionCode=16&startAddress=0&registers=${Array.from({ length: 100 }, (_, n) => n).join('+')}`;

test('an entry of the list copies at once, and the format is remembered but not a missing checksum', async ({
  page,
}) => {
  await page.goto('./');
  const list = strip(page).getByRole('button', { name: 'Other formats' });
  for (const [format, text] of [
    ['C', 'const uint8_t write_683_4096[8] = { 0x06, 0x06, 0x02, 0xAB, 0x10, 0x00, 0xF5, 0xE5 };'],
    [
      'Structured Text',
      'Write683_4096 : ARRAY[0..7] OF BYTE := [16#06, 16#06, 16#02, 16#AB, 16#10, 16#00, 16#F5, 16#E5];',
    ],
    // 06 + 06 + 02 + AB + 10 + 00 = C9, whose two's complement is 37.
    ['ASCII line', ':060602AB100037'],
    ['Hexadecimal pairs', '06 06 02 AB 10 00 F5 E5'],
    ['Python', 'write_683_4096 = bytes([0x06, 0x06, 0x02, 0xAB, 0x10, 0x00, 0xF5, 0xE5])'],
  ] as const) {
    await list.click();
    await page
      .getByRole('menuitem', { name: new RegExp(`^${format}`) })
      .first()
      .click();
    await expect.poll(() => clipboard(page)).toBe(text);
    await expect(list).toBeFocused();
  }
  const copy = strip(page).getByRole('button', { name: /^Copy / });
  await expect(copy).toHaveText(/^Copy Python/);
  await list.press('Enter');
  await expect(page.getByRole('menuitem').first()).toBeFocused();
  await page.keyboard.press('End');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Escape');
  await expect(list).toBeFocused();
  await expect(copy).toContainText('no checksum');
  await copy.click();
  await expect.poll(() => clipboard(page)).toBe('write_683_4096 = bytes([0x06, 0x06, 0x02, 0xAB, 0x10, 0x00])');
  await page.reload();
  await expect(copy).toHaveText(/^Copy Python/);
  await expect(copy).not.toContainText('no checksum');
});

test('what was copied is said in the button, for a while, and nothing moves', async ({ page }) => {
  await page.clock.install();
  await page.goto('./');
  const copy = strip(page).getByRole('button', { name: /^(Copy |Copied)/ });
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
});

test('a wrong frame says why beside its verdict, offers the right one first, and copies with a warning', async ({
  page,
}) => {
  await page.goto(WRONG);
  await expect(strip(page)).toContainText('Wrong CRC');
  await expect(strip(page)).toContainText(
    'The WEG guide prints E6 A1 for this frame; that is a misprint. The CRC is F5 E5.',
  );
  await expect(strip(page).getByRole('listitem').last()).toContainText('should be F5 E5');
  await strip(page).getByRole('button', { name: 'Copy the wrong frame' }).click();
  await expect.poll(() => clipboard(page)).toBe('06 06 02 AB 10 00 E6 A1');
  await strip(page).getByRole('button', { name: /^Why/ }).click();
  const why = page.getByRole('dialog', { name: /^Why/ });
  await expect(why).toContainText('Serial Line §2.5.1.2');
  await expect(why.getByRole('heading', { level: 3 })).toHaveText(/^A known misprint/);
  await page.keyboard.press('Escape');
  await expect(why).toBeHidden();
  await strip(page).getByRole('button', { name: 'Use F5 E5' }).click();
  await expect(strip(page)).toContainText('Valid request');
  await new FrameForm(page).expectCopied('060602AB1000F5E5');
  await page.goBack();
  await expect(strip(page)).toContainText('Wrong CRC');
});

test('every byte is reached by arrow keys and typed in its place', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  const byte = (at: number) => form.strip.getByRole('button', { name: new RegExp(`^byte ${at},`) });
  await byte(0).focus();
  for (let at = 1; at < 8; at++) {
    await page.keyboard.press('ArrowRight');
    await expect(byte(at)).toBeFocused();
  }
  await expect(form.explanation.getByRole('row').filter({ hasText: 'Checksum.' })).toHaveAttribute('data-lit');
  // One stop for the Tab key.
  expect(await form.strip.locator('button.byte[tabindex="0"]').count()).toBe(1);
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowDown');
  await expect(byte(1)).toBeFocused();
  // Escape gives the byte back; digits are no commands of the page.
  await byte(4).focus();
  await page.keyboard.type('2');
  await page.keyboard.press('Escape');
  await expect(byte(4)).toHaveText(/^10/);
  await expect(byte(4)).toBeFocused();
  await page.keyboard.type('08');
  await page.keyboard.press('Enter');
  await expect(byte(4)).toBeFocused();
  await expect(form.field('value')).toHaveValue('2048');
  await form.expectCopied('060602AB0800FFE5');
  // A wrong checksum is taken as typed.
  await byte(7).click();
  await byte(7).click();
  await expect(form.strip.getByRole('textbox')).toBeFocused();
  await page.keyboard.type('A1');
  await page.keyboard.press('Tab');
  await expect(strip(page)).toContainText('Wrong CRC');
  await page.goBack();
  await expect(strip(page)).toContainText('Valid request');
});

test('the frame before stays, dimmed, where a field has no value, and nothing moves', async ({ page }) => {
  await page.goto('./');
  const form = new FrameForm(page);
  const top = () => form.field('value').evaluate((element) => element.getBoundingClientRect().top);
  await allCame(page);
  const before = await top();
  await form.field('value').fill('70000');
  await expect(strip(page)).toContainText('The frame before');
  await expect(strip(page)).toContainText('“Value” has no value that can be sent.');
  await expect(form.strip).toContainText('F5');
  await expect(strip(page).getByRole('button', { name: 'Copy the frame before' })).toBeVisible();
  expect(await top()).toBe(before);
  expect(await new AxeBuilder(page).findings()).toEqual([]);
});

test('the strip stays in sight at any size, and not on more than 35 % of it', async ({ page }) => {
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
    await page.goto(LONG);
    await expect(strip(page)).toContainText('Valid request');
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
  for (const [width, height] of [
    [320, 640],
    [640, 360],
    [1024, 768],
    [1280, 720],
    [2560, 1300],
  ] as const) {
    await page.setViewportSize({ width, height });
    for (const frame of frames) {
      const what = `${width} px, ${frame.slice(0, 60)}`;
      await page.goto(`./#${frame}`);
      const should = strip(page).getByText(/^should be .. ..$/);
      // The frame before may be there for a moment.
      await expect(async () => {
        const [, pair] = (await should.innerText()).match(/^should be (.. ..)$/) ?? [];
        expect(
          await strip(page)
            .getByRole('button', { name: `Use ${pair}` })
            .count(),
          what,
        ).toBe(1);
      }).toPass();
      await expect(strip(page).getByRole('group', { name: 'Request and reply' })).toHaveCount(
        frame.includes('answering') ? 1 : 0,
      );
      const cut = await strip(page).evaluate((section) =>
        [section, ...section.querySelectorAll('.strip-body, .strip-main, .strip-fields, .bytes')]
          .filter((box) => getComputedStyle(box).overflow !== 'visible')
          .filter((box) => box.scrollHeight > box.clientHeight + 1 || box.scrollWidth > box.clientWidth + 1)
          .map(({ className }) => className),
      );
      expect(cut, what).toEqual([]);
    }
  }
});

test('the explanation is copied as Markdown, as a table, and as a picture', async ({ page }) => {
  await page.goto('./');
  const choose = async (name: RegExp) => {
    await strip(page).getByRole('button', { name: 'Copies the explanation' }).click();
    await page.getByRole('menuitem', { name }).first().click();
  };
  await choose(/^Markdown/);
  await expect.poll(() => clipboard(page)).toMatch(/^\| byte \| hex \| dec\. \| bits \| means \| section \|/);
  await choose(/^Table/);
  await expect.poll(() => clipboard(page)).toContain('2–3\t02 AB\t683\t\tAddress. ');
  await choose(/^Picture/);
  await expect
    .poll(() => page.evaluate(async () => (await navigator.clipboard.read()).flatMap(({ types }) => types)))
    .toContain('image/png');
});
