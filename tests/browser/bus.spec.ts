import { AxeBuilder } from './axe.ts';
import { Bus, READ_33 } from './bus-view.ts';
import { allCame, expect, test } from './page.ts';

test('the view, and what scans, listens, polls and sends in sequence, has no fault that axe knows, light and dark, also at 320 px', async ({
  page,
}) => {
  const bus = new Bus(page);
  await bus.open(READ_33);
  await bus.openDevices();
  await bus.button('Ask for this fault').click();
  await bus.button('Ask for this fault').click();
  await bus.waitAtMost(100);
  await bus.send('No device answered: unit ');
  await expect(page.getByRole('region', { name: 'Who hears what' })).toContainText('Unit 33');
  await expect(page.getByLabel('Value at 0', { exact: true })).toBeVisible();
  const axe = new AxeBuilder(page);
  expect(await axe.findings()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await axe.findingsOfColours()).toEqual([]);
  await page.setViewportSize({ width: 320, height: 700 });
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320);
  expect(await axe.findings()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'light' });
  expect(await axe.findingsOfColours()).toEqual([]);

  await page.setViewportSize({ width: 1280, height: 720 });
  await bus.tab('Scan');
  await page.getByLabel('Addresses of a unit').check();
  await page.getByLabel('Unit to scan').fill('33');
  await page.getByLabel('First address').fill('990');
  await page.getByLabel('Last address').fill('1010');
  await bus.button('Start the scan').click();
  await expect(page.getByText('The scan is complete.')).toBeVisible();
  expect(await axe.findings()).toEqual([]);

  await bus.tab('Listen');
  await bus.button('Listen').click();
  await expect(page.getByText('Nothing has been heard yet.')).toBeVisible();
  await bus.tab('Poll');
  await bus.button('Start').click();
  await expect(page.locator('.poll').getByText('Not sent: this page is listening')).toBeVisible();
  expect(await axe.findings()).toEqual([]);

  await page.setViewportSize({ width: 320, height: 900 });
  await bus.tab('Sequence');
  const panel = page.locator('.sequence');
  await panel
    .getByRole('group', { name: 'Add to the steps' })
    .getByRole('button', { name: 'Add a repetition' })
    .click();
  await panel.getByRole('group', { name: 'Add into Step 6' }).getByRole('button', { name: 'Add a frame' }).click();
  await expect(panel.getByText('A value is needed here.')).toBeVisible();
  expect(await axe.findings()).toEqual([]);
  await page.emulateMedia({ colorScheme: 'dark' });
  expect(await axe.findingsOfColours()).toEqual([]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320);
});

test('what comes is in sight after Send: in a window, where nothing moves the log, and on a phone, where the field of who types is, too, and the row that is chosen', async ({
  page,
}) => {
  const bus = new Bus(page);
  await page.goto('./#bus');
  const rules = page.getByRole('group', { name: 'Transactions' });
  const quiet = rules.getByRole('checkbox', { name: 'Quiet after a time-out' });
  const hint = rules.getByText('A request that a late reply could answer');
  for (const width of [1280, 390]) {
    await page.setViewportSize({ width, height: 844 });
    const [whole, above, below] = await Promise.all([rules, quiet, hint].map((one) => one.boundingBox()));
    expect(below!.y).toBeGreaterThanOrEqual(above!.y + above!.height);
    expect(below!.width).toBeGreaterThan(0.8 * whole!.width);
  }

  await page.setViewportSize({ width: 1280, height: 720 });
  await bus.open(READ_33);
  for (const [width, height] of [
    [1280, 720],
    [1400, 900],
  ] as const) {
    await page.setViewportSize({ width, height });
    await allCame(page);
    const top = async () => (await bus.log.boundingBox())!.y;
    const before = await top();
    await bus.send('Answered.');
    await expect(bus.reply.getByText('Answered.')).toBeInViewport({ ratio: 1 });
    await expect(bus.reply.getByText('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18')).toBeInViewport({ ratio: 1 });
    expect(await top()).toBe(before);
    // An eight-byte frame is not cut.
    const hex = bus.lines.first().getByText('21 03 03 E7 00 04 F3 1A');
    await expect(hex).toBeInViewport({ ratio: 1 });
    expect(await hex.evaluate((element) => element.scrollWidth <= element.clientWidth)).toBe(true);
    await bus.take('rtu/request?unitId=5&functionCode=3&startAddress=0&quantity=4');
    await bus.send('No device answered: unit 5');
    const heading = page.getByRole('heading', { name: /^No device answered/ });
    await expect(heading).toBeInViewport({ ratio: 1 });
    await expect(heading).toBeFocused();
    await expect(bus.button('Try units 1–247')).toBeInViewport({ ratio: 1 });
    expect(await top()).toBe(before);
    expect(await page.evaluate(() => scrollY)).toBe(0);
    await bus.take(READ_33);
  }

  // On a phone.
  await page.setViewportSize({ width: 390, height: 844 });
  await bus.send('Answered.');
  await bus.waitAtMost(100);
  await bus.take('rtu/request?unitId=5&functionCode=3&startAddress=0&quantity=4');
  await bus.send('No device answered: unit 5');
  const heading = page.getByRole('heading', { name: /^No device answered/ });
  await expect(heading).toBeInViewport({ ratio: 1 });
  await expect(bus.button('Try units 1–247')).toBeInViewport({ ratio: 1 });
  expect(await new AxeBuilder(page).findings('.no-answer')).toEqual([]);

  await bus.tab('Reply');
  const search = bus.log.getByRole('combobox');
  await search.fill('05');
  await page.keyboard.press('Control+Enter');
  await expect(page.getByRole('tab', { name: 'No answer' })).toHaveAttribute('aria-selected', 'true');
  await expect(search).toBeInViewport();

  await search.fill('');
  await bus.tab('Reply');
  await bus.lines.nth(1).click();
  const panel = page.getByRole('tabpanel', { name: 'Frame' });
  await expect(panel.getByRole('button', { name: 'Request', exact: true })).toBeInViewport();
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  expect(await new AxeBuilder(page).findings()).toEqual([]);
});

test('with a thousand lines, where the language of the browser is C: the chart is drawn, leaving asks, and a reply is in sight', async ({
  page,
}) => {
  await page.addInitScript(() => {
    Object.defineProperty(Navigator.prototype, 'language', { get: () => 'C', configurable: true });
    Object.defineProperty(Navigator.prototype, 'languages', { get: () => ['C'], configurable: true });
  });
  const asked: string[] = [];
  page.on('dialog', (dialog) => {
    asked.push(dialog.type());
    void dialog.accept();
  });
  const bus = new Bus(page);
  await bus.openWithThousandLines();
  await bus.tab('Poll');
  await bus.button('Start').click();
  const poll = page.getByRole('tabpanel', { name: 'Poll' });
  await expect(poll.locator('canvas')).toBeVisible();
  const red = await poll
    .getByRole('button', { name: 'Stop' })
    .evaluate((element) => getComputedStyle(element).backgroundColor);
  expect(red).toBe(
    await page.evaluate(() => {
      const swatch = Object.assign(document.createElement('i'), { style: 'background: var(--bad)' });
      document.body.append(swatch);
      const color = getComputedStyle(swatch).backgroundColor;
      swatch.remove();
      return color;
    }),
  );
  await page.reload();
  expect(asked).toEqual(['beforeunload']);
  await bus.open(READ_33);
  await bus.tab('Reply');
  await bus.send('Answered.');
  await expect(bus.reply.getByText('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18')).toBeInViewport({ ratio: 1 });
  await page.reload();
  expect(asked).toHaveLength(1);
});
