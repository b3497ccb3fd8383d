// What the page can look like: every view in each of its states, made as a person makes them.

const SPEED = 'rtu/request?unitId=6&functionCode=6&address=683&value=4096';
const READ_5 = 'rtu/request?unitId=2&functionCode=3&startAddress=400&quantity=5';
const LONG = `rtu/request?unitId=1&functionCode=16&startAddress=100&registers=${Array.from({ length: 123 }, (_, at) => 1000 + at).join('+')}`;
const COILS = 'rtu/request?unitId=17&functionCode=15&startAddress=19&values=1011001110';
const MISPRINT = '06 06 02 AB 10 00 E6 A1';

/**
 * @typedef {import('@playwright/test').Page} Page
 * @typedef {object} State
 * @property {string} name
 * @property {string} [at] what stands behind # when it is opened
 * @property {boolean} [first] whether the first fields and the open tab are to be in sight
 * @property {boolean} [focus] whether each control is given the focus once
 * @property {(page: Page) => Promise<unknown>} [act]
 */

/** Puts a text into the one input, from wherever the focus is. */
async function put(page, text) {
  await page.keyboard.press('Control+K');
  await page.locator('textarea:focus, input:focus').fill(text);
}

const button = (page, name) => page.getByRole('button', { name, exact: typeof name === 'string' });

