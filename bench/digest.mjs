// `npm run bench:digest`: CRC-16/MODBUS and LRC of a large file in the Checksum view, in Chromium, against what limits it:
// reading the file without computing, and computing without reading. All take turns; the fastest round is what the rest
// of the machine disturbed least. Processor seconds are those of the whole browser, and do not depend on what else runs.
import { execFileSync } from 'node:child_process';
import { mkdtemp, open, rm } from 'node:fs/promises';
import { cpus, loadavg, tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { preview } from 'vite';
import { findInstalledBrowser } from '../scripts/find-browser.mjs';
import { Random } from './random.mjs';

const SIZE = 2 ** 30;
const BLOCK = 2 ** 22;
const ROUNDS = 3;
const TARGET = 500;
const PORT = 43928;

const npm = (...args) => execFileSync('npm', args, { stdio: 'ignore', shell: process.platform === 'win32' });
npm('run', 'build');
npm('run', 'build:lib');

/** A file of bytes of chance, in which no two blocks are the same. */
async function makeFile(path) {
  const random = new Random();
  const block = random.bytes(BLOCK);
  const file = await open(path, 'w');
  for (let at = 0; at < SIZE; at += BLOCK) {
    new DataView(block.buffer).setUint32(0, at);
    await file.write(block);
  }
  await file.close();
}

/** Runs in a worker of the page: one way to go through a part of the file, or through memory of its size. */
const worker = `
import { crc16 } from '${`http://127.0.0.1:${PORT}/lib/framewright.js`}';
const CHUNK = 2 ** 20;
const ways = {
  async given(file) {
    const reader = file.stream().getReader({ mode: 'byob' });
    for (let memory = new ArrayBuffer(CHUNK); ; ) {
      const { done, value } = await reader.read(new Uint8Array(memory));
      if (done) return;
      memory = value.buffer;
    }
  },
  async stream(file) {
    const reader = file.stream().getReader();
    while (!(await reader.read()).done);
  },
  async slices(file) {
    for (let at = 0; at < file.size; at += 16 * CHUNK) await file.slice(at, at + 16 * CHUNK).arrayBuffer();
  },
  async computing(file) {
    const bytes = new Uint8Array(16 * CHUNK).map((_, at) => at * 73);
    let register = 0xffff;
    for (let at = 0; at < file.size; at += bytes.length) register = crc16(bytes, 0, bytes.length, register);
  },
};
onmessage = async ({ data: { way, file } }) => {
  await ways[way](file);
  postMessage(way);
};`;

const folder = await mkdtemp(join(tmpdir(), 'framewright-digest-'));
const path = join(folder, 'file');
const server = await preview({ preview: { port: PORT, host: '127.0.0.1' }, logLevel: 'silent' });
const executablePath = findInstalledBrowser();
const browser = await chromium.launch({
  ...(executablePath && { executablePath }),
  args: [...(process.getuid?.() === 0 ? ['--no-sandbox'] : []), '--disable-background-networking'],
});
const session = await browser.newBrowserCDPSession();
const processorTime = async () =>
  (await session.send('SystemInfo.getProcessInfo')).processInfo.reduce((sum, { cpuTime }) => sum + cpuTime, 0);

try {
  await makeFile(path);
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${PORT}/#checksum`);
  const input = page.locator('input[type=file]').first();

  /** The view itself, as a person uses it. */
  const view = async () => {
    await input.setInputFiles(path);
    await page.getByText(/^Read and computed at/).waitFor({ timeout: 600_000 });
    await page.getByRole('button', { name: 'Close the file' }).click();
  };
  /** A way in so many workers, each with its part of the file. */
  const inWorkers = (way, count) => async () => {
    await page.evaluate(() => {
      const own = Object.assign(document.createElement('input'), { type: 'file', id: 'bench' });
      document.getElementById('bench') ?? document.body.append(own);
    });
    await page.locator('#bench').setInputFiles(path);
    await page.evaluate(
      async ({ way, count, worker }) => {
        const file = document.getElementById('bench').files[0];
        const url = URL.createObjectURL(new Blob([worker], { type: 'text/javascript' }));
        const each = Math.ceil(file.size / count);
        const parts = Array.from({ length: count }, (_, n) => file.slice(n * each, (n + 1) * each));
        await Promise.all(
          parts.map(
            (part) =>
              new Promise((resolve, reject) => {
                const one = new Worker(url, { type: 'module' });
                one.onmessage = () => resolve(one.terminate());
                one.onerror = () => reject(new Error(way));
                one.postMessage({ way, file: part });
              }),
          ),
        );
      },
      { way, count, worker },
    );
  };
  const count = await page.evaluate(() => Math.min(4, navigator.hardwareConcurrency));
  const several = `${count} workers`;
  const subjects = [
    [`The view: CRC-16/MODBUS and LRC, ${several}`, view],
    [`Reading alone, into given memory, ${several}`, inWorkers('given', count)],
    ['Reading alone, into given memory, 1 worker', inWorkers('given', 1)],
    ['Reading alone, the stream’s own memory, 1 worker', inWorkers('stream', 1)],
    ['Reading alone, slices of 16 MiB, 1 worker', inWorkers('slices', 1)],
    [`Computing alone, CRC-16/MODBUS, ${several}`, inWorkers('computing', count)],
    ['Computing alone, CRC-16/MODBUS, 1 worker', inWorkers('computing', 1)],
  ];
  const runs = subjects.map(() => ({ times: [], processor: [] }));
  for (let round = 0; round < ROUNDS; round++) {
    for (const [index, [, run]] of subjects.entries()) {
      const before = await processorTime();
      const begin = performance.now();
      await run();
      runs[index].times.push(performance.now() - begin);
      runs[index].processor.push((await processorTime()) - before);
    }
  }

  const load = loadavg()[0].toFixed(1);
  console.log(`\n${SIZE} bytes; ${browser.version()}, ${cpus().length} processors, load ${load}`);
  const columns = (...cells) =>
    console.log(cells.map((cell, i) => String(cell)[i === 0 ? 'padEnd' : 'padStart'](i === 0 ? 52 : 16)).join(''));
  columns('', 'fastest, MB/s', 'median, MB/s', 'processor, s');
  const speed = (time) => SIZE / 1000 / time;
  const middle = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];
  subjects.forEach(([name], index) => {
    const { times, processor } = runs[index];
    columns(
      name,
      speed(Math.min(...times)).toFixed(0),
      speed(middle(times)).toFixed(0),
      Math.min(...processor).toFixed(2),
    );
  });
  const best = speed(Math.min(...runs[0].times));
  console.log(
    `\nTarget ${TARGET} MB/s ${best >= TARGET ? 'met' : 'not met'} by the fastest round: ${best.toFixed(0)} MB/s`,
  );
} finally {
  await browser.close();
  await server.close();
  await rm(folder, { recursive: true });
}
process.exit(0);
