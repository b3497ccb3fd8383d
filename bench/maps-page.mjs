// `npm run bench:maps-page`: a register map of 20,000 rows in the built page, in Chromium: from the chosen file to the painted
// table, the search, a keystroke in the frame with and without the map in turn, and ten such maps kept and loaded again. Frames are
// drawn as soon as they can be. ROWS changes the number of rows, BUILT=1 takes the page as it is built.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { launch, load, modulesOfThePage, printTable, servePage, waitForCalm } from './built-page.mjs';
import { keystrokes } from './keystrokes.mjs';
import { quantile } from './quantile.mjs';

const ROWS = Number(process.env.ROWS ?? 20_000);
const MAPS = 10;
const KEYSTROKES = 40;
const TURNS = 6;
const FRAME = '#rtu/reply?unitId=1&functionCode=3&registers=490&answering=0103044C0001F12D';

const types = ['uint16', 'int16', 'float32', 'uint32'];
const rows = Array.from({ length: ROWS }, (_, at) =>
  [
    `Zone ${at % 400} temperature ${at}`,
    (at * 2) % 65_536,
    at % 3 === 0 ? 4 : 3,
    types[at % 4],
    at % 2 ? '°C' : 'V',
    at % 4 ? '0.1' : '1',
    at % 2 || at % 3 === 0 ? 'R' : 'RW',
    `Value number ${at} of the plant, as measured`,
  ].join(';'),
);
const csv = ['Name;Register;Function;Type;Unit;Factor;Access;Description', ...rows].join('\n');
const folder = mkdtempSync(join(tmpdir(), 'framewright-'));
/** Files on a disk: a buffer would be decoded in the page, which would be measured. */
const file = (name) => {
  const path = join(folder, name);
  writeFileSync(path, csv);
  return path;
};

const server = await servePage();
const { words } = await modulesOfThePage();
const { library } = words;
const browser = await launch({ args: ['--disable-frame-rate-limit', '--disable-gpu-vsync'] });
const context = await browser.newContext({ viewport: { width: 1280, height: 900 } });
const page = await context.newPage();
await waitForCalm();

/** Milliseconds from a choice or a click to the first task after the frame that has what `selector` finds. */
async function untilPainted(act, selector) {
  const painted = page.evaluate(
    (wanted) =>
      new Promise((done) => {
        let from;
        const begin = ({ timeStamp }) => {
          from ??= timeStamp;
        };
        for (const kind of ['change', 'click']) document.addEventListener(kind, begin, { capture: true, once: true });
        const look = () => {
          if (from === undefined || !document.querySelector(wanted)) return requestAnimationFrame(look);
          requestAnimationFrame(() => {
            const { port1, port2 } = new MessageChannel();
            port1.onmessage = () => done(performance.now() - from);
            port2.postMessage(undefined);
          });
        };
        look();
      }),
    selector,
  );
  await act();
  return painted;
}

/** The longest task of the window while something is done, in milliseconds that the processor worked for it. */
async function longestTask(act) {
  await browser.startTracing(page, { categories: ['disabled-by-default-devtools.timeline', '__metadata'] });
  const time = await act();
  await page.waitForTimeout(500);
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  const thread = ({ pid, tid }) => `${pid} ${tid}`;
  const isWindow = new Set(traceEvents.filter(({ args }) => args?.name === 'CrRendererMain').map(thread));
  const tasks = traceEvents.filter((event) => event.name === 'RunTask' && isWindow.has(thread(event)));
  return { time, longest: Math.max(...tasks.map(({ tdur = 0 }) => tdur)) / 1000 };
}

const report = [];
const add = (what, times, target) => {
  const [least, median, high] = [0, 0.5, 0.95].map((share) => quantile(times, share));
  report.push([what, ...[least, median, high].map((time) => time.toFixed(1)), target ?? '']);
};

const assistant = page.getByRole('region', { name: /^Import of / });
const fileTimes = [];
const fileTasks = [];
const keepTimes = [];
const keepTasks = [];
await page.goto(`${server.address}#devices`);
for (let n = 1; n <= MAPS; n++) {
  await page.getByLabel(library.chooseFile).waitFor();
  const chosen = await longestTask(() =>
    untilPainted(
      () => page.getByLabel(library.chooseFile).setInputFiles(file(`Plant ${n}.csv`)),
      '.assistant table tbody tr',
    ),
  );
  fileTimes.push(chosen.time);
  fileTasks.push(chosen.longest);
  const kept = await longestTask(() =>
    untilPainted(
      () => assistant.getByRole('button', { name: library.keep, exact: true }).click(),
      'main:not(:has(.assistant)) .device-registers tbody tr',
    ),
  );
  keepTimes.push(kept.time);
  keepTasks.push(kept.longest);
}
add('file chosen to painted table', fileTimes, 1500);
add('  longest task of the window (processor)', fileTasks, 50);
add('imported to painted map', keepTimes);
add('  longest task of the window (processor)', keepTasks, 50);

const ofMap = page.locator('#device-search');
const letters = [...'zone 17', ...Array(7).fill('Backspace')];
add('search in the map', await keystrokes(page, ofMap, letters, 3 * letters.length), 30);
add('search in the library', await keystrokes(page, page.locator('#library-search'), letters, 3 * letters.length), '');

// The writes are done when a page that is opened now has all of them.
const buttons = page.getByRole('region', { name: library.profiles }).getByRole('button', { name: /^Plant / });
const reloads = [];
for (let n = 0; n < 3; n++) {
  await page.reload();
  const start = Date.now();
  await page.waitForFunction(
    (maps) =>
      [...document.querySelectorAll('.library button')].filter((one) => /^Plant/.test(one.textContent)).length === maps,
    MAPS,
  );
  reloads.push(Date.now() - start);
}
add(`reloaded to all ${MAPS} maps in the library`, reloads);
const { usage } = await page.evaluate(() => navigator.storage.estimate());

const other = await (await browser.newContext({ viewport: { width: 1280, height: 900 } })).newPage();
const times = { with: [], without: [] };
await page.goto(`${server.address}${FRAME}`);
await page.reload();
await other.goto(`${server.address}${FRAME}`);
for (const each of [page, other]) await each.getByLabel('Registers', { exact: true }).waitFor();
await page
  .getByText(/Zone \d+ temperature/)
  .first()
  .waitFor();
for (let turn = 0; turn < TURNS; turn++)
  for (const [which, each] of [
    ['with', page],
    ['without', other],
  ]) {
    await each.bringToFront();
    times[which].push(...(await keystrokes(each, 'Registers', ['1', 'Backspace'], KEYSTROKES)).slice(5));
  }
add('keystroke in the frame, with the map', times.with);
add('keystroke in the frame, without a map', times.without);

printTable([['milliseconds', 'least', 'median', '95 %', 'target'], ...report]);
console.log(
  `${await buttonsCount()} maps of ${ROWS} rows; ${(usage / 2 ** 20).toFixed(0)} MB kept by the browser; load of the machine ${load().toFixed(1)}`,
);
rmSync(folder, { recursive: true });
await browser.close();
server.close();

async function buttonsCount() {
  await page.bringToFront();
  await page.goto(`${server.address}#devices`);
  await buttons.nth(MAPS - 1).waitFor();
  return buttons.count();
}
