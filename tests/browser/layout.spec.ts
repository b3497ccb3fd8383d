import { languages } from '#known';
import { FrameForm } from './form.ts';
import { layoutFaults } from './layout-faults.ts';
import { allCame, expect, test } from './page.ts';

const { page: words } = await languages.en.page();
const rules = { strip: words.bytes, focus: true };

const SPEED = 'rtu/request?unitId=6&functionCode=6&address=683&value=4096';

test('nothing is cut off, overlaps, is too small or hides under the strip, and what comes first is in sight', async ({
  page,
}) => {
  for (const [name, hash, hex] of [
    ['a good frame', SPEED, '06 06 02 AB 10 00 F5 E5'],
    ['a wrong CRC', `${SPEED}&force.checksum=0xA1E6`, '06 06 02 AB 10 00 E6 A1'],
  ] as const) {
    await page.setViewportSize({ width: 1280, height: 720 });
    await page.goto(`./#${hash}`);
    await new FrameForm(page).expectBytes(hex);
    await allCame(page);
    const first = { form: 'form.build' };
    expect(await page.evaluate(layoutFaults, { ...rules, first }), name).toEqual([]);
    await page.setViewportSize({ width: 390, height: 844 });
    await allCame(page);
    expect(await page.evaluate(layoutFaults, rules), `${name}, on a phone`).toEqual([]);
  }
});

test('nothing moves while the page comes, in a window and on a phone', async ({ page }) => {
  await page.addInitScript(() => {
    const moved: unknown[] = [];
    Object.assign(globalThis, { moved });
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) moved.push((entry as PerformanceEntry & { value: number }).value);
    }).observe({ type: 'layout-shift', buffered: true });
  });
  for (const size of [
    { width: 1350, height: 940 },
    { width: 412, height: 823 },
  ]) {
    await page.setViewportSize(size);
    await page.goto('./');
    await new FrameForm(page).expectBytes('06 06 02 AB 10 00 F5 E5');
    await allCame(page);
    expect(await page.evaluate(() => (globalThis as unknown as { moved: number[] }).moved)).toEqual([]);
  }
});
