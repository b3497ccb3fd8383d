// `npm run bench:capture`: how fast a capture of a million Modbus packets is read and traced, in turns with tshark on the same file.
// `npm run bench:capture -- FOLDER`: what is counted in the captures of a folder, beside what tshark counts in them.
import { execFile } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { performance } from 'node:perf_hooks';
import { promisify } from 'node:util';
import { runScript } from '../scripts/run.mjs';
import { millionPackets } from './million-packets.mjs';
import { quantile } from './quantile.mjs';

const run = promisify(execFile);
const TURNS = 5;
const TARGET = 500_000;
const TIMES_TSHARK = 4.5;
const MEGABYTE = 1e6;

if ((await runScript('build:lib')) !== 0) process.exit(1);
const { readCapture, traceOf } = await import('../dist/lib/framewright.js');

const hasTshark = await run('tshark', ['--version']).then(
  () => true,
  () => false,
);
if (!hasTshark) console.log('tshark is not installed (Debian: apt-get install tshark): nothing is compared with it.\n');

/** Every function code and exception that tshark finds, but in segments that are sent again. */
async function tshark(file) {
  const { stdout } = await run(
    'tshark',
    [
      ...['-r', file, '-Y', 'modbus && !tcp.analysis.retransmission', '-T', 'fields', '-E', 'occurrence=a'],
      ...['-e', 'modbus.func_code', '-e', 'modbus.exception_code'],
    ],
    { maxBuffer: 1 << 30 },
  );
  const cells = stdout.split('\n').map((line) => line.split('\t'));
  const list = (column) => cells.flatMap((line) => (line[column] ?? '').split(',').filter(Boolean));
  return { codes: list(0).map(Number), exceptions: list(1).length };
}

function ours(records) {
  const codes = Array.from(records, ({ bytes, transport }) => bytes[transport === 'tcp' ? 7 : 1] ?? 0);
  return { codes: codes.map((code) => code & 0x7f), exceptions: codes.filter((code) => code > 0x7f).length };
}

function byFunction(codes) {
  const counts = new Map();
  for (const code of codes) counts.set(code, (counts.get(code) ?? 0) + 1);
  const sorted = [...counts].sort(([one], [other]) => one - other);
  return sorted.length > 8
    ? `${sorted.length} functions`
    : sorted.map(([code, count]) => `${code}: ${count}`).join(', ');
}

const [folder] = process.argv.slice(2);
if (folder !== undefined) await countFolder(folder);
else await timeMillion();

async function countFolder(path) {
  const files = readdirSync(path, { recursive: true, encoding: 'utf8' }).filter((file) =>
    /\.(?:pcap|pcapng|cap)$/.test(file),
  );
  for (const file of files.sort()) {
    const { format, records, problems } = readCapture(new Uint8Array(readFileSync(join(path, file))));
    const { faults, units, exchanges } = traceOf(records).summary();
    const own = ours(records);
    console.log(`${file} (${format})`);
    const print = (who, { codes, exceptions }) =>
      console.log(
        `  ${who.padEnd(11)} ${String(codes.length).padStart(7)} frames, ${exceptions} exceptions; ${byFunction(codes)}`,
      );
    print('framewright', own);
    if (hasTshark) print('tshark', await tshark(join(path, file)));
    const kinds = Object.entries(faults).flatMap(([kind, count]) => (count > 0 ? [`${kind} ${count}`] : []));
    console.log(`  ${exchanges} exchanges, units ${units.join(' ')}; ${kinds.join(', ') || 'no fault'}`);
    const codes = byCode(problems);
    if (codes !== '') console.log(`  not read: ${codes}`);
  }
}

function byCode(problems) {
  const counts = new Map();
  for (const { code } of problems) counts.set(code, (counts.get(code) ?? 0) + 1);
  return [...counts].map(([code, count]) => `${code} ${count}`).join(', ');
}

async function timeMillion() {
  const place = mkdtempSync(join(tmpdir(), 'framewright-capture-'));
  const file = join(place, 'million.pcap');
  const bytes = millionPackets();
  writeFileSync(file, bytes);
  console.log(
    `${(bytes.length / MEGABYTE).toFixed(0)} MB, 1,000,000 packets with Modbus, 20 connections, ${TURNS} turns.\n`,
  );
  const read = [];
  const traced = [];
  const theirs = [];
  let memory = 0;
  for (let turn = 0; turn < TURNS; turn++) {
    const start = performance.now();
    const { records } = readCapture(bytes);
    const middle = performance.now();
    const { frames } = traceOf(records).summary();
    traced.push(performance.now() - start);
    read.push(middle - start);
    memory = Math.max(memory, process.memoryUsage().rss);
    if (frames !== 1_000_000) throw new Error(`${frames} frames`);
    if (!hasTshark || turn >= 2) continue;
    const before = performance.now();
    const { codes } = await tshark(file);
    theirs.push(performance.now() - before);
    if (codes.length !== 1_000_000) throw new Error(`tshark: ${codes.length} frames`);
  }
  rmSync(place, { recursive: true });
  const rate = (times) => 1e9 / quantile(times, 0.5);
  const row = (name, times, note = '') =>
    console.log(
      `${name.padEnd(28)} ${(quantile(times, 0.5) / 1000).toFixed(2).padStart(7)} s ${Math.round(rate(times)).toLocaleString('en').padStart(12)} packets/s  ${note}`,
    );
  row('read and put together', read, rate(read) >= TARGET ? '' : `below ${TARGET}`);
  row('with trace and summary', traced, quantile(traced, 0.5) <= 5000 ? '' : 'above 5 s');
  if (theirs.length > 0) {
    const times = rate(read) / rate(theirs);
    row(
      'tshark',
      theirs,
      `we read ${times.toFixed(1)} times as fast${times >= TIMES_TSHARK ? '' : `, below ${TIMES_TSHARK}`}`,
    );
  }
  console.log(
    `\nMemory of the process at most ${(memory / MEGABYTE).toFixed(0)} MB, the file ${(bytes.length / MEGABYTE).toFixed(0)} MB.`,
  );
}
