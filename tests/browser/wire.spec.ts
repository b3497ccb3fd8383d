import { readFile } from 'node:fs/promises';
import { languages } from '#known';
import { AxeBuilder } from './axe.ts';
import { FrameForm } from './form.ts';
import { expect, test } from './page.ts';
import { request, WireTab } from './wire-tab.ts';

const words = await languages.en.wire();

test('the wheel zooms at the pointer, and the picture is saved as an SVG that stands alone, and as a PNG of twice its size', async ({
  page,
}) => {
  const wire = new WireTab(page);
  await wire.open(request);
  await expect(wire.pairs).toHaveCount(8);
  await wire.picture.locator('.character').nth(6).hover();
  await expect(new FrameForm(page).strip.locator('.byte[data-lit]')).toHaveText([/^74/]);
  await page.keyboard.down('Control');
  for (let step = 0; step < 6; step++) await page.mouse.wheel(0, -100);
  await page.keyboard.up('Control');
  await expect(wire.pairs.filter({ hasText: '74' })).toHaveCount(1);
  await expect(wire.pairs).not.toHaveCount(8);
  await wire.panel.getByRole('region', { name: words.view }).focus();
  await page.keyboard.press('End');
  await expect(wire.pairs).toHaveCount(0);

  await wire.button(words.zoomTo.all).click();
  await wire.button(words.zoomTo.frame).click();
  await expect(wire.pairs).toHaveCount(8);
  await page.emulateMedia({ colorScheme: 'dark' });
  const saved = async (name: string) => {
    const download = page.waitForEvent('download');
    await wire.button(name).click();
    return readFile(await (await download).path());
  };
  const svg = (await saved(words.saveSvg)).toString();
  await expect(wire.panel).toContainText(words.saved('framewright-rtu.svg'));
  const alone = await page.context().newPage();
  await alone.goto(`data:image/svg+xml;base64,${Buffer.from(svg).toString('base64')}`);
  const said = await alone.evaluate(() => {
    const texts = [...document.querySelectorAll('text')];
    return {
      root: document.documentElement.tagName,
      width: document.documentElement.getAttribute('width'),
      pairs: texts.filter((each) => each.getAttribute('class') === 'pair').map((each) => each.textContent),
      fills: [...new Set(texts.map((each) => each.getAttribute('fill')))],
      waves: [...document.querySelectorAll('path.wave')].map((each) => each.getAttribute('stroke')),
      sizes: [...new Set(texts.map((each) => each.getAttribute('font-size')))].every((size) =>
        /^\d+px$/.test(size ?? ''),
      ),
    };
  });
  expect(said.root).toBe('svg');
  expect(said.width).toBe('1200');
  expect(said.pairs).toEqual(['01', '03', '00', '6B', '00', '03', '74', '17']);
  // Dark ink on white paper, whatever the page has, and no variables of the page.
  expect(new Set(said.waves)).toEqual(new Set(['rgb(27, 29, 31)']));
  expect(said.fills.every((fill) => /^rgb\(/.test(fill ?? ''))).toBe(true);
  expect(said.sizes).toBe(true);
  expect(svg).not.toContain('var(');

  const png = await saved(words.savePng);
  expect(png.subarray(1, 4).toString()).toBe('PNG');
  expect(png.readUInt32BE(16)).toBe(2400);
});

test('axe finds nothing in what a receiver reads, and in ASCII and TCP at 320 px, where nothing is wider than the page', async ({
  page,
}) => {
  const wire = new WireTab(page);
  await wire.open(request);
  await wire.entry(words.receiver).selectOption(words.receivers.own);
  await wire.entry(words.receiverSpeed).fill('9600');
  await wire.panel.getByText(words.received).click();
  await expect(wire.picture.locator('.received[data-error]')).not.toHaveCount(0);
  // A byte alone has all kinds of parts that the whole has, and is checked sooner.
  await wire.button(words.zoomTo.byte).click();
  const axe = new AxeBuilder(page);
  expect(await axe.findings('[role=tabpanel]:not([hidden])')).toEqual([]);

  await page.setViewportSize({ width: 320, height: 700 });
  const width = () => page.evaluate(() => document.documentElement.scrollWidth);
  await wire.open('#ascii/request?unitId=1&functionCode=3&startAddress=0x6B&quantity=3');
  await expect(wire.pairs.first()).toHaveText(':');
  await wire.panel.getByText(words.table).click();
  expect(await width()).toBeLessThanOrEqual(320);
  await new FrameForm(page).choose('Transport', 'TCP');
  await expect(wire.panel.getByRole('img', { name: words.packet.picture(12) })).toBeVisible();
  expect(await width()).toBeLessThanOrEqual(320);
  expect(await axe.findings()).toEqual([]);
});
