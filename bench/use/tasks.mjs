// What people come to the page for, done as a person does it, each from a fresh page, its result checked against literal bytes.

/** The frames that the WEG guide sends to its drive, with their right checksums. */
const WEG = [
  '06 06 02 AB 10 00 F5 E5',
  '06 06 02 AA 00 01 68 25',
  '06 06 02 AA 00 00 A9 E5',
  '06 03 02 A9 00 01 54 25',
];

/** @param {string} text */
const literals = (text) =>
  [...text.matchAll(/(?:0x|16#)([0-9A-F]{2})\b/gi)].map(([, digits]) => digits.toUpperCase()).join(' ');

/**
 * @typedef {object} Task
 * @property {number} number
 * @property {string} name
 * @property {{ clicks?: number, fields?: number, scrolls?: number, pastes?: number }} target the most of each
 * @property {(at: { me: import('./person.mjs').Person, page: import('@playwright/test').Page, is: (what: string, got: unknown, wanted: unknown) => void }) => Promise<unknown>} run
 */

/** @returns {Task[]} */
export function tasksOf({
  page: words,
  input,
  examples,
  bus,
  checksum,
  timing,
  oneByOne,
  stripMore,
  virtual,
  poll,
  scan,
}) {
  /** What the strip says, at once and when a frame is wrong or somebody asks for more. */
  const said = { ...words.strip, ...stripMore };
  const strip = (page) => page.getByRole('region', { name: words.page.bytes });
  const button = (page, name) => page.getByRole('button', { name, exact: typeof name === 'string' });
  const field = (page, name) => page.locator('form').getByLabel(words.labels[name] ?? name, { exact: true });
  const tab = (page, id) => page.getByRole('tab', { name: words.page.tabs.names[id], exact: true });
  const view = (page, id) =>
    page.getByRole('navigation').getByRole('link', { name: words.views.names[id], exact: true });
  const segment = (page, group, name) =>
    page
      .getByRole('group', { name: group })
      .locator('label')
      .filter({ hasText: new RegExp(`^\\s*${name}\\s*$`) });
  /** Follows a link to a frame. */
  const open = (page, link) =>
    page.evaluate((hash) => {
      location.hash = hash;
    }, link);
  /** The bytes of the strip. */
  const bytes = async (page) => {
    await page.waitForTimeout(200);
    const cells = await strip(page)
      .getByRole('button', { name: /^byte \d+,/ })
      .all();
    const names = await Promise.all(cells.map((cell) => cell.getAttribute('aria-label')));
    return names.map((name) => name?.split(', ')[1]).join(' ');
  };
  const verdict = async (page) => (await strip(page).innerText()).replace(/\s+/g, ' ');
  /** Chooses in the field of functions by typing, as one who knows the number or the name. */
  const chooseFunction = async (me, page, text) => {
    await me.type(page.locator('form').getByLabel(words.page.functionLabel, { exact: true }), text);
    await me.press('Enter');
  };
  /** Copies by a list of formats. */
  const copyAs = async (me, page, format, list) => {
    await me.click(button(page, list));
    const start = said.formats[format].replace(/[()]/g, '\\$&');
    await me.click(page.getByRole('menuitem', { name: new RegExp(`^${start}\\s`) }));
  };

  return [
    {
      number: 1,
      name: 'four frames of a drive as C and ST arrays',
      target: { clicks: 12, scrolls: 0 },
      run: async ({ me, page, is }) => {
        await me.click(button(page, input.drawer.open));
        for (const [format, sign] of [
          ['c', '0x'],
          ['st', '16#'],
        ]) {
          const text = await me.copied(() =>
            copyAs(me, page, format, new RegExp(`^Copy .*, ${examples.sources.weg}$`)),
          );
          const lines = text.split('\n').slice(0, WEG.length);
          is(`the frames as ${format}`, lines.map(literals).join(), WEG.join());
          is(
            `each is ${format}`,
            lines.every((line) => line.includes(sign)),
            true,
          );
          is('names differ', new Set(lines.map((line) => line.match(/\w+(?=\[\d| :)/)?.[0])).size, WEG.length);
        }
      },
    },
    ...[
      { crc: 'E6 A1', cause: /WEG guide prints E6 A1/ },
      { crc: 'A1 E6', cause: /WEG guide prints E6 A1.*swapped/ },
    ].map(({ crc, cause }) => ({
      number: 2,
      name: `what is wrong with … ${crc}`,
      target: { pastes: 1, clicks: 1, scrolls: 0 },
      run: async ({ me, page, is }) => {
        await me.paste(`06 06 02 AB 10 00 ${crc}`);
        const repair = strip(page).getByRole('button', { name: said.useChecksum(Uint8Array.of(0xf5, 0xe5)) });
        is('the repair is in sight', await me.sees(repair), true);
        const sentence = strip(page).locator('.cause').first();
        is('the cause is in sight', await me.sees(sentence), true);
        is('it names the misprint', cause.test(await sentence.innerText()), true);
        await me.click(repair);
        is('the frame', await bytes(page), WEG[0]);
      },
    })),
    {
      number: 3,
      name: '45 Hz into the frame of a drive',
      target: { clicks: 2, fields: 1, scrolls: 0 },
      run: async ({ me, page, is }) => {
        await open(page, 'rtu/request?unitId=6&functionCode=6&address=683&value=4096');
        await me.type(field(page, 'value'), '45 Hz');
        is('it is the frame before', (await verdict(page)).includes(said.before), true);
        await me.click(page.locator('form').getByRole('button', { name: /^Choose a device/ }));
        await me.click(
          page
            .getByRole('menuitem', { name: /^WEG drive/ })
            .or(page.getByRole('button', { name: /^WEG drive/ }))
            .first(),
        );
        await page.waitForTimeout(600);
        is('the frame', await bytes(page), '06 06 02 AB 18 00 F2 25');
      },
    },
    {
      number: 4,
      name: 'read 5 from VW800, read the reply, write 2',
      target: { pastes: 1, scrolls: 0 },
      run: async ({ me, page, is }) => {
        await chooseFunction(me, page, '3');
        await me.type(field(page, 'unitId'), '2');
        await me.type(field(page, 'startAddress'), '400');
        await me.type(field(page, 'quantity'), '5');
        await me.press('Enter');
        is('the request', await bytes(page), '02 03 01 90 00 05 84 2B');
        await page.locator('main').click({ position: { x: 2, y: 2 } });
        await me.paste('02 03 0A 00 01 00 02 00 03 00 04 00 05 CA E7');
        await strip(page).getByRole('group', { name: said.pair.label }).waitFor();
        is('it says why', (await verdict(page)).includes(said.pair.why['unit-function-length']), true);
        is('addresses are told', /40401/.test(await page.getByRole('tabpanel').first().innerText()), true);
        await me.click(segment(page, words.page.kind, words.page.kinds.request));
        await chooseFunction(me, page, '16');
        await me.type(field(page, 'startAddress'), '400');
        await me.type(field(page, 'registers'), '1 2');
        await me.press('Enter');
        is('the writing', await bytes(page), '02 10 01 90 00 02 04 00 01 00 02 28 16');
      },
    },
    ...[
      { unit: 33, range: '401000–401003', frame: '21 03 03 E7 00 04 F3 1A' },
      { unit: 17, range: '40108..40110', frame: '11 03 00 6B 00 03 76 87' },
    ].map(({ unit, range, frame }) => ({
      number: 6,
      name: `${range} of unit ${unit}`,
      target: { fields: 1, scrolls: 0 },
      run: async ({ me, page, is }) => {
        await open(page, `rtu/request?unitId=${unit}&functionCode=3&startAddress=0&quantity=1`);
        await me.type(field(page, 'startAddress'), range);
        await me.press('Enter');
        is('the frame', await bytes(page), frame);
      },
    })),
    {
      number: 7,
      name: 'TCP, unit 9, one word at 4',
      target: { scrolls: 0 },
      run: async ({ me, page, is }) => {
        await me.click(segment(page, words.page.transport, words.page.transports.tcp));
        await chooseFunction(me, page, '3');
        await me.type(field(page, 'unitId'), '9');
        await me.type(field(page, 'startAddress'), '4');
        await me.type(field(page, 'transactionId'), '0x0102');
        await me.press('Enter');
        is('the frame', await bytes(page), '01 02 00 00 00 06 09 03 00 04 00 01');
      },
    },
    {
      number: 8,
      name: 'ten coils as CD 01, 17, 2B/0E',
      target: {},
      run: async ({ me, page, is }) => {
        await chooseFunction(me, page, '15');
        await me.type(field(page, 'unitId'), '17');
        await me.type(field(page, 'startAddress'), '19');
        // As the bytes are printed, without a look at another notation, and then how many of their bits count.
        await me.type(page.locator('form').getByLabel(oneByOne.coils.asBytes, { exact: true }), 'CD 01');
        await me.press('Enter');
        await me.type(page.locator('form').getByLabel(oneByOne.coils.count, { exact: true }), '10');
        await me.press('Enter');
        is('the coils', await bytes(page), '11 0F 00 13 00 0A 02 CD 01 BF 0B');
        await chooseFunction(me, page, '17');
        is('17', await bytes(page), '11 11 CD EC');
        await chooseFunction(me, page, '0x2B/0x0E');
        is('2B/0E', (await bytes(page)).slice(0, 8), '11 2B 0E');
      },
    },
    {
      number: 9,
      name: 'the CRC of 02 07, bit by bit',
      target: { scrolls: 0 },
      run: async ({ me, page, is }) => {
        await me.click(view(page, 'checksum'));
        await me.type(page.getByLabel(checksum.labels.bytes, { exact: true }), '02 07');
        is('the CRC is in sight', await me.sees(page.getByText('41 12', { exact: true }).first()), true);
        await me.click(page.locator('summary').filter({ hasText: checksum.steps }).first());
        await page.getByText('0x813E').first().waitFor();
        is('the steps', await page.getByText('0x1241').first().isVisible(), true);
      },
    },
    {
      number: 10,
      name: 't3.5 at 9600 8N1',
      target: { scrolls: 0 },
      run: async ({ me, page, is }) => {
        await me.click(view(page, 'timing'));
        await me.type(page.getByLabel(timing.speed, { exact: true }), '9600');
        await me.choose(page.getByLabel(timing.format, { exact: true }), { label: timing.formatOption('8N1', 10) });
        is('t3.5 is in sight', await me.sees(page.getByText(/3\.646 ms/).first()), true);
      },
    },
    {
      number: 11,
      name: 'the waveform, one bit, a picture',
      target: {},
      run: async ({ me, page, is }) => {
        await me.click(tab(page, 'wire'));
        const saved = page.waitForEvent('download');
        await me.click(page.getByRole('tabpanel').getByRole('button', { name: /SVG/ }).first());
        is('a picture', (await saved).suggestedFilename().endsWith('.svg'), true);
      },
    },
    {
      number: 12,
      name: 'RTU, ASCII and TCP side by side',
      target: { clicks: 1, scrolls: 0 },
      run: async ({ me, page, is }) => {
        await open(page, 'rtu/request?unitId=6&functionCode=6&address=683&value=4096');
        await me.click(tab(page, 'compare'));
        const table = page.getByRole('tabpanel').getByRole('table').first();
        await table.waitFor();
        const text = (await table.innerText()).replace(/\s+/g, ' ');
        for (const bytes of ['F5 E5', 'RTU', 'ASCII', 'TCP']) is(bytes, text.includes(bytes), true);
      },
    },
    {
      number: 16,
      name: 'the float in a reply',
      target: { pastes: 1, fields: 1, scrolls: 0 },
      run: async ({ me, page, is }) => {
        await me.paste('01 03 04 07 7A 42 9B AB 95');
        await me.click(tab(page, 'values'));
        is(
          '77.5146 is in sight',
          await me.sees(
            page
              .getByRole('tabpanel')
              .getByText(/77\.51/)
              .first(),
          ),
          true,
        );
      },
    },
    {
      number: 16,
      name: 'the float in four bare bytes',
      target: { pastes: 1, scrolls: 0 },
      run: async ({ me, page, is }) => {
        await me.paste('07 7A 42 9B');
        await page.waitForTimeout(400);
        const offer = page.getByRole('button', { name: /register/ }).first();
        if (await offer.isVisible()) await me.click(offer);
        await me.click(tab(page, 'values'));
        is(
          '77.5146 is in sight',
          await me.sees(
            page
              .getByRole('tabpanel')
              .getByText(/77\.51/)
              .first(),
          ),
          true,
        );
      },
    },
    {
      number: 18,
      name: 'the virtual bus: send, poll, scan, sequence, a fault',
      target: {},
      run: async ({ me, page, is }) => {
        const busTab = (id) => page.getByRole('tab', { name: bus.tabs.names[id], exact: true });
        await open(page, 'rtu/request?unitId=33&functionCode=3&startAddress=999&quantity=4');
        await me.click(view(page, 'bus'));
        await me.choose(page.getByLabel(bus.pace.label), 'fast');
        await me.click(button(page, bus.virtual));
        await me.click(button(page, bus.send.send));
        await me.reach(page.getByRole('tabpanel').getByText(/12345/).first());
        const answer = (await page.getByRole('tabpanel').first().innerText()).replace(/\s+/g, ' ');
        is(
          'all values',
          ['12345', '54321', '6666', '8888'].every((value) => answer.includes(value)),
          true,
        );
        await me.click(busTab('poll'));
        await me.click(page.getByRole('tabpanel').getByRole('button', { name: poll.start ?? 'Start', exact: true }));
        await page.waitForTimeout(1500);
        await me.click(page.getByRole('tabpanel').getByRole('button', { name: /^Stop/ }).first());
        await me.click(busTab('scan'));
        await me.click(
          page
            .getByRole('tabpanel')
            .getByRole('button', { name: scan.start ?? /^Scan|^Start/ })
            .first(),
        );
        await page.waitForTimeout(800);
        await me.click(page.getByRole('tabpanel').getByRole('button', { name: /^Stop/ }).first());
        await me.click(busTab('sequence'));
        await me.click(busTab('virtual'));
        await me.choose(page.getByLabel(virtual.faults?.what ?? 'What goes wrong'), { index: 1 });
        await me.click(button(page, virtual.faults?.ask ?? 'Ask for this fault'));
        await me.click(button(page, bus.send.send));
      },
    },
    {
      number: 19,
      name: 'no answer: a path',
      target: {},
      run: async ({ me, page, is }) => {
        await open(page, 'rtu/request?unitId=7&functionCode=3&startAddress=0&quantity=1');
        await me.click(view(page, 'bus'));
        await me.choose(page.getByLabel(bus.pace.label), 'fast');
        await me.click(button(page, bus.virtual));
        await me.click(button(page, bus.send.send));
        const list = page.getByRole('tabpanel').getByRole('listitem');
        await list.first().waitFor();
        is('at least seven causes', (await list.count()) >= 7, true);
        const steps = page.getByRole('tabpanel').getByRole('button');
        is('steps to do', (await steps.count()) >= 3, true);
        await me.reach(steps.first());
      },
    },
    {
      number: 21,
      name: 'a frame by link, with its device',
      target: { clicks: 1, scrolls: 0 },
      run: async ({ me, page, is }) => {
        await open(
          page,
          'rtu/request?v=2&unitId=6&functionCode=6&address=683&value=4096&typed.address=P0683&typed.value=30+Hz&device=weg-drive',
        );
        await page.waitForTimeout(600);
        const link = await me.copied(() => me.click(button(page, said.link)));
        const other = await page.context().browser().newContext();
        const there = await other.newPage();
        await there.goto(link);
        await there.waitForTimeout(1500);
        is('the frame', await bytes(there), WEG[0]);
        is('the name', /P0683/.test(await verdict(there)), true);
        await other.close();
      },
    },
  ];
}
