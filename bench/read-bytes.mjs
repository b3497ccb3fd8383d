// How fast pasted text is read: 1 MB of the logs that people have, and 10 MB of text that is no log at all.
import { performance } from 'node:perf_hooks';
import { runScript } from '../scripts/run.mjs';
import { quantile } from './quantile.mjs';
import { Random } from './random.mjs';

const LOG = 1e6;
const NOISE = 10e6;
const SAMPLES = 5;

if ((await runScript('build:lib')) !== 0) process.exit(1);
const { readBytes } = await import('../dist/lib/framewright.js');

/** Lines until there are so many characters. */
function lines(length, line) {
  const all = [];
  for (let size = 0, index = 0; size < length; index++) {
    const next = `${line(index)}\n`;
    all.push(next);
    size += next.length;
  }
  return all.join('');
}

function noise(length, characters) {
  const random = new Random();
  return Array.from({ length }, () => characters[random.next() % characters.length]).join('');
}

const clock = (index) => `10:${String(10 + (index % 50))}:12:${100 + (index % 900)}`;
const offset = (index) => (16 * index).toString(16).padStart(8, '0');
const printable = Array.from({ length: 95 }, (_, i) => String.fromCharCode(0x20 + i));

const texts = [
  ['QModMaster', lines(LOG, (i) => `[RTU]>Tx > ${clock(i)} - 01  03  00  00  00  0A  C5  CD`)],
  [
    'pymodbus',
    lines(LOG, () => '2024-01-02 10:31:12,316 DEBUG transaction :140 SEND: 0x1 0x3 0x0 0x0 0x0 0xa 0xc5 0xcd'),
  ],
  ['ESPHome', lines(LOG, () => '[10:31:12][D][uart_debug:114]: >>> 01:03:00:00:00:0A:C5:CD')],
  [
    'hexdump -C',
    lines(LOG, (i) => `${offset(i)}  01 03 00 00 00 0a c5 cd  3a 30 31 30 33 30 30 30  |........:0103000|`),
  ],
  ['decimal lists', lines(LOG, () => '1, 3, 0, 0, 0, 10, 197, 205')],
  ['ASCII frames', lines(LOG, () => ':010300000001FB')],
  ['hexadecimal', lines(LOG, () => '01 03 00 00 00 0A C5 CD')],
  ['a digit a line', '1\n'.repeat(NOISE / 2)],
  ['a digit a line, by CR', '1\r'.repeat(NOISE / 2)],
  ['random characters', noise(NOISE, printable)],
  ['random lines', noise(NOISE, [...printable, '\n'])],
  ['random digits', noise(NOISE, [...'0123456789ABCDEF :,.\n'])],
];

for (const [name, text] of texts) {
  const times = [];
  for (let i = 0; i < SAMPLES; i++) {
    const start = performance.now();
    readBytes(text);
    times.push(performance.now() - start);
  }
  const time = quantile(times, 0.5);
  const [size, speed] = [text.length / 1e6, text.length / 1e3 / time];
  console.log(
    `${name.padEnd(20)} ${size.toFixed(0).padStart(2)} MB ${time.toFixed(0).padStart(6)} ms ${speed.toFixed(1).padStart(6)} MB/s`,
  );
}