/** @returns {{ view: string, states: State[] }[]} */
export function viewsOf({ page: words, input, bus, checksum, compare, program, reference }) {
  const tabs = Object.keys(words.page.tabs.names);
  const frame = [
    { name: 'fresh', first: true, focus: true },
    { name: 'good', at: SPEED, first: true, focus: true },
    { name: 'wrong CRC', at: SPEED, first: true, focus: true, act: (page) => put(page, MISPRINT) },
    { name: 'doubtful', at: 'rtu/request?unitId=250&functionCode=3&startAddress=0&quantity=1' },
    { name: 'open number', at: 'rtu/request?unitId=17&functionCode=3&startAddress=40108&quantity=3' },
    { name: 'no bytes', at: SPEED, act: (page) => put(page, 'hello world') },
    {
      name: 'no number',
      at: SPEED,
      focus: true,
      act: (page) => page.getByLabel(words.labels.value, { exact: true }).first().fill('45 Hz'),
    },
    { name: 'lit', at: SPEED, act: (page) => page.getByRole('button', { name: /^byte 3,/ }).hover() },
    {
      name: 'byte typed',
      at: SPEED,
      act: async (page) => {
        await page.getByRole('button', { name: /^byte 3,/ }).focus();
        await page.keyboard.press('Enter');
      },
    },
    { name: 'bare numbers', act: (page) => put(page, '07 7A 42 9B') },
    { name: 'manual number', act: (page) => put(page, '40108') },
    { name: 'value and unit', act: (page) => put(page, 'P0683 30 Hz') },
    { name: 'long', at: LONG, focus: true },
    { name: 'coils', at: COILS },
    { name: 'identification', at: 'rtu/request?unitId=1&functionCode=43&meiType=14' },
    { name: 'exception', at: 'rtu/exception?unitId=6&functionCode=3&exceptionCode=2' },
    { name: 'ASCII', at: SPEED.replace('rtu', 'ascii') },
    { name: 'TCP', at: SPEED.replace('rtu', 'tcp') },
    { name: 'pair', at: READ_5, act: (page) => put(page, '02 03 0A 00 01 00 02 00 03 00 04 00 05 CA E7') },
    { name: 'device', at: `${SPEED}&v=2&typed.address=P0683&typed.value=30+Hz&device=weg-drive` },
    { name: 'broken link', at: 'rtu/request?functionCode=3&nonsense=1' },
    { name: 'drawer', focus: true, act: (page) => button(page, input.drawer.open).click() },
    { name: 'keys', act: (page) => page.locator('body').press('?') },
    ...tabs.flatMap((tab) => [
      { name: `tab ${tab}`, at: `${SPEED}&v=3&tab=${tab}`, focus: true },
      { name: `tab ${tab}, reply`, at: `rtu/reply?unitId=1&functionCode=3&registers=1914+17051+1+2&v=3&tab=${tab}` },
    ]),
    {
      name: 'program, its options',
      at: `${SPEED}&v=5&tab=program&program=ladder.exchange`,
      focus: true,
      act: (page) => page.locator('.program-options summary').click(),
    },
    {
      name: 'program, the listing of a guide',
      at: `${SPEED}&v=5&tab=program&program=structured-text.build`,
      act: (page) => button(page, program.listing.open).click(),
    },
    {
      name: 'compared',
      at: `${SPEED}&v=3&tab=compare`,
      act: (page) => page.getByLabel(compare.sent, { exact: true }).fill(MISPRINT),
    },
  ];

  const onLog = [
    { name: 'empty', at: 'log' },
    { name: 'demo', focus: true, act: (page) => button(page, input.chips['faulty-log']).click() },
    { name: 'frame', at: 'log?log=demo&row=93', focus: true },
    { name: 'exchanges, filtered', at: 'log?log=demo&rows=exchange&filter=fault' },
    { name: 'mistakes', at: 'log?log=demo&row=999&filter=unti%3A6&tab=none' },
    { name: 'gone', at: 'log?log=pasted&filter=crc' },
    ...['timeline', 'statistics', 'values'].map((tab) => ({ name: tab, at: `log?log=demo&tab=${tab}`, focus: true })),
  ];

  /** Connects to the virtual bus, which answers at once. */
  const connected = async (page) => {
    await page.getByLabel(bus.pace.label).selectOption('fast');
    await button(page, bus.virtual).click();
    await button(page, bus.disconnect).waitFor();
  };
  const toBus = async (page, hash) => {
    await page.evaluate((link) => {
      location.hash = link;
    }, hash);
    await page.getByRole('navigation').getByRole('link', { name: words.views.names.bus }).click();
    await connected(page);
  };
  const sent = (unit) => async (page) => {
    await toBus(page, `rtu/request?unitId=${unit}&functionCode=3&startAddress=0&quantity=4`);
    await button(page, bus.send.send).click();
    await page.waitForTimeout(1500);
  };
  const onBus = [
    { name: 'closed', at: 'bus' },
    { name: 'connected', at: 'bus', act: connected },
    { name: 'answered', at: 'bus', act: sent(33) },
    { name: 'no answer', at: 'bus', act: sent(99) },
    {
      name: 'question',
      act: async (page) => {
        await toBus(page, SPEED);
        const readOnly = page.getByLabel(bus.guard.readOnly);
        if (await readOnly.isChecked()) await readOnly.uncheck();
        await button(page, bus.send.send).click();
      },
    },
    ...Object.entries(bus.tabs.names).flatMap(([id, name]) => [
      { name: `tab ${id}, closed`, at: `bus?tab=${id}` },
      {
        name: `tab ${id}`,
        at: 'bus',
        act: async (page) => {
          await connected(page);
          await page.getByRole('tab', { name, exact: true }).click();
        },
      },
    ]),
  ];

  const unfold = (title) => (page) => page.locator('summary').filter({ hasText: title }).first().click();
  const folds = ['steps', 'which', 'ownTitle', 'card'];
  const onChecksum = [
    { name: 'fresh', at: 'checksum' },
    ...folds.map((name) => ({ name, at: 'checksum', act: unfold(checksum[name]) })),
    { name: 'no bytes', at: 'checksum', act: (page) => page.getByLabel(checksum.labels.bytes).fill('hello world') },
  ];
  const onTiming = [
    { name: 'fresh', at: 'timing' },
    { name: 'wrong', at: 'timing', act: (page) => page.locator('main input:not([type=radio])').first().fill('fast') },
  ];
  const search = (text) => (page) => page.getByLabel(reference.search).fill(text);
  const onReference = [
    { name: 'fresh', at: 'reference' },
    { name: 'searched', at: 'reference', act: search('16') },
    { name: 'nothing found', at: 'reference', act: search('zzz') },
  ];
  return [
    { view: 'frame', states: frame },
    { view: 'log', states: onLog },
    { view: 'bus', states: onBus },
    { view: 'checksum', states: onChecksum },
    { view: 'timing', states: onTiming },
    { view: 'reference', states: onReference },
  ];
}
